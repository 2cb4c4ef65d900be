#include "storage/checksum.hpp"

#if defined(__x86_64__)
#include <nmmintrin.h>
#endif

#include <array>
#include <bit>
#include <cstring>

namespace zenosphere {
namespace {

constexpr std::uint32_t polynomial = 0x82f63b78;  // Castagnoli's, bits reversed

using Table = std::array<std::array<std::uint32_t, 256>, 8>;

/// tables[k][b]: what the byte b does to the checksum when k more bytes follow it.
constexpr Table make_tables() {
  Table tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1) != 0 ? polynomial : 0);
    tables[0][byte] = value;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t value = tables[k - 1][byte];
      tables[k][byte] = (value >> 8) ^ tables[0][value & 0xff];
    }
  }
  return tables;
}

constexpr Table tables = make_tables();

#if defined(__x86_64__)
/// Bytes of each of the three parts that are done at once: an instruction waits three cycles for
/// the one before, but not for those of other parts.
constexpr std::size_t part_size = 2048;

/// after_part[k][b]: what the byte k of a checksum, b, becomes behind a part of zeros. Checksums
/// add up (exclusive or): that of three parts is made of those of each among zeros.
constexpr auto make_after_part() {
  std::array<std::uint32_t, 32> of_bit{};
  for (std::size_t bit = 0; bit < of_bit.size(); ++bit) {
    std::uint32_t value = std::uint32_t{1} << bit;
    for (std::size_t n = 0; n < part_size; ++n) value = (value >> 8) ^ tables[0][value & 0xff];
    of_bit[bit] = value;
  }
  std::array<std::array<std::uint32_t, 256>, 4> result{};
  for (std::size_t entry = 0; entry < 4 * 256; ++entry) {
    for (std::size_t bit = 0; bit < 8; ++bit) {
      const bool is_set = (entry >> bit & 1) != 0;
      if (is_set) result[entry / 256][entry % 256] ^= of_bit[8 * (entry / 256) + bit];
    }
  }
  return result;
}

constexpr auto after_part = make_after_part();

std::uint64_t behind_a_part(std::uint64_t value) {
  std::uint32_t result = 0;
  for (std::size_t k = 0; k < 4; ++k) result ^= after_part[k][(value >> (8 * k)) & 0xff];
  return result;
}

std::uint64_t word_at(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

__attribute__((target("sse4.2"))) std::uint32_t checksum_by_instructions(
    std::span<const std::uint8_t> bytes, std::uint32_t before) {
  std::uint64_t value = ~before;
  for (; bytes.size() >= 3 * part_size; bytes = bytes.subspan(3 * part_size)) {
    std::uint64_t second = 0, third = 0;
    for (const auto* at = bytes.data(); at < bytes.data() + part_size; at += 8) {
      value = _mm_crc32_u64(value, word_at(at));
      second = _mm_crc32_u64(second, word_at(at + part_size));
      third = _mm_crc32_u64(third, word_at(at + 2 * part_size));
    }
    value = behind_a_part(behind_a_part(value) ^ second) ^ third;
  }
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    value = _mm_crc32_u64(value, word_at(bytes.data()));
  }
  auto last = static_cast<std::uint32_t>(value);
  for (const std::uint8_t byte : bytes) last = _mm_crc32_u8(last, byte);
  return ~last;
}
#endif

}  // namespace

std::uint32_t checksum(std::span<const std::uint8_t> bytes, std::uint32_t before) {
#if defined(__x86_64__)
  static const bool has_instructions = __builtin_cpu_supports("sse4.2") != 0;
  if (has_instructions) return checksum_by_instructions(bytes, before);
#endif
  return checksum_by_tables(bytes, before);
}

std::uint32_t checksum_by_tables(std::span<const std::uint8_t> bytes, std::uint32_t before) {
  static_assert(std::endian::native == std::endian::little);
  std::uint32_t value = ~before;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof word);
    word ^= value;
    value = 0;
    for (std::size_t k = 0; k < 8; ++k) value ^= tables[7 - k][(word >> (8 * k)) & 0xff];
  }
  for (const std::uint8_t byte : bytes) value = (value >> 8) ^ tables[0][(value ^ byte) & 0xff];
  return ~value;
}

}  // namespace zenosphere
