#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "storage/records.hpp"

namespace zenosphere {

/// The type of a row of the collision log in numpy: a field for each column.
pybind11::dtype collision_dtype();

/// An array of that type that takes over the rows, without copying them.
pybind11::array owning_rows(std::vector<CollisionRow> rows);

}  // namespace zenosphere
