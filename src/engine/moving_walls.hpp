#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/archive.hpp"
#include "model/clock.hpp"
#include "model/oscillation_gap.hpp"
#include "model/random.hpp"
#include "model/walls.hpp"

namespace zenosphere {

/// What a simulation remembers of walls that oscillate or are thermal: of each sphere how it has
/// left the oscillating wall last, and the stream of random velocities.
template <int Dim, class Real>
class MovingWalls {
 public:
  using Vector = Vec<Dim, Real>;

  static bool are_needed(const Walls<Real>& walls) {
    return walls.oscillation || walls.is_thermal(0) || walls.is_thermal(1);
  }

  /// \param clock_unit  of the simulation's clock
  MovingWalls(const Walls<Real>& walls, std::int32_t spheres, const Real& clock_unit);

  /// How a sphere has left the oscillating wall.
  struct Departure {
    Instant<Real> time;
    Real speed = 0;                ///< relative to the wall, diameters/time
    std::uint32_t collisions = 0;  ///< of the sphere by then; 0: it has not

    template <class Self, class Archive>
    static void archive_state(Self& self, Archive& archive) {
      archive(self.time, self.speed, self.collisions);
    }
  };
  Departure& departure(std::int32_t i) { return departures_[static_cast<std::size_t>(i)]; }
  const Departure& departure(std::int32_t i) const {
    return departures_[static_cast<std::size_t>(i)];
  }
  /// Velocities have changed otherwise than by collisions.
  void forget_departures();

  /// Time since the oscillating wall was at its lowest place.
  Real phase(const Instant<Real>& when) const;

  /// A velocity with which a smooth sphere leaves a thermal wall: that of a gas behind it which
  /// leaks through. Along the normal v exp(-m v^2/2T), across it a Gaussian.
  ///
  /// Source: Tehver, Toigo, Koplik & Banavar, Phys. Rev. E 57 (1998) R17.
  Vector thermal_velocity(const Walls<Real>& walls, int side, const Real& mass);

  /// \throws ArchiveError for the state of another number of spheres
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    const std::size_t spheres = self.departures_.size();
    archive(self.departures_, self.random_);
    require_archived(self.departures_.size() == spheres, "departures of another number of spheres");
    using std::isfinite;
    for (const Departure& departure : self.departures_) {
      require_archived(isfinite(departure.speed), "a speed that there is not");
    }
  }

 private:
  std::vector<Departure> departures_;  ///< empty where no wall oscillates
  Real period_ = 0;
  Real clock_unit_;
  Random random_;
};

}  // namespace zenosphere
