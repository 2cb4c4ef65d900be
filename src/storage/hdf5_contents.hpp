#pragma once

#include <string>
#include <vector>

#include "storage/hdf5.hpp"

/// What a file holds, value by value: the part of the surface over HDF5 that checksums rest on.
namespace zenosphere::hdf5 {

/// Names of all values below a group: "a/b" is the dataset there, "a/b@c" the attribute c of the
/// object there. Left out is what this program writes nowhere: other types, soft and external
/// links, names with "@" or a line break, what lies deeper than eight groups.
std::vector<std::string> value_names(const Handle& group);

/// CRC-32C of the bytes of a value, its type and its extents: "1f2e3d4c float64 8x500x3".
///
/// Numbers count little-endian and row-major, texts in UTF-8 with a zero byte behind each.
/// \param name  as in `value_names`
std::string digest(const Handle& group, const std::string& name);

}  // namespace zenosphere::hdf5
