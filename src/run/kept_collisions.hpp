#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "collapse/approach.hpp"

namespace zenosphere {

/// Decades of a gap: -log10 of it; `limit` where it is zero or less. A gap may be far below the
/// range of `double`.
template <class Real>
double decades_of(const Real& gap, double limit) {
  using std::frexp;
  if (!(gap > 0)) return limit;
  int exponent = 0;
  const Real significand = frexp(gap, &exponent);
  return -std::log10(static_cast<double>(significand)) - exponent * std::log10(2.0);
}

/// Collisions that a trial has kept, in order.
template <class Real>
struct KeptCollisions {
  std::int64_t first_number = 0;  ///< of the first
  std::vector<DepthRow> rows{};
  std::vector<Real> times{};        ///< since the start
  std::vector<bool> dissipative{};  ///< energy was lost
  std::vector<double> margins{};    ///< of the curvature (see Curvature), decades
  Real end = 0;                     ///< where the clock stands now, since the start

  std::int64_t number(std::size_t row) const {
    return first_number + static_cast<std::int64_t>(row);
  }
};

}  // namespace zenosphere
