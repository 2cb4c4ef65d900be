#include "engine/time_apart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

__extension__ using Wide = unsigned __int128;  // products of two integers of 64 bits

/// The least n >= 0 for which n step modulo `period` is in [from, to], or nothing; one beyond
/// `most` may be left out.
///
/// \param step  below the period
std::optional<std::uint64_t> first_multiple_in(std::uint64_t from, std::uint64_t to,
                                               std::uint64_t step, std::uint64_t period,
                                               std::uint64_t most) {
  if (from == 0) return 0;
  if (step == 0) return std::nullopt;
  if (step > period - step) {  // the other way round
    return first_multiple_in(period - to, period - from, period - step, period, most);
  }
  const std::uint64_t steps = (from - 1) / step + 1;
  if (Wide{steps} * step <= to) return steps;
  if (Wide{most} * step < period) return std::nullopt;  // not within the first turn
  // After how many turns a multiple lands there: a question of the same kind, half as large.
  const double in_turns = static_cast<double>(step) / static_cast<double>(period);
  const auto most_turns = static_cast<std::uint64_t>(static_cast<double>(most) * in_turns) + 2;
  const auto turns =
      first_multiple_in(from % step, to % step, (step - period % step) % step, step, most_turns);
  if (!turns) return std::nullopt;
  return static_cast<std::uint64_t>((Wide{from} + Wide{period} * *turns - 1) / step + 1);
}

/// Where a flight passes by along one axis across: at q + n step, modulo a period.
struct Passes {
  double first;  ///< diameters
  double step;
  double period;
  double reach;  ///< of what is near, either way

  /// The first n >= `from` that is near, or infinity; below `end`, which is below 2^53.
  double next_near(double from, double end) const {
    if (std::isinf(period)) return next_in_the_open(from, end);
    constexpr double turn = 0x1p62;
    const auto part = [&](double length) {
      const double turns = length / period - std::floor(length / period);
      return static_cast<std::uint64_t>(turns * turn) & ((std::uint64_t{1} << 62) - 1);
    };
    const std::uint64_t all = std::uint64_t{1} << 62;
    const std::uint64_t one = part(step);
    const auto gone =
        static_cast<std::uint64_t>(Wide{one} * static_cast<std::uint64_t>(from) % all);
    const std::uint64_t here = (part(first) + gone) % all;
    const auto wide = static_cast<std::uint64_t>(reach / period * turn);
    // Multiples that carry from `here` to [-wide, wide].
    const std::uint64_t least = (2 * all - here - wide) % all;
    if (least + 2 * wide >= all) return from;  // 0 is among them
    const auto most = static_cast<std::uint64_t>(std::max(end - from, 0.0));
    const auto steps = first_multiple_in(least, least + 2 * wide, one, all, most);
    const double found = steps ? from + static_cast<double>(*steps) : never;
    return found < end ? found : never;
  }

 private:
  double next_in_the_open(double from, double end) const {
    if (std::abs(first + from * step) <= reach) return from;
    const double target = step > 0 ? -reach : reach;
    const double found = std::max(from, std::floor((target - first) / step));
    const bool comes_near =
        step != 0 && std::abs(first + (found + 1) * step) <= reach + std::abs(step);
    return comes_near && found < end ? found : never;
  }
};

template <int Dim>
class Search {
 public:
  /// \param axis     whose planes are counted: periodic, and the velocity along it not 0
  /// \param longest  flight that is looked at, diameters
  Search(const StraightFlight<Dim>& flight, int axis, double longest)
      : flight_(flight), axis_(axis), speed2_(dot(flight.velocity, flight.velocity)) {
    const double speed = flight.velocity[axis];
    const double period = flight.periods[static_cast<std::size_t>(axis)];
    double side = 1;
    for (const double other : flight.periods) {
      if (std::isfinite(other)) side = std::max(side, other);
    }
    // Rounding of places and times, and of parts of a turn; and 2^-24 for the rest.
    const double flown = longest * std::max(1.0, flight.speed / std::sqrt(speed2_));
    radius_ = 1 + 0x1p-24 + 32 * epsilon * (flown + side) + 0x1p-60 * longest / period * side;
    is_narrow_ = period < 4 * radius_;  // contacts come in the order of planes
    slack_ = 2 * radius_ / std::abs(speed);
    between_ = period / std::abs(speed);
    // The first plane is so far back that no contact with it can be ahead.
    first_time_ = -flight.displacement[axis] / speed;
    first_time_ -= between_ * std::floor(first_time_ / between_);
    first_time_ -= between_ * std::ceil(slack_ / between_);
    end_ = longest / std::sqrt(speed2_);
    planes_ = std::floor((end_ + slack_ - first_time_) / between_) + 1;
    int across = 0;
    for (int a = 0; a < Dim; ++a) {
      if (a == axis) continue;
      const double slope = flight.velocity[a] / speed;
      Passes& passes = passes_[static_cast<std::size_t>(across++)];
      passes = {flight.displacement[a] + flight.velocity[a] * first_time_,
                flight.velocity[a] * between_, flight.periods[static_cast<std::size_t>(a)],
                radius_ * std::sqrt(1 + slope * slope)};
      is_narrow_ = is_narrow_ || 2 * passes.reach >= passes.period;
    }
  }

