#pragma once

#include <cstdint>

#include "model/collision.hpp"

namespace zenosphere {

/// How many collisions were odd in a way that only rounding explains.
struct CollisionCounts {
  std::int64_t absorbed = 0;     ///< no bit of any velocity has changed
  std::int64_t overlapping = 0;  ///< the overlap rule gave the time
  std::int64_t receding = 0;     ///< turned into recession on the way: no impulse

  template <int Dim, class Real>
  void observe(const Collision<Dim, Real>& collision) {
    absorbed += collision.absorbed;
    overlapping += collision.overlapping;
    receding += !(collision.impact.normal_speed > 0);
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.absorbed, self.overlapping, self.receding);
    require_counts(self.absorbed, self.overlapping, self.receding);
  }
};

}  // namespace zenosphere
