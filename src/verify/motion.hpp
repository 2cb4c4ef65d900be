#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "case/case.hpp"
#include "model/vec.hpp"

namespace zenosphere::verify {

/// Rounding of a number that is stored in a file, relative.
inline constexpr long double double_rounding = 0x1p-52L;

/// A number of the case in the precision of its run.
long double in_precision(double value, Precision precision);

template <int Dim>
long double length(const Vec<Dim, long double>& vector) {
  return std::sqrt(dot(vector, vector));
}

/// A sphere at one time, in the laboratory and unwrapped, with bounds on its errors.
template <int Dim>
struct Body {
  Vec<Dim, long double> position;  ///< diameters
  Vec<Dim, long double> velocity;  ///< diameters/time
  long double time = 0;
  long double position_error = 0;  ///< diameters; infinity: nothing is known
  long double velocity_error = 0;  ///< diameters/time
  long double radius = 0.5L;       ///< diameters
  bool is_held = false;            ///< immobile: gravity does not pull it
};

/// Two spheres, or one and a wall, as they meet.
template <int Dim>
struct Meeting {
  Vec<Dim, long double> normal;    ///< from the first to the second
  Vec<Dim, long double> velocity;  ///< of the second as the first sees it, diameters/time
  long double sigma = 1;           ///< mean diameter of the two, or a unit of length
  long double gap = 0;             ///< surface distance / sigma
  long double closing = 0;         ///< normal speed, diameters/time
  long double speed = 0;           ///< relative speed, diameters/time
  long double error = 0;           ///< bound on that of the relative position
  long double normal_error = 0;    ///< likewise
  long double closing_error = 0;
};

/// How spheres fly and see each other in the box of a case, and how errors grow on the way.
///
/// Everything is in the laboratory: straight (or falling) flights and nearest images. Bounds are to
/// first order: the storage of a snapshot, the rounding of the engine at each event and where a
/// sphere leaves its layer or the box, and that of stored times.
template <int Dim>
class Motion {
 public:
  using Number = long double;
  using Vector = Vec<Dim, Number>;

  static constexpr Number unknown = std::numeric_limits<Number>::infinity();

  /// \param largest  diameter
  Motion(const Case& values, std::int64_t spheres, Number largest = 1);

  /// Says where the images are, and how fast the engine's frame may drift: as all spheres do.
  ///
  /// \param time      of a snapshot
  /// \param offset    of the upper image then
  /// \param momentum  sum of the velocities of all spheres then
  void start(double time, double offset, const Vector& momentum);

  /// Notes that the sum of all velocities has changed: by walls or kicks, or where masses differ.
  void add_momentum(const Vector& change);

  /// The sphere of a snapshot, whose storage is its error.
  Body<Dim> stored(const Vector& position, const Vector& velocity, double time,
                   Number radius = 0.5L) const;

  /// The sphere at another time if it flies on; or back, where an overlap has set back the clock.
  Body<Dim> moved(Body<Dim> body, Number time) const;

  /// Two spheres at a time, in the image that is the nearest then.
  Meeting<Dim> meeting(const Body<Dim>& first, const Body<Dim>& second, Number time) const {
    return meeting(first, second, time, time);
  }
  /// The same in the image that is the nearest at another time: at their contact.
  Meeting<Dim> meeting(const Body<Dim>& first, const Body<Dim>& second, Number time,
                       Number contact) const;
  /// \param place  of the wall then, diameters above where it is closed; and its velocity
  struct WallState {
    Number place = 0;
    Number speed = 0;
    Number peak_speed = 0;  ///< bounds on what rounded times do
    Number peak_acceleration = 0;
  };
  Meeting<Dim> wall_meeting(const Body<Dim>& body, int wall, Number time,
                            const WallState& state) const;

  /// How many boxes lie between two unwrapped places whose nearest images are wanted, and the
  /// vector between them without these.
  Vector boxes_to_nearest(Vector between, Number time) const;
  Vector without(const Vector& boxes, Vector between, Number time) const;

  /// Displacement of the upper image of the box along x, unwrapped since the start of the replay.
  Number image_offset(Number time) const;

  /// Velocity along x of an image, against that of the place so many boxes above it.
  Number image_velocity(Number boxes_up) const;

  /// Bound on the error of a stored time, and of one since the start of the replay.
  Number clock_error(Number time) const;

  const Vector& sides() const { return sides_; }
  Number longest_side() const { return longest_; }
  Number shortest_side() const;
  Number shear_rate() const { return shear_rate_; }
  const Vector& acceleration() const { return acceleration_; }
  std::optional<int> closed_axis() const { return closed_; }
  Number rounding() const { return rounding_; }
  Number storage_error() const { return storage_error_; }

 private:
  /// Whether the engine's frame falls: with all spheres, so not where some are immobile.
  bool frame_falls(int axis) const { return is_free(axis) && !some_are_held_; }
  bool is_free(int axis) const { return shear_rate_ == 0 && closed_ != axis; }
  Number frame_speed(Number time) const;

  Vector sides_;
  Vector acceleration_;
  bool some_are_held_;
  std::optional<int> closed_;
  Number shear_rate_;
  Number rounding_;           ///< relative, of the engine
  Number longest_ = 0;        ///< side
  Number storage_error_ = 0;  ///< of a position in a snapshot
  Number event_error_ = 0;    ///< of a contact, by rounding of its prediction
  Number spheres_;
  Vector momentum_;
  Number drift_ = 0;  ///< the largest mean velocity up to now along axes on which a frame may move
  Number start_time_ = 0;
  Number start_offset_ = 0;
};

}  // namespace zenosphere::verify
