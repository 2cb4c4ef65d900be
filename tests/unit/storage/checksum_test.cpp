#include "storage/checksum.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace zenosphere {
namespace {

TEST(Checksum, OfTheNineDigitsIsThatOfTheStandard) {
  const char* const digits = "123456789";
  const std::vector<std::uint8_t> bytes(digits, digits + std::strlen(digits));
  EXPECT_EQ(checksum(bytes), 0xe3069283u);  // RFC 3720, as the check value of CRC-32C
  EXPECT_EQ(checksum_by_tables(bytes), 0xe3069283u);
}

TEST(Checksum, IsTheSameByTablesAndInParts) {
  std::vector<std::uint8_t> bytes;
  for (int n = 0; n < 300; ++n) {
    EXPECT_EQ(checksum(bytes), checksum_by_tables(bytes)) << n;
    const std::span<const std::uint8_t> all = bytes;
    const std::size_t middle = bytes.size() / 3;
    EXPECT_EQ(checksum(all.subspan(middle), checksum(all.first(middle))), checksum(bytes)) << n;
    const std::size_t more = n < 100 ? 1 : 97;  // beyond what is done three parts at once
    for (std::size_t k = 0; k < more; ++k) bytes.push_back(static_cast<std::uint8_t>(37 * n + k));
  }
}

}  // namespace
}  // namespace zenosphere