  /// When the first image may be touched; or where the search ends.
  double first_contact(int searches) const {
    if (is_narrow_ || !(planes_ < 0x1p52)) return 0;
    double n = 0;
    for (; searches > 0; --searches) {
      const double before = n;
      for (int a = 0; a < Dim - 1; ++a) {
        n = passes_[static_cast<std::size_t>(a)].next_near(n, planes_);
        if (!(n < planes_)) return end_;
      }
      // What is near along one axis after the other need not be along both at once.
      if (Dim > 2 && n > before && !is_near(n)) continue;
      if (const double time = contact_at(n); time < never) return std::min(time, end_);
      n += 1;
    }
    return std::clamp(first_time_ + n * between_ - slack_, 0.0, end_);
  }

 private:
  bool is_near(double n) const {
    for (int a = 0; a < Dim - 1; ++a) {
      if (passes_[static_cast<std::size_t>(a)].next_near(n, n + 1) != n) return false;
    }
    return true;
  }

  /// When the image at plane n is touched, or infinity: it is missed, or left behind.
  double contact_at(double n) const {
    const double time = first_time_ + n * between_;
    Vec<Dim, double> place = flight_.displacement + flight_.velocity * time;
    for (int a = 0; a < Dim; ++a) {
      const double period = flight_.periods[static_cast<std::size_t>(a)];
      if (std::isfinite(period)) place[a] -= period * std::round(place[a] / period);
    }
    const double later = -dot(place, flight_.velocity) / speed2_;
    const Vec<Dim, double> nearest = place + flight_.velocity * later;
    const double miss = dot(nearest, nearest);
    if (miss > radius_ * radius_ || time + later < 0) return never;
    return std::max(time + later - std::sqrt(radius_ * radius_ - miss) / std::sqrt(speed2_), 0.0);
  }

  const StraightFlight<Dim>& flight_;
  int axis_;
  double speed2_;
  double radius_;
  double between_;     ///< two planes, time
  double slack_;       ///< between a contact and its plane, at most, time
  double first_time_;  ///< at the first plane, may be negative
  double planes_;      ///< so many
  double end_;
  bool is_narrow_ = false;
  std::array<Passes, 2> passes_{};
};

/// The axes, those along which most boxes are crossed first; along some there may be none.
template <int Dim>
std::array<int, Dim> axes_by_boxes(const StraightFlight<Dim>& flight) {
  const auto boxes = [&](int axis) {
    return std::abs(flight.velocity[axis]) / flight.periods[static_cast<std::size_t>(axis)];
  };
  std::array<int, Dim> axes{};
  std::iota(axes.begin(), axes.end(), 0);
  std::sort(axes.begin(), axes.end(),
            [&](int a, int b) { return boxes(a) > boxes(b) || (boxes(a) == boxes(b) && a < b); });
  return axes;
}

/// The time that the planes of one axis tell; 0: nothing.
template <int Dim>
double time_by_planes(const StraightFlight<Dim>& flight, int axis, double until, int searches) {
  const double speed = std::sqrt(dot(flight.velocity, flight.velocity));
  const auto time_within = [&](double longest) {
    return Search<Dim>(flight, axis, longest).first_contact(searches);
  };
  // The shorter the flight, the finer it is told which miss each other: the longest that is
  // certain.
  double longest = longest_foreseen / std::max(1.0, flight.speed / speed);
  longest = std::min(longest, until * speed);
  double time = time_within(longest);
  constexpr double short_flight = 1e4;
  double certain = std::max(4 * time * speed, short_flight);
  for (int round = 0; round < 8 && 4 * certain < longest; ++round) {
    const double length = round == 0 ? certain : std::sqrt(certain * longest);
    const double other = time_within(length);
    time = std::max(time, other);
    const bool ends_before = other * speed < length * (1 - 1e-9);
    if (ends_before && round == 0) break;
    (ends_before ? longest : certain) = length;
  }
  return time;
}

}  // namespace

template <int Dim>
double time_apart(const StraightFlight<Dim>& flight, double until, int searches) {
  if (!(dot(flight.velocity, flight.velocity) > 0)) return never;
  for (const int axis : axes_by_boxes(flight)) {
    const double period = flight.periods[static_cast<std::size_t>(axis)];
    if (flight.velocity[axis] == 0 || std::isinf(period)) continue;  // no image but the nearest
    const double time = time_by_planes(flight, axis, until, searches);
    if (time > 0) return time;
  }
  return 0;
}

#define ZENOSPHERE_INSTANTIATE(Dim) \
  template double time_apart(const StraightFlight<Dim>&, double, int);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
