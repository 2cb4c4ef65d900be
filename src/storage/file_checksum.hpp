#pragma once

#include <cstdint>

#include "storage/durable.hpp"

namespace zenosphere {

/// CRC-32C of the first `size` bytes of a file. Throws SystemError.
std::uint32_t file_checksum(const FileDescriptor& file, std::uint64_t size);

}  // namespace zenosphere
