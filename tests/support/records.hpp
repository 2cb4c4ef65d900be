#pragma once

#include <cstdint>

#include "model/collision.hpp"

namespace zenosphere::support {

/// A collision as a criterion sees it, at `remainder` of the clock's first unit.
inline Collision<3, double> record(std::int64_t number, std::int32_t i, std::int32_t j,
                                   double gap_before, double remainder) {
  Collision<3, double> collision;
  collision.number = number;
  collision.i = i;
  collision.j = j;
  collision.gap_before = gap_before;
  collision.time.remainder = remainder;
  return collision;
}

}  // namespace zenosphere::support
