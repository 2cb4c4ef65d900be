#pragma once

#include <cstdint>
#include <string>

namespace zenosphere {

/// The case file of one run of a sweep: `zenosphere run` does with it what the sweep does.
///
/// A store is asked for the run of that number; a sweep file for the one that it would have in a
/// store that was begun with it as it is.
///
/// \param file  a sweep file or a store
/// Throws InputError where there is no such run.
std::string case_text_of_run(const std::string& file, std::int64_t run);

}  // namespace zenosphere
