#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "model/collision.hpp"
#include "model/real.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// Makes rows of the collision log. A row holds the gap of the pair that collides *next*, so it is
/// complete only one collision later.
template <int Dim, class Real>
class LogRows {
 public:
  /// \param gap_threshold  of the separation criterion, diameters
  /// \param clock_unit     of the simulation's clock
  LogRows(const Real& gap_threshold, const Real& clock_unit)
      : gap_threshold_(gap_threshold), clock_unit_(clock_unit) {}

  /// Makes `row` that of a collision, its gap NaN.
  void write(const Collision<Dim, Real>& collision, CollisionRow& row) const {
    const auto flag = [](bool is_set, std::uint8_t bit) { return is_set ? bit : std::uint8_t{0}; };
    row.k = collision.number;
    row.time = since_start(collision.time, clock_unit_);
    row.i = collision.i;
    row.j = collision.j;
    row.gap = std::numeric_limits<double>::quiet_NaN();
    row.normal_speed = nearest_double(collision.impact.normal_speed);
    row.flags = static_cast<std::uint8_t>(
        flag(collision.overlapping, collision_flag::overlap) |
        flag(collision.absorbed, collision_flag::absorbed) |
        flag(!(collision.impact.normal_speed > 0), collision_flag::receding) |
        flag(collision.made_elastic, collision_flag::made_elastic) |
        flag(collision.sliding, collision_flag::sliding) |
        flag(collision.resting, collision_flag::resting) |
        flag(!(collision.flight > 0), collision_flag::clock_stood));
  }

  /// Adds to a row the gap, then, of the pair that collides next.
  void complete(CollisionRow& row, const Real& gap) const {
    row.gap = nearest_double(gap);
    if (gap <= gap_threshold_) row.flags |= collision_flag::hit;
  }

 private:
  Real gap_threshold_;
  Real clock_unit_;
};

/// Gathers the rows of a run piece by piece; the row that is not complete yet waits here from one
/// piece to the next.
template <int Dim, class Real>
class RowCollector {
 public:
  explicit RowCollector(const LogRows<Dim, Real>& log) : log_(log) {}

  /// \param rows  those of the piece are appended to it; null: they are not wanted
  void begin(std::vector<CollisionRow>* rows) {
    rows_ = rows;
    if (rows_ && waiting_) rows_->push_back(*waiting_);
    is_open_ = rows_ && waiting_;
    waiting_.reset();
  }

  /// To be called once after each collision of the piece, in order.
  void observe(const Collision<Dim, Real>& collision) {
    if (!rows_) return;
    observe_next(collision.gap_before);
    log_.write(collision, rows_->emplace_back());
    is_open_ = true;
  }

  /// The gap, at the collision observed last, of the pair that collides next.
  void observe_next(const Real& gap) {
    if (is_open_) log_.complete(rows_->back(), gap);
  }

  /// Ends a piece that is not the last: its last row waits.
  void pause() {
    if (!is_open_) return;
    waiting_ = rows_->back();
    rows_->pop_back();
    is_open_ = false;
  }

 private:
  LogRows<Dim, Real> log_;
  std::vector<CollisionRow>* rows_ = nullptr;
  bool is_open_ = false;  ///< the last row of the piece lacks its gap
  std::optional<CollisionRow> waiting_;
};

}  // namespace zenosphere
