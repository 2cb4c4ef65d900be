#pragma once

#include "model/archive.hpp"
#include "model/clock.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// The frame in which an engine follows its spheres: it falls and drifts with all of them.
///
/// Galileo's: what the spheres do with each other is the same in any frame. It moves only along
/// axes that are periodic, and under shear not at all. Where it does not move, nothing is rounded.
template <int Dim, class Real>
class MovingFrame {
 public:
  using Vector = Vec<Dim, Real>;

  /// \param acceleration  of all spheres, diameters/time^2: of the frame too, where it may move
  MovingFrame(const ShearBox<Dim, Real>& box, const Vector& acceleration) : box_(box) {
    for (int axis = 0; axis < Dim; ++axis) {
      if (is_free(axis)) acceleration_[axis] = acceleration[axis];
    }
    find_whether_it_moves();
  }

  /// Whether it may move along an axis.
  bool is_free(int axis) const { return !box_.is_sheared() && !box_.is_closed(axis); }
  bool moves() const { return moves_; }
  const Vector& acceleration() const { return acceleration_; }

  /// Its velocity in the frame of the box, diameters/time.
  Vector velocity(const Instant<Real>& now) const {
    return velocity_ + acceleration_ * elapsed(since_, now, box_.clock_unit());
  }

  /// How far it has come, wrapped into the box, diameters.
  Vector place(const Instant<Real>& now) const {
    const Real time = elapsed(since_, now, box_.clock_unit());
    return wrapped(place_ + velocity_ * time + acceleration_ * (time * time / 2));
  }

  /// A place along the periodic axes as the box has it, in [0, side).
  Vector wrapped(Vector place) const {
    using std::floor;
    for (int axis = 0; axis < Dim; ++axis) {
      if (!is_free(axis)) continue;
      const Real& side = box_.sides()[axis];
      place[axis] -= side * floor(static_cast<Real>(place[axis] / side));
      if (!(place[axis] >= 0 && place[axis] < side)) place[axis] = 0;  // by rounding
    }
    return place;
  }

  /// Moves faster from now on.
  ///
  /// \param change  zero along axes that are not free, diameters/time
  void speed_up(const Vector& change, const Instant<Real>& now) {
    place_ = place(now);
    velocity_ = velocity(now) + change;
    since_ = now;
    find_whether_it_moves();
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.velocity_, self.place_, self.since_);
    using std::isfinite;
    for (int axis = 0; axis < Dim; ++axis) {
      require_archived(isfinite(self.velocity_[axis]) && isfinite(self.place_[axis]) &&
                           (self.is_free(axis) || self.velocity_[axis] == 0),
                       "a frame that there is not");
    }
    if constexpr (Archive::reads) self.find_whether_it_moves();
  }

 private:
  void find_whether_it_moves() {
    moves_ = !(acceleration_ == Vector{} && velocity_ == Vector{} && place_ == Vector{});
  }

  ShearBox<Dim, Real> box_;
  Vector acceleration_;
  Vector velocity_;  ///< at `since_`
  Vector place_;     ///< likewise
  Instant<Real> since_;
  bool moves_ = false;
};

}  // namespace zenosphere
