#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
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

namespace archive_detail {

[[noreturn]] void refuse(const char* what);

}  // namespace archive_detail

/// Throws ArchiveError unless something holds that every archive fulfils.
inline void require_archived(bool holds, const char* what) {
  if (!holds) archive_detail::refuse(what);
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
  void raw(const void* data, std::size_t size);

  template <archive_detail::Plain Number>
  void write(const Number& value) {
    raw(&value, sizeof value);
  }
  void write(const bool& value);
  void write(const Extended& value);
  void write(const Quad& value);
  void write(const Digits& value);
  void write(const std::string& text);
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
  void raw(void* data, std::size_t size);
  /// A length that the bytes left can fill with values of `size` bytes or more.
  std::size_t length(std::size_t size);

  template <archive_detail::Plain Number>
  void read(Number& value) {
    raw(&value, sizeof value);
  }
  void read(bool& value);
  void read(Extended& value);
  void read(Quad& value);
  void read(Digits& value);
  void read(std::string& text);
  Digits digits(int bits);
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
  void promote(Real& value);

  std::span<const std::uint8_t> rest_;
  int written_bits_ = 0;  ///< 0: those of the type asked for
};

}  // namespace zenosphere
