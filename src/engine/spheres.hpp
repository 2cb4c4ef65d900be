#pragma once

#include <cstdint>
#include <vector>

#include "engine/configuration.hpp"
#include "engine/sliding_cells.hpp"
#include "model/archive.hpp"
#include "model/contact.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// The spheres in their box: where each one is at any moment between two events, and who is near.
///
/// Every sphere is stored as it was at its own last event; `when` is always a remainder of the
/// clock. Positions are box coordinates, x in the frame of the sphere's layer. Nothing in here
/// knows about collisions or the order of events.
template <int Dim, class Real>
class Spheres {
 public:
  using Vector = Vec<Dim, Real>;
  using Stencil = typename SlidingCells<Dim>::Stencil;

  struct Sphere {
    Vector position;  ///< at `time`; within the faces of the cell
    Vector velocity;  ///< at `time`, in the frame of the layer
    Real time;        ///< remainder of the clock
    std::int32_t cell;
    std::uint32_t collisions;

    template <class Self, class Archive>
    static void archive_state(Self& self, Archive& archive) {
      archive(self.position, self.velocity, self.time, self.cell, self.collisions);
    }
  };

  /// A face of a sphere's cell and when the sphere passes it; infinity: never.
  struct Crossing {
    Real time;
    int axis = 0;
    int direction = 0;  ///< -1 or +1
  };

  /// \param acceleration  of every sphere, diameters/time^2
  Spheres(const ShearBox<Dim, Real>& box, const Configuration<Dim, Real>& start,
          const Vector& acceleration);

  /// Spheres in the state that an archive holds. Throws ArchiveError where that cannot be.
  Spheres(const ShearBox<Dim, Real>& box, const Vector& acceleration, ArchiveReader& archive);
  void archive_to(ArchiveWriter& archive) const;

  std::int32_t count() const { return static_cast<std::int32_t>(spheres_.size()); }
  Sphere& operator[](std::int32_t i) { return spheres_[static_cast<std::size_t>(i)]; }
  const Sphere& operator[](std::int32_t i) const { return spheres_[static_cast<std::size_t>(i)]; }
  const ShearBox<Dim, Real>& box() const { return box_; }
  const SlidingCells<Dim>& cells() const { return cells_; }
  const Vector& acceleration() const { return acceleration_; }

  Vector position_at(const Sphere& sphere, const Real& when) const {
    const Real flight = when - sphere.time;
    Vector position = sphere.position + sphere.velocity * flight;
    if (falls_) position += acceleration_ * (flight * flight / 2);
    return position;
  }
  Vector velocity_at(const Sphere& sphere, const Real& when) const {
    if (!falls_) return sphere.velocity;
    return sphere.velocity + acceleration_ * (when - sphere.time);
  }

  /// Stores the sphere as it is at `when`.
  void advance(Sphere& sphere, const Real& when) const {
    sphere.position = position_at(sphere, when);
    sphere.velocity = velocity_at(sphere, when);
    sphere.time = when;
  }

  /// Motion of j relative to i at `when`, in the nearest image.
  RelativeMotion<Dim, Real> motion(std::int32_t i, std::int32_t j, const Real& when) const;

  /// Calls `visit(j, motion of j relative to i)` for every sphere in the given part of the
  /// neighbourhood, in the image in which its cell lies there.
  template <class Visit>
  void for_each_neighbour(std::int32_t i, const Stencil& stencil, const Real& when,
                          Visit visit) const {
    const Sphere& sphere = (*this)[i];
    const Vector position = position_at(sphere, when);
    const Vector velocity = velocity_at(sphere, when);
    const auto visit_run = [&](std::int32_t first, std::int32_t last, const Steps<Dim>& lag,
                               int layers) {
      const auto image = box_.image(lag, layers, when);
      for (std::int32_t cell = first; cell <= last; ++cell) {
        for (std::int32_t j = cells_.first(cell); j != SlidingCells<Dim>::kNone;
             j = cells_.next(j)) {
          if (j == i) continue;
          const Sphere& other = (*this)[j];
          RelativeMotion<Dim, Real> motion{(position_at(other, when) - position) + image.position,
                                           velocity_at(other, when) - velocity};
          motion.dv[0] += image.velocity;
          visit(j, motion);
        }
      }
    };
    for (const auto& row : stencil) {
      cells_.for_each_run(sphere.cell, row,
                          [&](std::int32_t first, std::int32_t last, const Steps<Dim>& lag) {
                            visit_run(first, last, lag, cells_.layers(row.steps));
                          });
    }
  }

  /// The next face of its cell that a sphere passes. The outer faces of a closed axis are left out:
  /// there is a wall.
  Crossing next_crossing(const Sphere& sphere) const;

  /// Moves a sphere, advanced to `when`, through a face of its cell.
  void cross(std::int32_t i, const Crossing& crossing, const Real& when);

  /// Sets the clock of all spheres back by `span`; under shear that is one clock unit, and the
  /// layers have slid by one more cell.
  void set_back(const Real& span);

  /// Velocity relative to the imposed profile at the sphere's place, diameters/time.
  Vector peculiar_velocity(const Sphere& sphere, const Real& when) const;

  /// The state, wrapped into the box, as a configuration at strain 0 describes it.
  ///
  /// \param units  whole clock units since the start
  Configuration<Dim, Real> configuration(std::int64_t units, const Real& when) const;

  /// Displacement of the upper image of the box along x, in [-side/2, side/2), diameters.
  Real lees_edwards_offset(std::int64_t units, const Real& when) const;

 private:
  void place(const Configuration<Dim, Real>& start);
  void require_possible(const Sphere& sphere) const;
  int column_beyond(const Sphere& sphere, int layers, const Real& when) const;
  Real profile_in_layer(const Sphere& sphere, const Real& when) const;
  Real slide(std::int64_t units, const Real& when) const;
  void wrap(Vector& position) const;

  ShearBox<Dim, Real> box_;
  SlidingCells<Dim> cells_;
  Vector acceleration_;
  bool falls_;  ///< the acceleration is not zero
  std::vector<Sphere> spheres_;
};

}  // namespace zenosphere
