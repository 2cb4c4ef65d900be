#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/configuration.hpp"
#include "engine/contact_law.hpp"
#include "engine/contact_rules.hpp"
#include "engine/next_collision.hpp"
#include "engine/predictor.hpp"
#include "engine/prefetcher.hpp"
#include "engine/surroundings.hpp"
#include "engine/system.hpp"
#include "model/collision.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// Event-driven dynamics of inelastic hard spheres.
///
/// Every sphere has one pending event: its first meeting, with a sphere or a wall, or the moment at
/// which its neighbour list has to be rebuilt (see Spheres). A pair is looked after by the sphere
/// that was predicted later; a meeting whose partner has collided since is stale, and the second
/// meeting of the sphere takes its place, or a new prediction (see NextMeetings).
///
/// Source: Rapaport, The Art of Molecular Dynamics Simulation (2004), ch. 14; one event per
/// sphere: Lubachevsky, J. Comput. Phys. 94 (1991) 255.
template <int Dim, class Real>
class Simulation {
 public:
  using Vector = Vec<Dim, Real>;

  /// \param box           the box without its offset
  /// \param start         equally many positions and velocities, at least one; its boxes count for
  ///                      nothing, its offset must be 0 where the box is closed along x or y. Rough
  ///                      spheres that it gives no spins do not turn yet
  /// \param surroundings  with walls exactly where the box is closed; not all fall where gravity
  ///                      pulls some and others are immobile
  /// Throws std::invalid_argument where cells are not wide enough for the largest sphere.
  Simulation(const ShearBox<Dim, Real>& box, Configuration<Dim, Real> start,
             const ContactRules<Real>& rules, const Surroundings<Dim, Real>& surroundings = {});

  /// The simulation that an archive holds; it goes on bit for bit as the archived one would.
  ///
  /// \param box, rules, surroundings  those of the archived one
  /// Throws ArchiveError where the archive holds no state that could be.
  Simulation(const ShearBox<Dim, Real>& box, const ContactRules<Real>& rules,
             const Surroundings<Dim, Real>& surroundings, ArchiveReader& archive);
  void archive_to(ArchiveWriter& archive) const;

  // Compiled once: implicit ones would be so in every source that holds a simulation.
  Simulation(const Simulation&);
  Simulation(Simulation&&) noexcept;
  ~Simulation();

  /// Goes on to the next collision and does it.
  ///
  /// \param until  time since the start at which to stop instead
  NextCollision<Dim, Real> next_collision(double until) {
    auto next = collision_until(until);
    if (!next && next.error() == NoCollision::up_to_time) wait_until(until);
    return next;
  }

  /// As next_collision, but where nothing happens up to `until` the clock stays at the last event:
  /// the state is one that a longer run goes through too.
  NextCollision<Dim, Real> collision_until(double until);

  /// Lets the clock go on to `time` since the start, up to which nothing happens.
  void wait_until(double time);

  /// Adds to the velocity of every sphere, now.
  ///
  /// \param changes  one for each sphere, diameters/time; immobile ones get none
  void kick(const std::vector<Vector>& changes);

  /// Has what an observer keeps of each sphere, in a row from `first` on, prefetched ahead of the
  /// collisions like what the engine needs itself. Only the speed depends on it: nothing there is
  /// read, and it may be gone.
  ///
  /// \param bytes  that it keeps of one sphere
  void prefetch_too(const void* first, std::size_t bytes) { prefetcher_.include(first, bytes); }

  /// Predicts all events anew from where the spheres are: in a state promoted to more digits.
  void predict_anew() {
    come_home();
    predictor_.predict_all(system_);
  }

  /// A pair that would collide next, and its gap now, in diameters.
  struct NextPair {
    std::int32_t i;
    std::int32_t j;
    Real gap;

    template <class Self, class Archive>
    static void archive_state(Self& self, Archive& archive) {
      archive(self.i, self.j, self.gap);
    }
  };

  /// The pair before whose collision OverlapRule::stop has ended the run, if it has.
  const std::optional<NextPair>& stopped_before() const { return stopped_before_; }

  /// Nothing moves any more, or what moves never meets: there will be no further collision unless
  /// by a kick.
  bool is_at_rest() const { return at_rest_; }

  /// Events since the last collision or kick, lists that have only been rebuilt: those that are
  /// certain to come, too, where they are more than most_idle_events().
  std::int64_t idle_events() const { return idle_events_; }
  /// Whether these are so many that it is looked at what is ahead: of usual systems never.
  bool is_idle() const { return idle_events_ >= 2 * std::int64_t{spheres()} + 1024; }
  /// Whether spheres have flown so far since then that their places have no digit left.
  bool has_lost_places() const;
  double time_since_collision() const {
    return static_cast<double>(clock().since(last_collision_));
  }

  std::int32_t spheres() const { return system_.count(); }
  const Grains<Real>& grains() const { return system_.grains(); }
  /// Angular velocities now, radians/time: of each sphere, or of none where they do not turn.
  const std::vector<Spin<Dim, Real>>& spins() const { return system_.spheres.spins(); }
  /// Of a sphere about its centre, mass diameter^2.
  Real moment_of_inertia(std::int32_t sphere) const {
    const Real radius = grains().radius(sphere);
    return rules_.inertia.value_or(Real(solid_inertia<Dim>)) * grains().mass(sphere) * radius *
           radius;
  }
  /// What the collision just done has changed of the spin of i or j.
  Spin<Dim, Real> change_of_spin(const Collision<Dim, Real>& collision, std::int32_t sphere) const {
    return law_->change_of_spin(collision, sphere, grains());
  }
  const ShearBox<Dim, Real>& box() const { return system_.box(); }
  const ContactRules<Real>& rules() const { return rules_; }
  const Surroundings<Dim, Real>& surroundings() const { return system_.surroundings; }
  std::int64_t collisions() const { return system_.collisions; }

