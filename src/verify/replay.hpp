#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "collapse/verdict.hpp"
#include "model/grains.hpp"
#include "model/spin.hpp"
#include "model/vec.hpp"
#include "storage/records.hpp"
#include "verify/findings.hpp"
#include "verify/kicks.hpp"
#include "verify/law.hpp"
#include "verify/motion.hpp"
#include "verify/moving_walls.hpp"

namespace zenosphere::verify {

/// How far a replay has been able to follow a log.
struct Coverage {
  std::int64_t replayed = 0;           ///< collisions checked against the motion
  std::int64_t within[3] = {0, 0, 0};  ///< of these, bounds <= 1e-9, 1e-6, 1e-3 diameters
  std::int64_t beyond = 0;             ///< rounding may have grown above 1e-3 diameters
  std::int64_t unreached = 0;          ///< the log does not tell how one gets there
  std::int64_t snapshots = 0;          ///< compared
  std::int64_t spheres = 0;            ///< compared in them, each in each
  std::int64_t lost_spheres = 0;       ///< not compared, since beyond
};

/// Follows a collision log from snapshot to snapshot with arithmetic of its own.
///
/// Everything is in the laboratory: straight (or falling) flights from one logged collision of a
/// sphere to its next, the nearest image of a pair, the restitution law with the logged normal
/// speed, and no search for events. Each sphere carries bounds on the errors of its position and
/// velocity, to first order: the storage of the snapshot, the rounding of the engine at each event
/// and that of the logged times, and their growth in flights and collisions. What is checked has to
/// agree within the bounds; where they exceed 1e-3 diameters the motion cannot be predicted from
/// what is stored, and nothing is said until the next snapshot.
template <int Dim>
class Replay {
 public:
  using Number = long double;

  /// \param values            the case of the file
  /// \param criteria_version  of the file: what its gaps are
  /// \param grains            likewise
  Replay(const Case& values, std::int64_t spheres,
         std::int64_t criteria_version = zenosphere::criteria_version,
         const Grains<double>& grains = {});

  /// Compares a snapshot with the state where the log has led to it, and goes on from it.
  void observe(const Snapshot& snapshot, Findings& findings);

  /// Checks a collision and does it. Rows come in the order of the log.
  void observe(const CollisionRow& row, Findings& findings);

  const Coverage& coverage() const { return coverage_; }

 private:
  using Vector = Vec<Dim, Number>;

  /// A distance to be closed, diameters.
  struct Gap {
    Number value = 0;
    Number error = 0;  ///< bound
  };

  Body<Dim>& body(std::int32_t i) { return bodies_[static_cast<std::size_t>(i)]; }
  std::optional<int> wall(std::int32_t j) const;
  void start(const Snapshot& snapshot);
  void start_turning(const Snapshot& snapshot);
  void compare(const Snapshot& snapshot, Findings& findings);
  void compare_sphere(std::int32_t i, const Snapshot& snapshot, Findings& findings);
  void compare_spin(std::int32_t i, const Snapshot& snapshot, Findings& findings) const;
  void compare_image(std::int32_t i, const Snapshot& snapshot, const Vector& boxes,
                     Findings& findings) const;
  void kick_until(double time);
  bool is_beside_a_kick(double time) const;
  bool may_be_set_back_behind_a_kick(const CollisionRow& row) const;
  Meeting<Dim> meeting_at(const CollisionRow& row, Number time, Number contact);
  bool check(const CollisionRow& row, const Meeting<Dim>& meeting, Findings& findings);
  void check_last_gap(const CollisionRow& row, Findings& findings);
  Gap gap_before(const CollisionRow& row);
  Gap shortest_gap_before(const CollisionRow& row);
  Gap apex(const Meeting<Dim>& then, int wall) const;
  Gap gap_to_oscillating_wall(const CollisionRow& row);
  Meeting<Dim> wall_meeting(const CollisionRow& row, int wall, Number time);
  void collide(const CollisionRow& row, const Meeting<Dim>& meeting, Number impulse,
               Findings& findings);
  void bounce(const CollisionRow& row, int wall, const Meeting<Dim>& meeting, Findings& findings);
  void bounce_hot(const CollisionRow& row, const std::optional<Vector>& after);
  Vector rub(const CollisionRow& row, const Meeting<Dim>& meeting, Number impulse,
             const ContactConstants<Number>& constants, Number& error, Findings& findings);
  void count(Number error);
  void lose(const CollisionRow& row);
  void lose_all();

  static constexpr Number most_error = 1e-3L;  ///< diameters; what is checked is better than this

  /// The spin of a sphere, radians/time, and a bound on its error.
  struct Turning {
    Spin<Dim, Number> spin{};
    Number error = 0;
  };

  const Case& values_;
  std::int64_t criteria_version_;
  Grains<double> grains_;
  Motion<Dim> motion_;
  Law law_;
  std::vector<Body<Dim>> bodies_;     ///< each at its last event
  std::vector<Turning> turning_;      ///< each; empty where nothing turns
  std::vector<std::int32_t> images_;  ///< of the snapshot where the replay has begun
  Kicks<Dim> kicks_;
  LowerWall lower_wall_;
  ThermalWalls<Dim> thermal_walls_;
  bool has_start_ = false;
  std::int64_t done_ = -1;            ///< collisions that the state knows; -1: it is not known
  std::optional<CollisionRow> last_;  ///< the row before, if it is part of the state
  Number last_change_ = 0;            ///< time of the last collision or kick
  Number last_kick_ = -1;
  Coverage coverage_;
};

}  // namespace zenosphere::verify
