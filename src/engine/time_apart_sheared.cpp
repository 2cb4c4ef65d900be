#include "engine/time_apart_sheared.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/time_apart.hpp"

namespace zenosphere {

namespace {

/// When a place along a periodic axis comes within `reach` of 0.
double first_near(double place, double velocity, double side, double reach) {
  const double from = velocity < 0 ? -std::remainder(place, side) : std::remainder(place, side);
  if (std::abs(from) <= reach) return 0;
  if (velocity == 0) return never;
  return ((from < 0 ? 0 : side) - reach - from) / std::abs(velocity);
}

/// The stretch of a flight on which an image is as high as the sphere, to a diameter.
struct Pass {
  double boxes_up;  ///< of the image
  double from, to;  ///< time from now
};

template <int Dim>
class PassesBy {
 public:
  explicit PassesBy(const ShearedFlight<Dim>& flight) : flight_(flight) {}

  double time_apart(double until) const {
    constexpr int most_passes = 4096;
    const double height = flight_.displacement[1];
    const double speed = flight_.velocity[1];
    const double side = flight_.sides[1];
    const double up = speed < 0 ? -1 : 1;
    double boxes_up = up * std::floor((radius - up * height) / side);
    for (int pass = 0; pass < most_passes; ++pass, boxes_up -= up) {
      const double level = height + boxes_up * side;
      const bool stays = speed == 0;
      if (stays && std::abs(level) > radius) return until;
      const double middle = stays ? 0 : -level / speed;
      const double half = stays ? until : radius / std::abs(speed);
      const Pass here{boxes_up, std::max(middle - half, 0.0), std::min(middle + half, until)};
      if (here.from >= until) return until;
      const double later = here.from + time_apart_in(here);
      if (later < here.to) return later;
      if (stays) return until;
    }
    return std::clamp(-(height + boxes_up * side) / speed - radius / std::abs(speed), 0.0, until);
  }

 private:
  /// Time from the beginning of a pass on.
  double time_apart_in(const Pass& pass) const {
    const double velocity = flight_.velocity[0] + pass.boxes_up * flight_.slide;
    const double offset = pass.boxes_up * flight_.offset;
    const double place = flight_.displacement[0] + offset + velocity * pass.from;
    double flown =
        std::abs(flight_.displacement[0]) + std::abs(offset) + std::abs(velocity) * pass.to;
    if constexpr (Dim > 2) flown += std::abs(flight_.velocity[2]) * pass.to;
    const double reach = radius + 64 * std::numeric_limits<double>::epsilon() * flown;
    if (2 * reach >= flight_.sides[0]) return 0;
    const double near_along_x = first_near(place, velocity, flight_.sides[0], reach);
    if constexpr (Dim < 3) {
      return near_along_x;
    } else {
      const double side = flight_.sides[2];
      if (2 * reach >= side) return near_along_x;
      const double across = flight_.displacement[2] + flight_.velocity[2] * pass.from;
      const double near =
          std::max(near_along_x, first_near(across, flight_.velocity[2], side, reach));
      const double beside =
          std::hypot(std::remainder(place, flight_.sides[0]), std::remainder(across, side));
      if (beside <= reach) return 0;     // and they come together in height
      constexpr double sharp = 0x1p-24;  // as time_apart() is
      if (reach > radius + sharp || !(near < pass.to - pass.from)) return near;
      const StraightFlight<2> along{
          {{place, across}}, {{velocity, flight_.velocity[2]}}, 0, {flight_.sides[0], side}};
      return std::max(near, zenosphere::time_apart(along, pass.to - pass.from, 64));
    }
  }

  static constexpr double radius = 1 + 0x1p-20;  // wider than rounding

  const ShearedFlight<Dim>& flight_;
};

}  // namespace

template <int Dim>
double time_apart_sheared(const ShearedFlight<Dim>& flight, double until) {
  return PassesBy<Dim>(flight).time_apart(until);
}

template double time_apart_sheared(const ShearedFlight<2>&, double);
template double time_apart_sheared(const ShearedFlight<3>&, double);

}  // namespace zenosphere
