#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class Validator;
}

namespace zenosphere {

// Checks of what is typed for an option, before it is read. Each throws InputError as the case
// reader does: `--every = 0 (must be a whole number in [1, 1024])`.

/// \param option  for the message: `--every`
CLI::Validator whole_number(const std::string& option, std::int64_t low, std::int64_t high);
CLI::Validator positive_number(const std::string& option);
/// Its name is the words with commas between them.
CLI::Validator one_of(const std::string& option, std::vector<std::string> words);

/// Refuses nothing: only tells completion and manual some of the words that are good.
CLI::Validator such_as(const std::vector<std::string>& words);

/// Whole numbers that a `double` holds, for counts that have no other limit.
inline constexpr std::int64_t most_typed = std::int64_t{1} << 53;

/// `a, b or c`.
std::string alternatives(const std::vector<std::string>& words);

}  // namespace zenosphere
