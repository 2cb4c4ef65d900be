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

  /// A place as the box has it: along the axes that are free in [0, side), after so many boxes.
  struct Place {
    Vector in_box;  ///< diameters
    Vec<Dim, double> boxes{};
  };

  /// How far it has come.
  ///
  /// \param offset  displacement of the upper image of the box along x, diameters
  Place place(const Instant<Real>& now, const Real& offset) const {
    const Real time = elapsed(since_, now, box_.clock_unit());
    Place place{place_ + velocity_ * time + acceleration_ * (time * time / 2), boxes_};
    wrap(place, offset);
    return place;
  }

  /// Puts a place into the box along the axes that are free.
  void wrap(Place& place, const Real& offset) const {
    using std::floor;
    Vector& in_box = place.in_box;
    for (int axis = Dim - 1; axis >= 0; --axis) {  // y before x, along which it displaces images
      if (!is_free(axis)) continue;
      const Real& side = box_.sides()[axis];
      const Real periods = floor(static_cast<Real>(in_box[axis] / side));
      in_box[axis] -= side * periods;
      place.boxes[axis] += static_cast<double>(periods);
      if (axis == 1) in_box[0] -= periods * offset;
      if (in_box[axis] >= side) place.boxes[axis] += 1;  // by rounding
      if (!(in_box[axis] >= 0 && in_box[axis] < side)) in_box[axis] = 0;
    }
  }

  /// Moves faster from now on.
  ///
  /// \param change  zero along axes that are not free, diameters/time
  void speed_up(const Vector& change, const Instant<Real>& now, const Real& offset) {
    const Place place = this->place(now, offset);
    place_ = place.in_box;
    boxes_ = place.boxes;
    velocity_ = velocity(now) + change;
    since_ = now;
    find_whether_it_moves();
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.velocity_, self.place_, self.boxes_, self.since_);
    using std::isfinite;
    for (int axis = 0; axis < Dim; ++axis) {
      require_archived(isfinite(self.velocity_[axis]) && isfinite(self.place_[axis]) &&
                           std::isfinite(self.boxes_[axis]) &&
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
  Vector velocity_;         ///< at `since_`
  Vector place_;            ///< likewise, in the box
  Vec<Dim, double> boxes_;  ///< through which it had come by then
  Instant<Real> since_;
  bool moves_ = false;
};

}  // namespace zenosphere
