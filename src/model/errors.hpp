#pragma once

#include <stdexcept>

namespace zenosphere {

/// The user's input is wrong. The text follows `where: problem (why); what you can do`.
/// Exit code 2.
class InputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The world is in the way: a disk, a file, a database. Exit code 4.
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace zenosphere
