#pragma once

#include <cstdint>
#include <span>

namespace zenosphere {

/// CRC-32C of bytes: tells a record that was written whole from one that was not.
///
/// \param before  the checksum of the bytes before these, if they come in parts
/// Source: Castagnoli, Brauer & Herrmann, IEEE Trans. Commun. 41 (1993) 883; eight bytes a step
/// as in Kounavis & Berry, IEEE Trans. Comput. 57 (2008) 1550.
std::uint32_t checksum(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

}  // namespace zenosphere
