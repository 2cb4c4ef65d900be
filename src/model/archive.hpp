#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/real.hpp"

/// States as bytes, and back without a bit lost: what checkpoints are made of.
///
/// A class lists what its state is once, for writing and reading alike:
///
///     template <class Self, class Archive>
///     static void archive_state(Self& self, Archive& archive) {
///       archive(self.now_, self.collisions_);
///     }
///
/// Numbers are little-endian; a `long double` takes its 10 significant bytes, a `Quad` 16, a
/// `Digits` 6 and 4 for each 32 bits. Texts and vectors begin with their length in 8 bytes.
namespace zenosphere {

using Bytes = std::vector<std::uint8_t>;

/// Bytes that are no archive of what was asked for: too few, too many, or nonsense.
class ArchiveError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws ArchiveError unless something holds that every archive fulfils.
inline void require_archived(bool holds, const char* what) {
  if (!holds) throw ArchiveError(what);
}

/// More than any run counts to, in a hundred thousand years; the sum of two fits 64 bits.
inline constexpr std::int64_t most_counted = 4'000'000'000'000'000'000;

/// Throws ArchiveError unless all are counts, or nothing, that a run can go on from.
template <class... Counts>
void require_counts(const Counts&... counts) {
  const auto is_possible = [](const std::optional<std::int64_t>& count) {
    return !count || (*count >= 0 && *count <= most_counted);
  };
  require_archived((is_possible(counts) && ...), "a count that there is not");
}

namespace archive_detail {

static_assert(std::endian::native == std::endian::little);

inline constexpr std::size_t extended_bytes = 10;  // of the 16 that a long double is stored in
inline constexpr int digits_exponent_limit = 1 << 30;

/// Numbers whose bytes in memory are their bytes in an archive.
template <class T>
concept Plain = (std::integral<T> && !std::same_as<T, bool>) || std::same_as<T, double> ||
                std::same_as<T, float>;

}  // namespace archive_detail

/// Writes values one behind the other into bytes.
class ArchiveWriter {
 public:
  static constexpr bool reads = false;

  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }

  const Bytes& bytes() const { return bytes_; }
  Bytes release() { return std::move(bytes_); }

