#pragma once

#include <span>
#include <string>

#include "case/case.hpp"

namespace zenosphere {

/// The case of a file that the user has named; `-` is the standard input.
///
/// Names of files in a case from the standard input are from the current folder.
/// Throws InputError as read_case does.
Case case_from(const std::string& file, std::span<const std::string> overrides);

}  // namespace zenosphere
