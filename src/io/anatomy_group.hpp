#pragma once

#include "collapse/dissection.hpp"
#include "io/hdf5.hpp"

namespace zenosphere {

/// Writes the group `anatomy` with what was found at the first hit and at the arrest, as far as
/// they happened; docs/file-format.md tells its datasets.
///
/// \param parent  the group /zenosphere, without an `anatomy`
/// Throws hdf5::Error.
void write_anatomy(const hdf5::Handle& parent, const Anatomy& anatomy, int dimension);

}  // namespace zenosphere