 private:
  void raw(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  template <archive_detail::Plain Number>
  void write(const Number& value) {
    raw(&value, sizeof value);
  }
  void write(const bool& value) { bytes_.push_back(value ? 1 : 0); }
  void write(const Extended& value) { raw(&value, archive_detail::extended_bytes); }
  void write(const Quad& value) { raw(&value, sizeof value); }
  void write(const Digits& value) {
    const auto parts = parts_of(value);
    (*this)(static_cast<std::uint8_t>(parts.kind), parts.negative, parts.exponent);
    raw(parts.words.data(), parts.words.size() * sizeof parts.words.front());
  }
  void write(const std::string& text) {
    write(std::uint64_t{text.size()});
    raw(text.data(), text.size());
  }
  template <class T, class Allocator>
  void write(const std::vector<T, Allocator>& values) {
    write(std::uint64_t{values.size()});
    if constexpr (archive_detail::Plain<T>) {
      raw(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) write(value);
    }
  }
  template <class T, std::size_t Size>
  void write(const std::array<T, Size>& values) {
    for (const T& value : values) write(value);
  }
  template <class T>
  void write(const std::optional<T>& value) {
    write(value.has_value());
    if (value) write(*value);
  }
  template <class First, class Second>
  void write(const std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class T>
  requires std::is_class_v<T>
  void write(const T& value) { T::archive_state(value, *this); }

  Bytes bytes_;
};

/// Reads values from bytes in the order in which they were written.
///
/// Good for bytes from anybody: it never reads beyond their end, and allocates no more than a small
/// multiple of them. Throws ArchiveError where they are not what was asked for.
class ArchiveReader {
 public:
  static constexpr bool reads = true;

  /// \param bytes  outlive the reader
  explicit ArchiveReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }

  /// A value by itself.
  template <class T>
  T next() {
    T value{};
    read(value);
    return value;
  }

  std::size_t left() const { return rest_.size(); }

  /// From now on a number of more than double precision is read as it was written in a type with a
  /// significand of so many bits, and becomes the same number in the type asked for.
  void promote_from(int bits) { written_bits_ = bits; }
  bool is_promoting() const { return written_bits_ != 0; }

  /// To be called behind the last value.
  void require_end() const { require_archived(rest_.empty(), "more bytes than its state takes"); }

 private:
  void raw(void* data, std::size_t size) {
    require_archived(size <= rest_.size(), "fewer bytes than its state takes");
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  /// A length that the bytes left can fill with values of `size` bytes or more.
  std::size_t length(std::size_t size) {
    const auto count = next<std::uint64_t>();
    require_archived(count <= rest_.size() / size, "fewer bytes than its state takes");
    return static_cast<std::size_t>(count);
  }

  template <archive_detail::Plain Number>
  void read(Number& value) {
    raw(&value, sizeof value);
  }
  void read(bool& value) {
    const auto byte = next<std::uint8_t>();
    require_archived(byte <= 1, "a truth value that is neither");
    value = byte == 1;
  }
  void read(Extended& value) {
    if (is_promoting()) return promote(value);
    value = 0;  // the bytes of padding too
    raw(&value, archive_detail::extended_bytes);
  }
  void read(Quad& value) {
    if (is_promoting()) return promote(value);
    raw(&value, sizeof value);
  }
  void read(Digits& value) {
    if (is_promoting()) return promote(value);
    value = digits(WorkingPrecision::bits());
  }
  Digits digits(int bits) {
    DigitsParts parts;
    const auto kind = next<std::uint8_t>();
    (*this)(parts.negative, parts.exponent);
    parts.words.resize(words_of_bits(bits));
    raw(parts.words.data(), parts.words.size() * sizeof parts.words.front());
    require_archived(
        kind <= 2 && std::abs(std::int64_t{parts.exponent}) < archive_detail::digits_exponent_limit,
        "a number that there is not");
    parts.kind = NumberKind{kind};
    const auto number = composed(parts, bits);
    require_archived(number.has_value(), "a number that there is not");
    return *number;
  }
  void read(std::string& text) {
    text.resize(length(1));
    raw(text.data(), text.size());
  }
  template <class T, class Allocator>
  void read(std::vector<T, Allocator>& values) {
    values.clear();
    if constexpr (archive_detail::Plain<T>) {
      values.resize(length(sizeof(T)));
      raw(values.data(), values.size() * sizeof(T));
    } else {
      for (std::size_t left = length(1); left > 0; --left) read(values.emplace_back());
    }
  }
  template <class T, std::size_t Size>
  void read(std::array<T, Size>& values) {
    for (T& value : values) read(value);
  }
  template <class T>
  void read(std::optional<T>& value) {
    value.reset();
    if (next<bool>()) read(value.emplace());
  }
  template <class First, class Second>
  void read(std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class T>
  requires std::is_class_v<T>
  void read(T& value) { T::archive_state(value, *this); }

  /// A number of the type in which it was written.
  template <class Real>
  void promote(Real& value) {
    const int bits = std::exchange(written_bits_, 0);
    if (bits == Precision::double_precision.bits()) {
      value = Real(next<double>());
    } else if (bits == Precision::extended.bits()) {
      value = Real(next<Extended>());
    } else if constexpr (!std::is_same_v<Real, Extended>) {
      if (bits == Precision::quad.bits()) {
        value = Real(next<Quad>());
      } else if constexpr (std::is_same_v<Real, Digits>) {
        value = digits(bits).in_working_precision();
      } else {
        value = Real(digits(bits));
      }
    }
    written_bits_ = bits;
  }

  std::span<const std::uint8_t> rest_;
  int written_bits_ = 0;  ///< 0: those of the type asked for
};

}  // namespace zenosphere
