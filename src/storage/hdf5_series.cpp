#include "storage/hdf5_series.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "storage/hdf5_checked.hpp"

namespace zenosphere::hdf5 {
namespace {

std::vector<hsize_t> extents(std::int64_t rows, const std::vector<std::int64_t>& row_shape) {
  std::vector<hsize_t> result{static_cast<hsize_t>(rows)};
  result.insert(result.end(), row_shape.begin(), row_shape.end());
  return result;
}

/// The space of `dataset` with `count` rows from `first` on selected.
Handle selected_rows(const Handle& dataset, std::int64_t first, const std::vector<hsize_t>& count) {
  Handle space = owned(H5Dget_space(dataset.id()));
  std::vector<hsize_t> start(count.size(), 0);
  start[0] = static_cast<hsize_t>(first);
  checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                              nullptr));
  return space;
}

/// Access without a cache of chunks: each write goes to the system at once.
Handle uncached() {
  Handle access = owned(H5Pcreate(H5P_DATASET_ACCESS));
  checked(H5Pset_chunk_cache(access.id(), 0, 0, H5D_CHUNK_CACHE_W0_DEFAULT));
  return access;
}

std::vector<std::int64_t> shape_of(const Handle& dataset) {
  const Handle space = owned(H5Dget_space(dataset.id()));
  std::vector<hsize_t> dims(checked(H5Sget_simple_extent_ndims(space.id())));
  checked(H5Sget_simple_extent_dims(space.id(), dims.data(), nullptr));
  return {dims.begin(), dims.end()};
}

/// Calls `transfer(space in memory, space in the file, bytes before it)` for blocks of rows: HDF5
/// builds up a description of all chunks that one call reads or writes, and many small ones take
/// long.
template <class Transfer>
void for_each_block(const Handle& dataset, Type type, const std::vector<std::int64_t>& row_shape,
                    std::int64_t first, std::int64_t count, Transfer transfer) {
  constexpr std::int64_t bytes_at_once = 1 << 20;
  auto row_bytes = static_cast<std::int64_t>(H5Tget_size(number_type(type)));
  for (const std::int64_t extent : row_shape) row_bytes *= extent;
  const std::int64_t most = bytes_at_once / std::clamp<std::int64_t>(row_bytes, 1, bytes_at_once);
  for (std::int64_t done = 0; done < count; done += most) {
    const auto block = extents(std::min(most, count - done), row_shape);
    const Handle selection = selected_rows(dataset, first + done, block);
    checked(transfer(simple_space(block), selection, done * row_bytes));
  }
}

}  // namespace

hid_t number_type(Type type) {
  static_assert(std::endian::native == std::endian::little);
  switch (type) {
    case Type::uint8:
      return H5T_STD_U8LE;
    case Type::int32:
      return H5T_STD_I32LE;
    case Type::int64:
      return H5T_STD_I64LE;
    case Type::float64:
      return H5T_IEEE_F64LE;
  }
  throw Error("unknown type");
}

std::vector<std::int64_t> shape(const Handle& parent, const std::string& path) {
  return shape_of(opened(parent, path));
}

void read_rows(const Handle& dataset, Type type, std::int64_t first, std::int64_t count,
               void* rows) {
  const auto all = shape_of(dataset);
  if (all.empty()) throw Error("a single value where rows are expected");
  auto* const bytes = static_cast<std::byte*>(rows);
  for_each_block(dataset, type, {all.begin() + 1, all.end()}, first, count,
                 [&](const Handle& memory, const Handle& selection, std::int64_t offset) {
                   return H5Dread(dataset.id(), number_type(type), memory.id(), selection.id(),
                                  H5P_DEFAULT, bytes + offset);
                 });
}

Series::Series(const Handle& parent, const std::string& name, Type type,
               const std::vector<std::int64_t>& row_shape, std::int64_t rows_per_chunk)
    : type_(type), row_shape_(row_shape) {
  for (const auto extent : row_shape) row_size_ *= extent;
  const auto empty = extents(0, row_shape);
  const auto chunk = extents(rows_per_chunk, row_shape);
  auto largest = empty;
  largest[0] = H5S_UNLIMITED;
  const int rank = static_cast<int>(empty.size());
  const Handle space = owned(H5Screate_simple(rank, empty.data(), largest.data()));
  const Handle creation = owned(H5Pcreate(H5P_DATASET_CREATE));
  checked(H5Pset_chunk(creation.id(), rank, chunk.data()));
  checked(H5Pset_fill_time(creation.id(), H5D_FILL_TIME_NEVER));  // no row is seen before it is set
  checked(H5Pset_obj_track_times(creation.id(), false));          // same run, same bytes
  const Handle access = uncached();
  dataset_ = owned(H5Dcreate2(parent.id(), name.c_str(), number_type(type), space.id(), H5P_DEFAULT,
                              creation.id(), access.id()));
}

Series::Series(const Handle& parent, const std::string& name, Type type) : type_(type) {
  const Handle access = uncached();
  dataset_ = owned(H5Dopen2(parent.id(), name.c_str(), access.id()));
  const auto all = shape_of(dataset_);
  if (all.empty()) throw Error(name + " is a single value where rows are expected");
  length_ = all.front();
  row_shape_.assign(all.begin() + 1, all.end());
  for (const auto extent : row_shape_) row_size_ *= extent;
  if (row_size_ < 1) throw Error(name + " has rows without numbers");
}

void Series::truncate(std::int64_t length) {
  if (length < 0 || length > length_) throw Error("there are fewer rows than there should be");
  checked(H5Dset_extent(dataset_.id(), extents(length, row_shape_).data()));
  length_ = length;
}

void Series::append_rows(const void* rows, std::int64_t count) {
  if (count == 0) return;
  checked(H5Dset_extent(dataset_.id(), extents(length_ + count, row_shape_).data()));
  const auto* const bytes = static_cast<const std::byte*>(rows);
  for_each_block(dataset_, type_, row_shape_, length_, count,
                 [&](const Handle& memory, const Handle& selection, std::int64_t offset) {
                   return H5Dwrite(dataset_.id(), number_type(type_), memory.id(), selection.id(),
                                   H5P_DEFAULT, bytes + offset);
                 });
  length_ += count;
}

}  // namespace zenosphere::hdf5
