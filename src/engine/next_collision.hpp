#pragma once

#include <optional>

#include "model/collision.hpp"

namespace zenosphere {

/// Why a simulation has come to no collision.
enum class NoCollision {
  up_to_time,   ///< nothing happens up to the time that was asked for
  for_a_while,  ///< only other events came: the caller can look at its limits and ask again
  at_rest,      ///< nothing moves any more, or what moves never meets: until a kick
  overlap,      ///< OverlapRule::stop has ended the run before the collision of a pair
};

/// Whether the clock may go on to the time that was asked for: no event comes before.
inline bool is_quiet(NoCollision reason) {
  return reason == NoCollision::up_to_time || reason == NoCollision::at_rest;
}

/// The next collision, or why there is none: to be used like std::expected of C++23.
template <int Dim, class Real>
class NextCollision {
 public:
  /// A collision, to be filled in where it is: it is not copied at every collision.
  NextCollision() = default;
  NextCollision(NoCollision reason) : reason_(reason) {}

  bool has_value() const { return !reason_; }
  explicit operator bool() const { return has_value(); }

  Collision<Dim, Real>& operator*() { return collision_; }
  const Collision<Dim, Real>& operator*() const { return collision_; }
  const Collision<Dim, Real>* operator->() const { return &collision_; }
  /// Throws std::bad_optional_access where there is none.
  const Collision<Dim, Real>& value() const {
    if (reason_) throw std::bad_optional_access();
    return collision_;
  }

  /// Why there is none: only where that is so.
  NoCollision error() const { return reason_.value(); }

 private:
  Collision<Dim, Real> collision_;
  std::optional<NoCollision> reason_;
};

}  // namespace zenosphere
