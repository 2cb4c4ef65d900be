#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace zenosphere {

/// Bytes as a text in base64, padded with `=`. Source: RFC 4648, section 4.
///
/// Pieces of multiples of three bytes, one behind the other, give the text of the whole.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace zenosphere
