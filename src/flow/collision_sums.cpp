#include "flow/collision_sums.hpp"

#include <cmath>
#include <numbers>

#include "model/instantiate.hpp"

namespace zenosphere {
namespace {

constexpr std::size_t in_a_decade = 10;  // bins
constexpr std::size_t angle_bins = 45;   // of 2 degrees

/// Bins of equal width in the logarithm, a tenth of a decade.
struct Decades {
  int first, last;  ///< powers of ten
  std::size_t bins() const { return static_cast<std::size_t>(last - first) * in_a_decade; }
};
constexpr Decades flight_decades{-17, 6}, speed_decades{-12, 6};

std::vector<double> edges_of(const Decades& decades) {
  std::vector<double> edges;
  for (std::size_t n = 0; n <= decades.bins(); ++n) {
    edges.push_back(std::pow(10, decades.first + static_cast<double>(n) / in_a_decade));
  }
  return edges;
}

/// Counts a value, and adds 1, itself, and 1 if it lies below all bins, to its moments.
void count_in_decades(const Decades& decades, double value, double* counts, double* moments) {
  moments[0] += 1;
  moments[1] += value;
  const double place = (std::log10(value) - decades.first) * in_a_decade;
  if (!(place >= 0)) {
    moments[2] += 1;
  } else if (place < static_cast<double>(decades.bins())) {
    ++counts[static_cast<std::size_t>(place)];
  }
}

}  // namespace

template <int Dim, class Real>
CollisionSums<Dim, Real>::CollisionSums(const SampledSystem<Dim>& system,
                                        const Simulation<Dim, Real>& simulation)
    : system_(system),
      layers_(system),
      clock_unit_(simulation.box().clock_unit()),
      last_(static_cast<std::size_t>(system.spheres)),
      has_collided_(last_.size()) {}

template <int Dim, class Real>
std::vector<SampledColumn> CollisionSums<Dim, Real>::columns() const {
  const std::size_t count = layers_.count, d = Dim;
  std::vector<SampledColumn> columns{{"flight_time_counts", {flight_decades.bins()}},
                                     {"flight_time_moments", {3}},
                                     {"normal_speed_counts", {speed_decades.bins()}},
                                     {"normal_speed_moments", {3}},
                                     {"layer_collisional", {count, d, d}},
                                     {"layer_collisions", {count}},
                                     {"layer_dissipation", {count}},
                                     {"impact_angle_counts", {angle_bins}}};
  if (!system_.grains.are_alike()) {
    columns.push_back({"collisions_of_kinds", {system_.pairs_of_kinds()}});
    columns.push_back({"dissipation_of_kinds", {system_.pairs_of_kinds()}});
  }
  return columns;
}

template <int Dim, class Real>
std::vector<SampledEdges> CollisionSums<Dim, Real>::edges() const {
  return {{"flight_time", edges_of(flight_decades)},
          {"normal_speed", edges_of(speed_decades)},
          {"impact_angle", even_edges(0, std::numbers::pi / 2 / angle_bins, angle_bins)}};
}

template <int Dim, class Real>
void CollisionSums<Dim, Real>::observe(const Collision<Dim, Real>& collision,
                                       const Simulation<Dim, Real>& simulation, double* sums) {
  const bool is_pair = !simulation.wall(collision.j);
  double *flights = nullptr, *moments = nullptr;
  if (sums) {
    SumsOfColumns columns(sums);
    flights = columns.take(flight_decades.bins());
    moments = columns.take(3);
    double* const speeds = columns.take(speed_decades.bins());
    count_in_decades(speed_decades, static_cast<double>(collision.impact.normal_speed), speeds,
                     columns.take(3));
    const auto height =
        static_cast<double>(simulation.place_across_flow(collision.i)[layers_.axis]);
    add_transfer(collision, height, columns.take(layers_.count * Dim * Dim));
    if (is_pair) add_pair(collision, simulation, columns);
  }
  add_flight(collision.i, collision, flights, moments);
  if (is_pair) add_flight(collision.j, collision, flights, moments);
}

/// Ends the flight of a sphere; its first one, of which the beginning is not known, counts not.
template <int Dim, class Real>
void CollisionSums<Dim, Real>::add_flight(std::int32_t sphere,
                                          const Collision<Dim, Real>& collision, double* counts,
                                          double* moments) {
  const auto n = static_cast<std::size_t>(sphere);
  if (counts && has_collided_[n]) {
    const auto flight = static_cast<double>(elapsed(last_[n], collision.time, clock_unit_));
    count_in_decades(flight_decades, flight, counts, moments);
  }
  last_[n] = collision.time;
  has_collided_[n] = 1;
}

template <int Dim, class Real>
void CollisionSums<Dim, Real>::add_pair(const Collision<Dim, Real>& collision,
                                        const Simulation<Dim, Real>& simulation,
                                        SumsOfColumns& sums) const {
  const auto& impact = collision.impact;
  const auto& grains = simulation.grains();
  const Real inverse = grains.inverse_mass(collision.i) + grains.inverse_mass(collision.j);
  const auto loss = static_cast<double>(
      Real(impact.impulse * (impact.normal_speed - impact.impulse * inverse / 2)) +
      collision.friction_loss);
  const Real height = simulation.place_across_flow(collision.i)[layers_.axis] +
                      impact.normal[layers_.axis] * grains.radius(collision.i);
  const std::size_t layer = layers_.at(static_cast<double>(height));
  sums.take(layers_.count)[layer] += 1;
  sums.take(layers_.count)[layer] += loss;
  const double angle = impact_angle(collision, simulation) / (std::numbers::pi / 2);
  const auto bin = static_cast<std::size_t>(angle * angle_bins);
  sums.take(angle_bins)[std::min(bin, angle_bins - 1)] += 1;
  if (system_.grains.are_alike()) return;
  const std::size_t pair = system_.pair_of_kinds(collision.i, collision.j);
  sums.take(system_.pairs_of_kinds())[pair] += 1;
  sums.take(system_.pairs_of_kinds())[pair] += loss;
}

/// Adds r_a J_b to the layers through which the line from centre to centre leads, to each its part
/// of the way.
///
/// Source: Irving & Kirkwood, J. Chem. Phys. 18 (1950) 817.
template <int Dim, class Real>
void CollisionSums<Dim, Real>::add_transfer(const Collision<Dim, Real>& collision, double height,
                                            double* transfer) const {
  const auto& impact = collision.impact;
  const auto step = static_cast<double>(impact.normal[layers_.axis] * impact.distance);
  const auto add = [&](double place, double part) {
    const std::size_t first = layers_.at(place) * Dim * Dim;
    for (int a = 0; a < Dim; ++a) {
      for (int b = 0; b < Dim; ++b) {
        transfer[first + static_cast<std::size_t>(a * Dim + b)] -=
            part * static_cast<double>(impact.normal[a] * impact.distance * collision.change[b]);
      }
    }
  };
  const double low = std::min(height, height + step), high = std::max(height, height + step);
  const double width = layers_.width();
  const double first = std::floor(low / width), last = std::floor(high / width);
  if (first == last) return add(low, 1);
  for (double layer = first; layer <= last; ++layer) {
    const double begin = std::max(low, layer * width), end = std::min(high, (layer + 1) * width);
    add((layer + 0.5) * width, std::max(end - begin, 0.0) / (high - low));
  }
}

/// Angle between the relative velocity and the line of centres, in [0, pi/2]; 0: head-on.
template <int Dim, class Real>
double CollisionSums<Dim, Real>::impact_angle(const Collision<Dim, Real>& collision,
                                              const Simulation<Dim, Real>& simulation) const {
  if constexpr (Dim == 1) return 0;
  const auto& grains = simulation.grains();
  const auto& impact = collision.impact;
  const auto before_i = simulation.peculiar_velocity(collision.i) -
                        collision.change * grains.inverse_mass(collision.i);
  const auto before_j = simulation.peculiar_velocity(collision.j) +
                        collision.change * grains.inverse_mass(collision.j);
  auto relative = before_j - before_i;
  if constexpr (Dim > 1) {
    relative[0] += simulation.box().shear_rate() * impact.normal[1] * impact.distance;
  }
  const auto along = static_cast<double>(dot(relative, impact.normal));
  const auto square = static_cast<double>(dot(relative, relative));
  const double across = std::sqrt(std::max(square - along * along, 0.0));
  return std::atan2(across, std::abs(along));
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class CollisionSums<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
