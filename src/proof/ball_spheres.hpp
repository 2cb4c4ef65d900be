#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "proof/ball.hpp"
#include "proof/exact_sphere.hpp"

namespace zenosphere {

/// A few free spheres, their places and times known as balls: what is said about the order of
/// collisions is certain, or it is not said.
///
/// Sphere i is at p_i + v_i t, t since an epoch that is an exact number: the middle of the latest
/// collision time. That time is uncertain by the error of a gap over its closing speed, which is
/// far more than the error of a gap; so no place is ever taken at it. A collision changes p_i by
/// the change of velocity times what is left of t, next to nothing.
class BallSpheres {
 public:
  using Pair = std::pair<int, int>;
  enum class Event {
    collision,
    none_left,   ///< certainly no two will collide any more
    not_certain  ///< the balls overlap: more bits may tell
  };

  BallSpheres(std::span<const ExactSphere> spheres, const PairRestitutions& restitutions);
  BallSpheres(std::span<const ExactSphere> spheres, const Rational& restitution)
      : BallSpheres(spheres, PairRestitutions(spheres.size(), restitution)) {}

  /// Goes on to the next collision. After anything else nothing has changed.
  Event next_event();

  const Pair& pair() const { return pair_; }
  /// The latest collision time, since the given moment.
  Ball now() const { return epoch_ + now_; }
  /// Of the pair that has just collided, at the collision before: the separation criterion's gap,
  /// in mean diameters of the two.
  const Ball& gap_before() const { return gap_; }

 private:
  struct Sphere {
    std::vector<Ball> p, v;
  };
  struct Meeting {
    Pair pair;
    Ball sigma;                  ///< distance of the centres at contact
    Ball share_i, share_j;       ///< (1 + e) (m_i m_j / (m_i + m_j)) / sigma^2, over m_i and m_j
    bool is_certain = true;      ///< whether they meet is known
    std::optional<Ball> time{};  ///< nothing where they never do
  };
  struct Motion {
    std::vector<Ball> dp, dv;

    Ball approach_at(const Ball& time) const;  ///< dr . dv
    Ball gap_at(const Ball& time, const Ball& sigma) const;
  };

  Motion motion(const Pair& pair) const;
  void predict(Meeting& meeting) const;
  void collide(const Meeting& meeting);
  void move_epoch_to_now();

  std::vector<Sphere> spheres_;
  std::vector<Meeting> meetings_;
  Pair pair_{-1, -1};
  Ball epoch_;
  Ball now_;  ///< since the epoch
  Ball gap_;
};

}  // namespace zenosphere
