#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/calendar.hpp"
#include "engine/configuration.hpp"
#include "engine/contact_law.hpp"
#include "engine/contact_rules.hpp"
#include "engine/contacts_ahead.hpp"
#include "engine/fetching.hpp"
#include "engine/huge_page_vector.hpp"
#include "engine/moving_frame.hpp"
#include "engine/moving_walls.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/next_meetings.hpp"
#include "engine/rewind_bound.hpp"
#include "engine/spheres.hpp"
#include "engine/surroundings.hpp"
#include "model/collision.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// Event-driven dynamics of inelastic hard spheres.
///
/// Every sphere has one pending event: its first meeting, with a sphere or a wall, or the moment at
/// which it has to be settled again (see Spheres). A pair is looked after by the sphere that was
/// predicted later; a meeting whose partner has collided since is stale, and the second meeting of
/// the sphere takes its place, or a new prediction (see NextMeetings).
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

  /// Goes on to the next collision and does it.
  ///
  /// \param until  time since the start at which to stop instead
  /// \return nothing if there is no collision up to `until`; or if only other events came for a
  ///         while, so that the caller can look at its limits and call again; or if
  ///         stopped_before() or is_at_rest()
  std::optional<Collision<Dim, Real>> next_collision(double until) {
    auto collision = collision_until(until);
    if (waiting_) wait_until(until);
    return collision;
  }

  /// As next_collision, but where nothing happens up to `until` the clock stays at the last event:
  /// the state is one that a longer run goes through too. Then is_waiting() holds.
  std::optional<Collision<Dim, Real>> collision_until(double until);

  /// Nothing more happens up to the time that was last asked for.
  bool is_waiting() const { return waiting_ || at_rest_; }

  /// Lets the clock go on to `time` since the start, up to which nothing happens.
  void wait_until(double time);

  /// Adds to the velocity of every sphere, now.
  ///
  /// \param changes  one for each sphere, diameters/time; immobile ones get none
  void kick(const std::vector<Vector>& changes);

  /// Has what an observer keeps of each sphere, in a row from `first` on, fetched ahead of the
  /// collisions like what the engine needs itself. Only the speed depends on it: nothing there is
  /// read, and it may be gone.
  ///
  /// \param bytes  that it keeps of one sphere
  void fetch_too(const void* first, std::size_t bytes) {
    observed_ = static_cast<const std::byte*>(first);
    observed_bytes_ = bytes;
  }

  /// Predicts all events anew from where the spheres are: in a state promoted to more digits.
  void predict_anew() {
    come_home();
    for (std::int32_t i = 0; i < spheres(); ++i) predict(i);
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

  /// Nothing moves any more, or what moves meets nobody: there will be no further collision unless
  /// by a kick.
  bool is_at_rest() const { return at_rest_; }

  /// Events since the last collision or kick, spheres that have only been settled: those that are
  /// certain to come, too, where they are more than most_idle_events().
  std::int64_t idle_events() const { return idle_events_; }
  /// Whether these are so many that it is looked at what is ahead: of usual systems never.
  bool is_idle() const { return idle_events_ >= 2 * std::int64_t{spheres()} + 1024; }
  /// Whether spheres have flown so far since then that their places have no digit left.
  bool has_lost_places() const;
  double time_since_collision() const;

  std::int32_t spheres() const { return spheres_.count(); }
  const Grains<Real>& grains() const { return spheres_.grains(); }
  /// Angular velocities now, radians/time: of each sphere, or of none where nobody turns.
  const std::vector<Spin<Dim, Real>>& spins() const { return spheres_.spins(); }
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
  const ShearBox<Dim, Real>& box() const { return spheres_.box(); }
  const ContactRules<Real>& rules() const { return rules_; }
  const Surroundings<Dim, Real>& surroundings() const { return surroundings_; }
  std::int64_t collisions() const { return collisions_; }

  /// Where the clock stands, and the same in one number.
  const Instant<Real>& now() const { return now_; }
  double time() const { return since_start(now_, box().clock_unit()); }

  /// Whether the clock stands at `time` since the start, or later.
  bool has_reached(double time) const;

  /// Units in which the clock counts: a power of two, 1 under shear.
  double stride() const { return stride_; }

  /// Predictions that OverlapRule::guarded let pass.
  std::int64_t overlaps_ignored() const { return overlaps_ignored_; }
  /// The longest time by which OverlapRule::rewind has set, or will set, the clock back since the
  /// collision before the last.
  Real longest_rewind() const { return rewind_bound_.longest_lately(); }
  /// The remainder of the clock behind which it will not set it back.
  const Real& earliest_rewind() const { return rewind_bound_.earliest(); }
  /// Whether neighbours are looked for cell by cell, without lists: in dilute systems.
  bool looks_by_cells() const { return spheres_.looks_by_cells(); }
  std::int64_t settlings() const { return settlings_; }
  std::int64_t stale_events() const { return stale_events_; }

  /// What has been counted where collisions need more than a constant restitution.
  std::optional<ContactCounts> contact_counts() const {
    return law_ ? std::optional(law_->counts()) : std::nullopt;
  }

  /// Velocity relative to the imposed profile at the sphere's place now, diameters/time.
  Vector peculiar_velocity(std::int32_t sphere) const {
    const Vector velocity = spheres_.peculiar_velocity(spheres_[sphere], now_.remainder);
    return frame_.moves() ? velocity + frame_.velocity(now_) : velocity;
  }

  /// Where a sphere is across the flow of a sheared box: its position now, but along x relative to
  /// its layer, and not wrapped.
  Vector place_across_flow(std::int32_t sphere) const {
    return spheres_.position_at(spheres_[sphere], now_.remainder);
  }

  /// The state now, wrapped into the box.
  Configuration<Dim, Real> configuration() const;

  /// Displacement of the upper image of the box along x, in [-side/2, side/2), diameters.
  Real lees_edwards_offset() const {
    return spheres_.lees_edwards_offset(now_.units, now_.remainder);
  }

  /// Velocity of a wall now, diameters/time.
  Vector wall_velocity(int side) const;

  /// Whether the partner j of a collision is a wall: 0 the lower, 1 the upper one.
  std::optional<int> wall(std::int32_t j) const {
    return j < spheres() ? std::nullopt : std::optional<int>(j - spheres());
  }

 private:
  void predict(std::int32_t i);
  void look_ahead(std::int32_t i);
  void predict_new(std::int32_t i, std::span<const Neighbour> neighbours);
  Meeting<Real> meeting(std::int32_t j, const Real& time) const;
  NextMeetings<Real> one_by_one(std::int32_t i, std::span<const Neighbour> neighbours);
  NextMeetings<Real> in_parts(std::int32_t i, std::span<const Neighbour> neighbours);
  NextMeetings<Real> with_walls(std::int32_t i);
  Meeting<Real> with_oscillating_wall(std::int32_t i) const;
  NextMeetings<Real> first_ahead(std::int32_t i);
  NextMeetings<Real> with_heavy_partners(std::int32_t i);
  bool hardly_moves(std::int32_t j, std::int32_t i) const;
  void apply_overlap_rule();
  void limit_rewinds();
  bool is_stale(const Meeting<Real>& meeting) const;
  void go_stale(std::int32_t i);
  bool is_second_known(const NextMeetings<Real>& next) const;

  using Event = typename Calendar<Real>::Event;
  void fetch_ahead();
  void fetch_own(std::int32_t i);
  void fetch_partner(const Meeting<Real>& meeting);
  void fetch_around(const Event& event);
  void fetch_neighbours(const Event& event);
  void fetch_neighbours(std::int32_t i);
  void fetch_in_place_of_stale(const Event& event);

  Collision<Dim, Real> next_with(std::int32_t i);
  void meet(Collision<Dim, Real>& collision, Neighbour neighbour);
  void meet_by_law(Collision<Dim, Real>& collision, const RelativeMotion<Dim, Real>& motion);
  bool turn(const Collision<Dim, Real>& collision, std::int32_t sphere);
  void note_change(const Collision<Dim, Real>& collision);
  Real radius(std::int32_t i) const {
    return spheres_.are_of_one_size() ? Real(0.5) : grains().radius(i);
  }
  void bounce(Collision<Dim, Real>& collision, int wall);
  void touch_wall(std::int32_t i, int wall);
  Real touch_oscillating_wall(std::int32_t i);
  void depart(const Collision<Dim, Real>& collision, const Real& least);
  Real wall_place(std::int32_t i, const Real& when) const;
  Real wall_gap(std::int32_t i, int wall, const Real& when) const;
  Real widest_wall_gap(std::int32_t i, int wall, const Real& from, const Real& contact) const;
  /// The gap of a sphere to the oscillating wall, and the remainder of the clock that it counts
  /// from.
  struct CountedGap {
    OscillationGap<Real> gap;
    Real from;
  };
  CountedGap oscillating_gap(std::int32_t i) const;
  Neighbour neighbour(std::int32_t i, std::int32_t j, const Real& when) const;
  Real gap_at_last_change(std::int32_t i, std::int32_t j, Neighbour neighbour,
                          const Real& contact) const;
  void settle(std::int32_t i);
  void rebase(const Real& next_event, const Instant<Real>& limit);
  void set_back(double units);
  bool widen_stride(const Real& leap);
  bool lengthen_stride(double stride);
  void shorten_stride();
  bool only_cools() const;
  void look_around();
  void look_for_rest();
  bool waits_in_vain() const;
  void leap();
  Real certainly_apart(const Real& least) const;
  void come_home();
  std::int32_t fastest() const;
  Real speed(std::int32_t i) const;
  bool move_as_one() const;
  bool nobody_meets() const;
  Real fastest_beside(const Vector& velocity) const;
  bool may_meet(std::int32_t i, std::int32_t j) const;
  void move_frame(const Vector& change);
  Instant<Real> instant(double time) const { return instant_at(time, box().clock_unit(), stride_); }
  void schedule(std::int32_t i);
  bool is_past(const Instant<Real>& limit, const Real& next) const;
  Real earliest_time() const;
  void require_possible(std::int32_t i) const;
  bool is_pair(std::int32_t i, std::int32_t j) const;

  /// The spheres, and behind them the walls.
  std::int32_t partners() const { return spheres() + (surroundings_.walls ? 2 : 0); }

  /// What a checkpoint holds besides the spheres and their pending events.
  template <class Self, class Archive>
  static void archive_clock(Self& self, Archive& archive) {
    archive(self.now_, self.last_collision_, self.last_change_, self.collisions_, self.settlings_,
            self.stale_events_, self.overlaps_ignored_, self.stopped_before_, self.at_rest_,
            self.rewind_bound_, self.stride_, self.idle_events_, self.frame_);
  }

  void make_law() {
    if (!ContactLaw<Dim, Real>::is_needed(rules_, grains())) return;
    law_.emplace(rules_, spheres(), box().clock_unit());
    const bool may_turn = Dim > 1 && rules_.are_rough() && spins().empty();
    if (may_turn) spheres_.spins().resize(static_cast<std::size_t>(spheres()));
  }

  void make_walls() {
    const auto& walls = surroundings_.walls;
    if (!walls || !MovingWalls<Dim, Real>::are_needed(*walls)) return;
    moving_walls_.emplace(*walls, spheres(), box().clock_unit());
  }

  NextMeetings<Real>& meetings(std::int32_t i) { return meetings_[static_cast<std::size_t>(i)]; }
  const NextMeetings<Real>& meetings(std::int32_t i) const {
    return meetings_[static_cast<std::size_t>(i)];
  }

  MovingFrame<Dim, Real> frame_;  ///< in which the spheres are
  Spheres<Dim, Real> spheres_;
  ContactRules<Real> rules_;
  Surroundings<Dim, Real> surroundings_;
  std::optional<ContactLaw<Dim, Real>> law_;            ///< where impact() does not tell all
  std::optional<MovingWalls<Dim, Real>> moving_walls_;  ///< where a wall oscillates or is thermal
  Calendar<Real> calendar_;
  HugePageVector<NextMeetings<Real>> meetings_;
  double stride_ = 1;  ///< in which the clock counts, units
  Real span_;          ///< the same in time: what the remainder of the clock stays below
  Instant<Real> now_;
  Instant<Real> last_collision_;
  Instant<Real> last_change_;  ///< of velocities: the last collision or kick
  std::int64_t collisions_ = 0;
  std::int64_t settlings_ = 0;
  std::int64_t stale_events_ = 0;
  std::int64_t overlaps_ignored_ = 0;
  RewindBound<Dim, Real> rewind_bound_;
  std::int64_t idle_events_ = 0;
  ContactsAhead<Real> ahead_;  ///< scratch
  std::optional<NextPair> stopped_before_;
  bool at_rest_ = false;
  bool waiting_ = false;

  std::int64_t fetched_ = 0;  ///< for so many of the calendar's line; affects the speed only
  const std::byte* observed_ = nullptr;
  std::size_t observed_bytes_ = 0;
};

}  // namespace zenosphere
