#pragma once

#include <limits>
#include <optional>
#include <utility>

#include "io/records.hpp"
#include "model/collision.hpp"

namespace zenosphere {

/// Makes the rows of the collision log.
///
/// A row holds the gap of the pair that collides *next*; so each waits for the collision after it.
template <int Dim, class Real>
class WaitingRow {
 public:
  /// \param gap_threshold  of the separation criterion, diameters
  /// \param clock_unit     of the simulation's clock
  WaitingRow(const Real& gap_threshold, const Real& clock_unit)
      : gap_threshold_(gap_threshold), clock_unit_(clock_unit) {}

  /// Takes the next collision; to be called once after each one, in order.
  ///
  /// \return the row of the collision before, complete now, if that was observed
  std::optional<CollisionRow> observe(const Collision<Dim, Real>& collision) {
    observe_next(collision.gap_before);
    return std::exchange(row_, row_of(collision));
  }

  /// The gap, at the collision observed last, of the pair that collides next.
  void observe_next(const Real& gap) {
    if (!row_) return;
    row_->gap = static_cast<double>(gap);
    if (gap <= gap_threshold_) row_->flags |= collision_flag::hit;
  }

  /// Gives up the row that waits, its gap NaN unless observe_next has told it.
  std::optional<CollisionRow> release() { return std::exchange(row_, std::nullopt); }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.row_);
  }

 private:
  CollisionRow row_of(const Collision<Dim, Real>& collision) const {
    CollisionRow row{
        .k = collision.number,
        .time = since_start(collision.time, clock_unit_),
        .i = collision.i,
        .j = collision.j,
        .gap = std::numeric_limits<double>::quiet_NaN(),
        .normal_speed = static_cast<double>(collision.impact.normal_speed),
        .flags = 0,
    };
    if (collision.overlapping) row.flags |= collision_flag::overlap;
    if (collision.absorbed) row.flags |= collision_flag::absorbed;
    if (!(collision.impact.normal_speed > 0)) row.flags |= collision_flag::receding;
    if (collision.made_elastic) row.flags |= collision_flag::made_elastic;
    if (!(collision.flight > 0)) row.flags |= collision_flag::clock_stood;
    return row;
  }

  Real gap_threshold_;
  Real clock_unit_;
  std::optional<CollisionRow> row_;
};

}  // namespace zenosphere