  /// Where the clock stands, and the same in one number.
  const Instant<Real>& now() const { return clock().now(); }
  double time() const { return since_start(now(), clock().unit()); }

  /// Whether the clock stands at `time` since the start, or later.
  bool has_reached(double time) const { return clock().has_reached(time); }

  /// Units in which the clock counts: a power of two, 1 under shear.
  double stride() const { return clock().stride(); }

  /// Predictions that OverlapRule::guarded let pass.
  std::int64_t overlaps_ignored() const { return predictor_.overlaps_ignored(); }
  /// The longest time by which OverlapRule::rewind has set, or will set, the clock back since the
  /// collision before the last.
  Real longest_rewind() const { return predictor_.rewind_bound().longest_lately(); }
  /// The remainder of the clock behind which it will not set it back.
  const Real& earliest_rewind() const { return predictor_.rewind_bound().earliest(); }
  /// Whether neighbours are looked for cell by cell, without lists: in dilute systems.
  bool looks_by_cells() const { return system_.search.looks_by_cells(); }
  std::int64_t rebuilds() const { return rebuilds_; }
  std::int64_t stale_events() const { return stale_events_; }

  /// What has been counted where collisions need more than a constant restitution.
  std::optional<ContactCounts> contact_counts() const {
    return law_ ? std::optional(law_->counts()) : std::nullopt;
  }

  /// Velocity relative to the imposed profile at the sphere's place now, diameters/time.
  Vector peculiar_velocity(std::int32_t sphere) const { return system_.peculiar_velocity(sphere); }

  /// Where a sphere is across the flow of a sheared box: its position now, but along x relative to
  /// its layer, and not wrapped.
  Vector place_across_flow(std::int32_t sphere) const {
    return system_.spheres.position_at(sphere, clock().remainder());
  }

  /// The state now, wrapped into the box.
  Configuration<Dim, Real> configuration() const { return system_.configuration(); }

  /// Displacement of the upper image of the box along x, in [-side/2, side/2), diameters.
  Real lees_edwards_offset() const { return system_.lees_edwards_offset(); }

  /// Velocity of a wall now, diameters/time.
  Vector wall_velocity(int side) const { return system_.wall_velocity(side); }

  /// Whether the partner j of a collision is a wall: 0 the lower, 1 the upper one.
  std::optional<int> wall(std::int32_t j) const { return system_.wall(j); }

 private:
  NextCollision<Dim, Real> collide(std::int32_t i);
  void meet(Collision<Dim, Real>& collision, Neighbour neighbour);
  void meet_by_law(Collision<Dim, Real>& collision, const RelativeMotion<Dim, Real>& motion);
  void bounce(Collision<Dim, Real>& collision, int wall);
  void touch_wall(std::int32_t i, int wall);
  Real touch_oscillating_wall(std::int32_t i);
  void depart(const Collision<Dim, Real>& collision, const Real& least);
  bool turn(const Collision<Dim, Real>& collision, std::int32_t sphere);
  void note_change(const Collision<Dim, Real>& collision);
  Real gap_at_last_change(std::int32_t i, std::int32_t j, Neighbour neighbour,
                          const Real& contact) const;
  NoCollision stop_before(std::int32_t i, const Meeting<Real>& meeting);

  void rebuild_list(std::int32_t i);
  void replace_stale(std::int32_t i);
  bool is_past(const Instant<Real>& limit, const Real& next) const;
  void rebase(const Real& next_event, const Instant<Real>& limit);
  void shift_times(double units);
  bool widen_stride(const Real& leap);
  bool lengthen_stride(double stride);
  void shorten_stride();
  bool only_cools() const;

  void look_around();
  void look_for_rest();
  bool waits_in_vain() const;
  void leap();
  void come_home();
  void move_frame(const Vector& change);

  void make_law();
  bool is_pair(std::int32_t i, std::int32_t j) const;
  const StrideClock<Real>& clock() const { return system_.clock; }

  /// What a checkpoint holds besides the spheres and their pending events.
  template <class Self, class ClockState, class Archive>
  static void archive_course(Self& self, ClockState& clock, Archive& archive) {
    archive(clock.now, self.last_collision_, self.last_change_, self.system_.collisions,
            self.rebuilds_, self.stale_events_, self.predictor_.overlaps_ignored(),
            self.stopped_before_, self.at_rest_, self.predictor_.rewind_bound(), clock.stride,
            self.idle_events_, self.system_.frame);
  }

  System<Dim, Real> system_;
  ContactRules<Real> rules_;
  std::optional<ContactLaw<Dim, Real>> law_;  ///< where impact() does not tell all
  Predictor<Dim, Real> predictor_;
  Prefetcher<Dim, Real> prefetcher_;
  Instant<Real> last_collision_;
  Instant<Real> last_change_;  ///< of velocities: the last collision or kick
  std::int64_t rebuilds_ = 0;
  std::int64_t stale_events_ = 0;
  std::int64_t idle_events_ = 0;
  std::optional<NextPair> stopped_before_;
  bool at_rest_ = false;
};

}  // namespace zenosphere
