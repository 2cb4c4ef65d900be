#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <string>
#include <vector>

#include "storage/hdf5.hpp"

/// Datasets of numbers: the part of the surface over HDF5 that reads and appends rows.
namespace zenosphere::hdf5 {

enum class Type { uint8, int32, int64, float64 };

template <class T>
inline constexpr Type type_of = Type{-1};
template <>
inline constexpr Type type_of<std::uint8_t> = Type::uint8;
template <>
inline constexpr Type type_of<std::int32_t> = Type::int32;
template <>
inline constexpr Type type_of<std::int64_t> = Type::int64;
template <>
inline constexpr Type type_of<double> = Type::float64;

/// Extents of a dataset, the slowest first.
std::vector<std::int64_t> shape(const Handle& parent, const std::string& path);

/// Rows `first` to `first + count - 1` of a dataset, into `rows` of that many rows.
void read_rows(const Handle& dataset, Type type, std::int64_t first, std::int64_t count,
               void* rows);

/// All values of a dataset of rank >= 1, flat.
template <class T>
std::vector<T> values(const Handle& parent, const std::string& path) {
  const auto extents = shape(parent, path);
  std::int64_t size = 1;
  for (const auto extent : extents) size *= extent;
  std::vector<T> result(static_cast<std::size_t>(size));
  if (size == 0) return result;
  const std::int64_t rows = extents.empty() ? 1 : extents.front();
  read_rows(opened(parent, path), type_of<T>, 0, rows, result.data());
  return result;
}

/// A dataset of rows of one shape that grows at its end.
///
/// Stored in chunks, neither compressed nor cached: each `append` goes to the operating system at
/// once, so that a full disk is noticed by the call that met it.
class Series {
 public:
  /// \param row_shape       extents of one row; empty for a plain number
  /// \param rows_per_chunk  unit in which the file grows
  Series(const Handle& parent, const std::string& name, Type type,
         const std::vector<std::int64_t>& row_shape, std::int64_t rows_per_chunk);

  /// The series that is there already.
  Series(const Handle& parent, const std::string& name, Type type);

  /// Appends whole rows, flat. After an `Error` the file is to be abandoned.
  template <class T>
  void append(const std::vector<T>& values) {
    assert(type_of<T> == type_);
    assert(static_cast<std::int64_t>(values.size()) % row_size_ == 0);
    append_rows(values.data(), static_cast<std::int64_t>(values.size()) / row_size_);
  }

  /// Puts whole rows, flat, in the place of all that are there.
  template <class T>
  void replace(const std::vector<T>& values) {
    truncate(std::min(length_, static_cast<std::int64_t>(values.size()) / row_size_));
    length_ = 0;  // so that they are written over
    append(values);
  }

  /// Whether the values, flat, make up one row.
  template <class T>
  bool is_row(const std::vector<T>& values) const {
    return static_cast<std::int64_t>(values.size()) == row_size_;
  }

  std::int64_t length() const { return length_; }
  const std::vector<std::int64_t>& row_shape() const { return row_shape_; }

  /// Drops the rows behind the first `length`. Throws Error where there are fewer.
  void truncate(std::int64_t length);

 private:
  void append_rows(const void* rows, std::int64_t count);

  Handle dataset_;
  Type type_;
  std::vector<std::int64_t> row_shape_;
  std::int64_t row_size_ = 1;
  std::int64_t length_ = 0;
};

}  // namespace zenosphere::hdf5
