#pragma once

#include <cstdint>
#include <vector>

#include "campaign/sweep.hpp"

namespace zenosphere {

/// The index of a point's value on each axis; the last axis varies fastest.
std::vector<std::size_t> coordinates_of(const std::vector<SweepAxis>& axes, std::int64_t point);

/// Throws an InputError with every problem of the cases of a grid.
///
/// Each value of each axis is tried with the first values of the others, and all points where there
/// are no more than two thousand.
void check_grid(const Sweep& sweep);

}  // namespace zenosphere
