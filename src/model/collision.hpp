#pragma once

#include <cstdint>

#include "model/clock.hpp"
#include "model/contact.hpp"

namespace zenosphere {

/// One collision as it was done: all that leaves the event loop.
template <int Dim, class Real>
struct Collision {
  std::int64_t number = 0;  ///< 1 for the first collision of the run
  Instant<Real> time;
  Real flight = 0;  ///< time since the collision before (since the start); <= 0 by rounding
  std::int32_t i = 0;
  std::int32_t j = 0;
  Impact<Dim, Real> impact;
  Real gap_before = 0;       ///< of this pair when the collision before was done, diameters
  bool overlapping = false;  ///< the overlap rule gave the time
  bool absorbed = false;     ///< no bit of any velocity has changed
};

}  // namespace zenosphere
