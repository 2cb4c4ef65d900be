#pragma once

#include <cstdint>

#include "model/vec.hpp"

namespace zenosphere {

/// A sphere as it was at its own last event. In double it fills one line of the cache.
template <int Dim, class Real>
struct alignas(64) Sphere {
  Vec<Dim, Real> position;  ///< at `time`; box coordinates, x in the frame of the layer
  Vec<Dim, Real> velocity;  ///< at `time`, in the frame of the layer
  Real time;                ///< remainder of the clock
  std::int32_t cell;        ///< in which its reference position lies
  std::uint32_t collisions;

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.position, self.velocity, self.time, self.cell, self.collisions);
  }
};

}  // namespace zenosphere
