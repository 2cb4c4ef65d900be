#pragma once

#include <array>
#include <cstdint>

namespace zenosphere {

/// The middle of the ball in which a sphere stays until its neighbour list is rebuilt.
struct ReferencePosition {
  using Place = std::array<std::int16_t, 3>;

  Place place{};      ///< from the lower corner of its cell, in grains
  float expires = 0;  ///< remainder of the clock: the list is rebuilt by then. In units of
                      ///< ListRange::expiry_unit

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.place, self.expires);
  }
};

}  // namespace zenosphere
