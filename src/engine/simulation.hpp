#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/calendar.hpp"
#include "engine/sliding_cells.hpp"
#include "model/collision.hpp"
#include "model/overlap_rule.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// Places and peculiar velocities (relative to the imposed profile) of spheres at strain 0.
template <int Dim, class Real>
struct Configuration {
  std::vector<Vec<Dim, Real>> positions;   ///< in [0, side) along each axis, diameters
  std::vector<Vec<Dim, Real>> velocities;  ///< peculiar, diameters/time
};

/// The rules of contact: how two spheres collide, and what is done where rounding interferes.
template <class Real>
struct ContactRules {
  Real restitution = 1;
  OverlapRule overlap = OverlapRule::rewind;
  Real guard = Real(1e-15);  ///< diameters^2/time; read by OverlapRule::guarded only
};

/// Event-driven dynamics of smooth inelastic hard spheres in a sheared periodic box.
///
/// Every sphere has one pending event, its earliest: a contact or the crossing of a cell face. A
/// pair is looked after by the sphere that was predicted later; a contact whose partner has
/// collided since is stale and leads to a new prediction when it comes up.
///
/// Source: Rapaport, The Art of Molecular Dynamics Simulation (2004), ch. 14; one event per
/// sphere: Lubachevsky, J. Comput. Phys. 94 (1991) 255.
template <int Dim, class Real>
class Simulation {
 public:
  using Vector = Vec<Dim, Real>;

  /// \param box    the box at strain 0
  /// \param start  equally many positions and velocities, at least two
  Simulation(const ShearBox<Dim, Real>& box, const Configuration<Dim, Real>& start,
             const ContactRules<Real>& rules);

  /// Goes on to the next collision and does it.
  ///
  /// \param until  time since the start at which to stop instead
  /// \return nothing if there is no collision up to `until`; or if only other events came for a
  ///         while, so that the caller can look at its limits and call again; or if
  ///         stopped_before() or is_at_rest()
  std::optional<Collision<Dim, Real>> next_collision(double until);

  /// A pair that would collide next, and its gap now, in diameters.
  struct NextPair {
    std::int32_t i;
    std::int32_t j;
    Real gap;
  };

  /// The pair before whose collision OverlapRule::stop has ended the run, if it has.
  const std::optional<NextPair>& stopped_before() const { return stopped_before_; }

  /// Nothing moves any more: there will be no further event.
  bool is_at_rest() const { return at_rest_; }

  std::int32_t spheres() const { return static_cast<std::int32_t>(spheres_.size()); }
  const ShearBox<Dim, Real>& box() const { return box_; }
  const ContactRules<Real>& rules() const { return rules_; }
  std::int64_t collisions() const { return collisions_; }

  /// Where the clock stands, and the same in one number.
  const Instant<Real>& now() const { return now_; }
  double time() const { return since_start(now_, box_.clock_unit()); }

  /// Whether the clock stands at `time` since the start, or later.
  bool has_reached(double time) const;

  /// Predictions that OverlapRule::guarded let pass.
  std::int64_t overlaps_ignored() const { return overlaps_ignored_; }
  std::int64_t cell_crossings() const { return cell_crossings_; }
  std::int64_t stale_events() const { return stale_events_; }

  /// Velocity relative to the imposed profile at the sphere's place now, diameters/time.
  Vector peculiar_velocity(std::int32_t sphere) const;

  /// The state now, wrapped into the box, as a configuration at strain 0 describes it; under shear
  /// the images of the box along y are displaced by lees_edwards_offset().
  Configuration<Dim, Real> configuration() const;

  /// Displacement of the upper image of the box along x, in [-side/2, side/2), diameters.
  Real lees_edwards_offset() const;

 private:
  struct Sphere {
    Vector position;  ///< at `time`; x in the frame of the layer; within the cell's faces
    Vector velocity;  ///< in the frame of the layer
    Real time;        ///< remainder of the clock
    std::int32_t cell;
    std::uint32_t collisions;
  };
  struct Pending {
    Real contact;   ///< remainder of the clock; infinity: none
    Real crossing;  ///< likewise
    std::int32_t partner;
    std::uint32_t partner_collisions;
    std::int8_t face;  ///< axis + 1, negative for the lower face
    bool overlapping;
  };

  void place(const Configuration<Dim, Real>& start);
  RelativeMotion<Dim, Real> pair_motion(std::int32_t i, std::int32_t j, const Real& when) const;
  Real profile_in_layer(const Sphere& sphere) const;
  Real slide() const;
  Vector position_at(const Sphere& sphere, const Real& when) const;

  void advance(Sphere& sphere) const;
  void predict(std::int32_t i);
  void predict_crossing(std::int32_t i);
  void predict_contacts(std::int32_t i, const typename SlidingCells<Dim>::Stencil& stencil);
  void consider(Pending& pending, std::int32_t j, const RelativeMotion<Dim, Real>& motion);

  Collision<Dim, Real> collide(std::int32_t i);
  Real gap_at_last_collision(std::int32_t i, std::int32_t j) const;
  void cross(std::int32_t i);
  int column_beyond(const Sphere& sphere, int layers) const;
  void rebase(const Real& next_event, const Instant<Real>& limit);
  void schedule(std::int32_t i);
  Instant<Real> instant(double time) const;
  bool is_past(const Instant<Real>& limit, const Real& next) const;
  void wrap(Vector& position) const;

  Sphere& sphere(std::int32_t i) { return spheres_[static_cast<std::size_t>(i)]; }
  const Sphere& sphere(std::int32_t i) const { return spheres_[static_cast<std::size_t>(i)]; }

  ShearBox<Dim, Real> box_;
  ContactRules<Real> rules_;
  SlidingCells<Dim> cells_;
  Calendar<Real> calendar_;
  std::vector<Sphere> spheres_;
  std::vector<Pending> pending_;
  Instant<Real> now_;
  Instant<Real> last_collision_;
  std::int64_t collisions_ = 0;
  std::int64_t cell_crossings_ = 0;
  std::int64_t stale_events_ = 0;
  std::int64_t overlaps_ignored_ = 0;
  std::optional<NextPair> stopped_before_;
  bool at_rest_ = false;
};

}  // namespace zenosphere
