#pragma once

#include <cstdint>
#include <span>

namespace zenosphere {

/// CRC-32C of bytes: tells a record that was written whole from one that was not.
///
/// \param before  the checksum of the bytes before these, if they come in parts
/// Source: Castagnoli, Brauer & Herrmann, IEEE Trans. Commun. 41 (1993) 883; by the
/// instructions of SSE 4.2 where there are any, three streams at once (Gopal et al., "Fast CRC
/// Computation for iSCSI Polynomial Using CRC32 Instruction", Intel 2011), else eight bytes a step
/// as in Kounavis & Berry, IEEE Trans. Comput. 57 (2008) 1550.
std::uint32_t checksum(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

/// The same without the processor's instructions for it.
std::uint32_t checksum_by_tables(std::span<const std::uint8_t> bytes, std::uint32_t before = 0);

}  // namespace zenosphere
