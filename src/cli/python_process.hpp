#pragma once

#include <string>
#include <vector>

namespace zenosphere {

/// Becomes `python3 -m zenosphere COMMAND WORDS...`, with this program's package before any other.
///
/// Returns only by throwing: InputError where the interpreter cannot be started.
[[noreturn]] void become_python(const std::string& command, const std::vector<std::string>& words);

}  // namespace zenosphere
