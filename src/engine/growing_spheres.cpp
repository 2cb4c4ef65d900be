#include "engine/growing_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "engine/close_pairs.hpp"
#include "model/power.hpp"

namespace zenosphere {

namespace {

/// Time until the distance |apart + velocity t| is reach + growth t, or nothing if it never is; 0
/// for what is closer and still comes closer.
///
/// The first root of a t^2 + 2 b t + c = 0, written so that the small root of a pair that nearly
/// touches keeps its digits.
template <int Dim>
std::optional<double> touching_time(const Vec<Dim, double>& apart, const Vec<Dim, double>& velocity,
                                    double reach, double growth) {
  const double a = dot(velocity, velocity) - growth * growth;
  const double b = dot(apart, velocity) - reach * growth;
  const double c = dot(apart, apart) - reach * reach;
  if (c <= 0 && b < 0) return 0;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  if (b < 0) return c / (std::sqrt(discriminant) - b);
  if (a < 0) return (b + std::sqrt(discriminant)) / -a;  // outgrown by the surfaces
  return std::nullopt;
}

}  // namespace

template <int Dim>
GrowingSpheres<Dim>::GrowingSpheres(std::span<const double> diameters,
                                    const ShearBox<Dim, double>& box, Random& random)
    : box_(box),
      mean_diameter_(std::accumulate(diameters.begin(), diameters.end(), 0.0) /
                     static_cast<double>(diameters.size())),
      positions_(diameters.size()),
      velocities_(diameters.size()),
      changes_(diameters.size()),
      calendar_(static_cast<std::int32_t>(diameters.size())) {
  for (const double diameter : diameters) radii_.push_back(diameter / 2);
  for (std::int32_t i = 0; i < count(); ++i) {
    for (int axis = 0; axis < Dim; ++axis) {
      position(i)[axis] = box.sides()[axis] * random.uniform();
      velocity(i)[axis] = random.normal();
    }
  }
}

template <int Dim>
typename GrowingSpheres<Dim>::Round GrowingSpheres<Dim>::advance(double rate, double full_size) {
  constexpr std::int64_t collisions_a_sphere = 5;  // before the temperature is set again
  rescale_velocities();
  const double largest = 2 * *std::max_element(radii_.begin(), radii_.end());
  rate_ = rate;
  now_ = 0;
  double end = mean_diameter_ / largest;  // so that the growth of a round stays small
  const double time_left = rate > 0 ? (full_size - size_) / rate : end;
  const bool may_fill = time_left <= end;
  end = std::min(end, time_left);
  list_neighbours(rate * end);
  const std::int64_t most = collisions_a_sphere * std::max(count(), 20) / 2;
  std::int64_t collisions = 0;
  for (std::int32_t i = 0; i < count(); ++i) predict(i);
  while (collisions < most) {
    const std::int32_t i = calendar_.earliest();
    const bool is_over = i == Calendar<double>::none || !(calendar_.time(i) < end);
    now_ = is_over ? end : calendar_.time(i);
    if (is_over) break;
    const Meeting meeting = meetings_[static_cast<std::size_t>(i)];
    if (meeting.kind == Meeting::Kind::margin) break;
    if (meeting.kind != Meeting::Kind::sphere) {
      bounce(i, meeting);
      ++collisions;  // of one that is squeezed between walls there is no end
    } else if (meeting.partner_changes == changes_[static_cast<std::size_t>(meeting.partner)]) {
      collide(i, meeting);
      ++collisions;
    } else {
      predict(i);
    }
  }
  for (std::int32_t i = 0; i < count(); ++i) {
    bring_to_now(i);
    wrap(i);
  }
  calendar_.shift_times(now_);
  size_ = may_fill && now_ >= end && rate > 0 ? full_size : size_ + rate * now_;
  return {now_, 2 * static_cast<double>(collisions) / static_cast<double>(count())};
}

/// To the temperature at which a mean diameter is covered in a unit of time, without mean motion.
template <int Dim>
void GrowingSpheres<Dim>::rescale_velocities() {
  Vec<Dim, double> mean;
  for (const auto& v : velocities_) mean += v * (1.0 / count());
  double square = 0;
  for (auto& v : velocities_) {
    if (count() > 1) v -= mean;
    square += dot(v, v);
  }
  if (!(square > 0)) return;
  const double factor = mean_diameter_ * std::sqrt(Dim * static_cast<double>(count()) / square);
  for (auto& v : velocities_) v *= factor;
}

/// Lists for each sphere those that it can meet within its margin.
///
/// \param growth  of the size, in the round to come
template <int Dim>
void GrowingSpheres<Dim>::list_neighbours(double growth) {
  const auto n = static_cast<std::size_t>(count());
  double volume = 1;
  double shortest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < Dim; ++axis) {
    volume *= box_.sides()[axis];
    shortest = std::min(shortest, box_.sides()[axis]);
  }
  // A third of the distance between neighbours.
  double spacing = shortest;
  while (static_cast<double>(n) * power<Dim>(spacing) > volume) {
    spacing *= 0.96875;
  }
  margin_ = std::min(spacing / 3, shortest / 4);
  std::vector<double> diameters;
  diameters.reserve(n);
  for (const double r : radii_) diameters.push_back(2 * r * (size_ + growth));
  const auto pairs = close_pairs<Dim>(positions_, diameters, box_, margin_);
  first_neighbour_.assign(n + 1, 0);
  for (const auto& pair : pairs) {
    ++first_neighbour_[static_cast<std::size_t>(pair.i) + 1];
    ++first_neighbour_[static_cast<std::size_t>(pair.j) + 1];
  }
  std::partial_sum(first_neighbour_.begin(), first_neighbour_.end(), first_neighbour_.begin());
  std::vector<std::size_t> end(first_neighbour_.begin(), first_neighbour_.end() - 1);
  neighbours_.resize(2 * pairs.size());
  for (const auto& pair : pairs) {
    neighbours_[end[static_cast<std::size_t>(pair.i)]++] = {pair.j, pair.shift};
    neighbours_[end[static_cast<std::size_t>(pair.j)]++] = {pair.i, pair.shift * -1.0};
  }
  places_before_ = positions_;
  times_.assign(n, 0);
  meetings_.assign(n, {});
}

