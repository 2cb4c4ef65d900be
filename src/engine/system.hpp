#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/configuration.hpp"
#include "engine/moving_frame.hpp"
#include "engine/moving_walls.hpp"
#include "engine/neighbour_search.hpp"
#include "engine/spheres.hpp"
#include "engine/stride_clock.hpp"
#include "engine/surroundings.hpp"
#include "model/archive.hpp"
#include "model/oscillation_gap.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// What there is: spheres, the walls around them, the frame in which they are, and the time.
///
/// Times named `when` are remainders of the clock.
template <int Dim, class Real>
struct System {
  using Vector = Vec<Dim, Real>;

  /// As for a Simulation.
  System(const ShearBox<Dim, Real>& box, Configuration<Dim, Real> start,
         const Surroundings<Dim, Real>& around);
  /// With spheres that an archive holds; the rest is as at the start. Throws ArchiveError.
  System(const ShearBox<Dim, Real>& box, const Surroundings<Dim, Real>& around,
         ArchiveReader& archive);

  MovingFrame<Dim, Real> frame;
  Spheres<Dim, Real> spheres;
  NeighbourSearch<Dim, Real> search;  ///< of these spheres
  Surroundings<Dim, Real> surroundings;
  StrideClock<Real> clock;
  std::int64_t collisions = 0;                         ///< so far
  std::optional<MovingWalls<Dim, Real>> moving_walls;  ///< where one oscillates or is thermal

  const ShearBox<Dim, Real>& box() const { return spheres.box(); }
  const Grains<Real>& grains() const { return spheres.grains(); }
  std::int32_t count() const { return spheres.count(); }

  /// The spheres, and behind them the walls.
  std::int32_t partners() const { return count() + (surroundings.walls ? 2 : 0); }
  /// Whether a partner is a wall: 0 the lower, 1 the upper one.
  std::optional<int> wall(std::int32_t partner) const {
    return partner < count() ? std::nullopt : std::optional<int>(partner - count());
  }

  /// Of a sphere, diameters.
  Real radius(std::int32_t i) const {
    return spheres.are_of_one_size() ? Real(0.5) : grains().radius(i);
  }
  /// Of a sphere now, diameters/time; in its layer.
  Real speed(std::int32_t i) const {
    using std::sqrt;
    const Vector velocity = spheres.velocity_at(i, clock.remainder());
    return sqrt(dot(velocity, velocity));
  }
  /// The fastest sphere; of several the first.
  std::int32_t fastest() const {
    std::int32_t fastest = 0;
    for (std::int32_t i = 1; i < count(); ++i) {
      if (speed(i) > speed(fastest)) fastest = i;
    }
    return fastest;
  }

  /// The neighbours of a sphere.
  std::span<const Neighbour> neighbours(std::int32_t i) const {
    return search.neighbours(spheres, i);
  }
  /// How sphere i sees the sphere j that it meets at `when`; of no meaning where j is a wall.
  Neighbour neighbour(std::int32_t i, std::int32_t j, const Real& when) const {
    return wall(j) ? Neighbour() : search.neighbour(spheres, i, j, when);
  }
  /// The distance that two spheres, or a sphere and a wall, have to close from a moment on to their
  /// contact, diameters. Where one falls off the other and back it is that at the moment or, if
  /// that is wider, half-way.
  ///
  /// \param neighbour  the image that will be in contact
  /// \param contact    when that will be
  Real gap_to_close(std::int32_t i, std::int32_t j, Neighbour neighbour, const Real& from,
                    const Real& contact) const {
    if (const auto wall = this->wall(j)) return widest_wall_gap(i, *wall, from, contact);
    const Real sigma = spheres.sigma(i, j);
    const Real then = gap(spheres.motion(i, neighbour, from).dr, sigma);
    if (!spheres.fall_apart(i, j)) return then;
    const Real half_way = from + (contact - from) / 2;
    return std::max(then, gap(spheres.motion(i, neighbour, half_way).dr, sigma));
  }

  /// Place of a sphere's surface above where the lower wall is, or is at its lowest, diameters.
  Real wall_place(std::int32_t i, const Real& when) const;
  /// Surface distance to a wall, diameters.
  Real wall_gap(std::int32_t i, int wall, const Real& when) const;
  /// How wide the gap to a wall gets from a moment on until it closes: off a wall and back to it
  /// the height of the apex. If the wall oscillates, the wider one of the gaps then and half-way.
  Real widest_wall_gap(std::int32_t i, int wall, const Real& from, const Real& contact) const;
  /// The gap of a sphere to the oscillating wall, and the remainder of the clock that it counts
  /// from.
  struct CountedGap {
    OscillationGap<Real> gap;
    Real from;
  };
  /// Counted from its last bounce off that wall, where no other collision has come since, else from
  /// where the sphere is stored.
  CountedGap oscillating_gap(std::int32_t i) const;
  /// Velocity of a wall now, diameters/time.
  Vector wall_velocity(int side) const;

  /// Velocity relative to the imposed profile at the sphere's place now, diameters/time.
  Vector peculiar_velocity(std::int32_t i) const {
    const Vector velocity = spheres.peculiar_velocity(i, clock.remainder());
    return frame.moves() ? velocity + frame.velocity(clock.now()) : velocity;
  }
  /// Displacement of the upper image of the box along x, in [-side/2, side/2), diameters.
  Real lees_edwards_offset() const {
    return spheres.sliding_box().lees_edwards_offset(clock.now().units, clock.remainder());
  }
  /// The state now, wrapped into the box.
  Configuration<Dim, Real> configuration() const;

 private:
  void make_walls();
};

}  // namespace zenosphere
