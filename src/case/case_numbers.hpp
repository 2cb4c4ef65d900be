#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace zenosphere::case_format {

/// A number that TOML does not take, or that no number of the program is near to.
struct WrongNumber {
  std::size_t at;         ///< byte of the text where it begins
  std::string objection;  ///< `.3 (needs a digit in front of the point); write 0.3`
};

/// The first number of a TOML text that is written wrong, beyond the range of its kind or, other
/// than 0, so near to it that it would be read as 0; nothing if there is none.
std::optional<WrongNumber> first_wrong_number(std::string_view text);

/// What is wrong with one number, as in WrongNumber; nothing if it is right or no decimal number.
std::optional<std::string> number_objection(std::string_view word);

}  // namespace zenosphere::case_format