template <int Dim>
void GrowingSpheres<Dim>::predict(std::int32_t i) {
  bring_to_now(i);
  Meeting next{std::numeric_limits<double>::infinity()};
  const auto k = static_cast<std::size_t>(i);
  for (std::size_t n = first_neighbour_[k]; n < first_neighbour_[k + 1]; ++n) {
    consider_sphere(i, neighbours_[n], next);
  }
  consider_walls(i, next);
  consider_margin(i, next);
  meetings_[k] = next;
  calendar_.schedule(i, next.time);
}

template <int Dim>
void GrowingSpheres<Dim>::consider_sphere(std::int32_t i, const Neighbour& neighbour,
                                          Meeting& next) const {
  const std::int32_t j = neighbour.sphere;
  const double radii = radius(i) + radius(j);
  const auto time = touching_time<Dim>(
      position_now(j) + neighbour.shift - positions_[static_cast<std::size_t>(i)],
      velocity(j) - velocity(i), radii * (size_ + rate_ * now_), radii * rate_);
  if (!time || !(now_ + *time < next.time)) return;
  next = {now_ + *time, Meeting::Kind::sphere, j, changes_[static_cast<std::size_t>(j)],
          neighbour.shift};
}

template <int Dim>
void GrowingSpheres<Dim>::consider_walls(std::int32_t i, Meeting& next) const {
  const auto closed = box_.closed_axis();
  if (!closed) return;
  const double place = positions_[static_cast<std::size_t>(i)][*closed];
  const double speed = velocity(i)[*closed];
  const double reach = radius(i) * (size_ + rate_ * now_);
  const double growth = radius(i) * rate_;
  const auto consider = [&](double room, double approach, typename Meeting::Kind wall) {
    if (!(approach > 0)) return;
    const double time = now_ + std::max(room, 0.0) / approach;
    if (time < next.time) next = {time, wall};
  };
  consider(place - reach, growth - speed, Meeting::Kind::lower_wall);
  consider(box_.sides()[*closed] - place - reach, growth + speed, Meeting::Kind::upper_wall);
}

/// The time at which a sphere is half a margin away from where it was at the start of the round.
template <int Dim>
void GrowingSpheres<Dim>::consider_margin(std::int32_t i, Meeting& next) const {
  const auto k = static_cast<std::size_t>(i);
  const Vec<Dim, double> moved = positions_[k] - places_before_[k];
  const double a = dot(velocity(i), velocity(i));
  if (!(a > 0)) return;
  const double b = dot(moved, velocity(i));
  const double c = std::min(0.0, dot(moved, moved) - margin_ * margin_ / 4);
  const double time = now_ + (std::sqrt(b * b - a * c) - b) / a;
  if (time < next.time) next = {time, Meeting::Kind::margin};
}

/// Elastic in the frame of the surfaces, which part at the speed of the growth.
template <int Dim>
void GrowingSpheres<Dim>::collide(std::int32_t i, const Meeting& meeting) {
  const std::int32_t j = meeting.partner;
  bring_to_now(i);
  bring_to_now(j);
  const Vec<Dim, double> apart = position(j) + meeting.shift - position(i);
  const double distance = std::sqrt(dot(apart, apart));
  const Vec<Dim, double> normal = apart * (1 / distance);
  const double speed = dot(velocity(j) - velocity(i), normal);
  const double growth = (radius(i) + radius(j)) * rate_;
  const Vec<Dim, double> change = normal * (growth - speed);
  velocity(i) -= change;
  velocity(j) += change;
  ++changes_[static_cast<std::size_t>(i)];
  ++changes_[static_cast<std::size_t>(j)];
  predict(i);
  predict(j);
}

template <int Dim>
void GrowingSpheres<Dim>::bounce(std::int32_t i, const Meeting& meeting) {
  bring_to_now(i);
  const double growth = radius(i) * rate_;
  const bool is_lower = meeting.kind == Meeting::Kind::lower_wall;
  double& speed = velocity(i)[*box_.closed_axis()];
  speed = (is_lower ? 2 : -2) * growth - speed;
  ++changes_[static_cast<std::size_t>(i)];
  predict(i);
}

template <int Dim>
void GrowingSpheres<Dim>::bring_to_now(std::int32_t i) {
  const auto k = static_cast<std::size_t>(i);
  positions_[k] = position_now(i);
  times_[k] = now_;
}

template <int Dim>
void GrowingSpheres<Dim>::wrap(std::int32_t i) {
  for (int axis = 0; axis < Dim; ++axis) {
    if (box_.is_closed(axis)) continue;
    double& place = position(i)[axis];
    const double side = box_.sides()[axis];
    place -= side * std::floor(place / side);
    if (!(place < side)) place = 0;
  }
}

template class GrowingSpheres<2>;
template class GrowingSpheres<3>;

}  // namespace zenosphere
