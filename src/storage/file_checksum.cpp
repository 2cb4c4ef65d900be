#include "storage/file_checksum.hpp"

#include <algorithm>

#include "storage/checksum.hpp"

namespace zenosphere {

std::uint32_t file_checksum(const FileDescriptor& file, std::uint64_t size) {
  constexpr std::uint64_t bytes_at_once = 1 << 20;
  std::uint32_t sum = 0;
  for (std::uint64_t offset = 0; offset < size; offset += bytes_at_once) {
    sum = checksum(read_at(file, offset, std::min(bytes_at_once, size - offset)), sum);
  }
  return sum;
}

}  // namespace zenosphere
