#pragma once

#include <cstdint>

#include "collapse/dissection.hpp"
#include "storage/hdf5.hpp"

namespace zenosphere {

/// Writes the group `anatomy` with what was found at the first hit and at the arrest, as far as
/// they happened; docs/file-format.md tells its datasets.
///
/// \param parent  the group /zenosphere, without an `anatomy`
/// Throws hdf5::Error.
void write_anatomy(const hdf5::Handle& parent, const Anatomy& anatomy, int dimension);

/// Reads what write_anatomy wrote; nothing where there is no such group. Chain and bends are those
/// of the first cluster only, as in the file.
///
/// \param spheres  of the run; numbers that are none of its spheres or walls make a damaged file
/// Throws hdf5::Error.
Anatomy read_anatomy(const hdf5::Handle& parent, int dimension, std::int64_t spheres);

}  // namespace zenosphere
