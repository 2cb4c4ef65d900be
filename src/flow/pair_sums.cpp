#include "flow/pair_sums.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "flow/pair_search.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {
namespace {

constexpr double bin_width = 0.02;       // diameters
constexpr double farthest = 5;           // diameters
constexpr double widest_contact = 0.2;   // diameters
constexpr std::size_t sectors = 12;      // of half a turn
constexpr double slight_overlap = 1e-6;  // diameters: of spheres that touch, for all that is known
constexpr std::size_t share_steps = 9;   // from contact to the end of the cubic

/// Surface of a sphere: its area, its circumference, or two points.
template <int Dim>
double surface(double radius) {
  constexpr double pi = std::numbers::pi;
  return Dim == 3 ? 4 * pi * radius * radius : Dim == 2 ? 2 * pi * radius : 2;
}

/// Where g(r) of elastic spheres, which falls as exp(-(Z - 1)(r - 1)) or so, is a cubic to some
/// 1e-4: over 0.7 / (Z - 1).
///
/// Source of Z - 1 = 2^(D-1) phi g: Tonks; Henderson, Mol. Phys. 30 (1975) 971; Carnahan &
/// Starling, J. Chem. Phys. 51 (1969) 635.
template <int Dim>
double contact_range(double fraction) {
  const double phi = std::min(fraction, 0.99), free = 1 - phi;
  const double g = Dim == 1   ? 1 / free
                   : Dim == 2 ? (1 - 7.0 / 16 * phi) / (free * free)
                              : (1 - phi / 2) / (free * free * free);
  return 0.7 / ((1 << (Dim - 1)) * phi * g);
}

template <int Dim>
double solids_volume_fraction(const SampledSystem<Dim>& system) {
  constexpr double unit = Dim == 3 ? std::numbers::pi / 6 : Dim == 2 ? std::numbers::pi / 4 : 1;
  double sum = 0;
  for (std::int32_t i = 0; i < system.spheres; ++i) {
    sum += unit * std::pow(system.grains.diameter(i), Dim);
  }
  return sum / system.volume_of_box();
}

/// Weight whose integral with any cubic over [0, 1] is the value of that at 0: the sum of
/// (2k + 1) P_k(-1) P_k(2u - 1) for k = 0 to 3.
double end_weight(double u) {
  const double x = 2 * u - 1;
  return 1 - 3 * x + 5 * (3 * x * x - 1) / 2 - 7 * (5 * x * x - 3) * x / 2;
}

/// Values at even steps from 0 to 1, between which lie straight lines.
double interpolated(const std::vector<double>& values, double place) {
  const double step = place * static_cast<double>(values.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(step), values.size() - 2);
  return std::lerp(values[below], values[below + 1], step - static_cast<double>(below));
}

/// Which of the sectors of half a turn a direction, or its opposite, points to.
std::size_t sector_of(double along, double across) {
  static const auto bounds = [] {
    std::array<std::array<double, 2>, sectors - 1> directions{};
    for (std::size_t k = 1; k < sectors; ++k) {
      const double angle = std::numbers::pi * static_cast<double>(k) / sectors;
      directions[k - 1] = {std::cos(angle), std::sin(angle)};
    }
    return directions;
  }();
  const double sign = across < 0 || (across == 0 && along < 0) ? -1 : 1;
  std::size_t sector = 0;
  for (const auto& [x, y] : bounds) sector += sign * (x * across - y * along) >= 0;
  return sector;
}

}  // namespace

template <int Dim>
typename PairSums<Dim>::Bins PairSums<Dim>::bins(double first, double last) {
  constexpr double rounding = 1e-9;  // so that an exact multiple counts
  const auto count = static_cast<int>((last - first) / bin_width + rounding);
  if (count <= 0) return {first, {first, last}};
  return {first, even_edges(first, bin_width, static_cast<std::size_t>(count))};
}

template <int Dim>
std::size_t PairSums<Dim>::Bins::of(double distance) const {
  const double width = (edges.back() - first) / static_cast<double>(count());
  auto bin = std::min(static_cast<std::size_t>((distance - first) / width), count() - 1);
  if (distance < edges[bin]) --bin;
  if (bin + 1 < count() && distance >= edges[bin + 1]) ++bin;
  return bin;
}

template <int Dim>
PairSums<Dim>::PairSums(const SampledSystem<Dim>& system)
    : system_(system), are_alike_(system.grains.are_alike()) {
  const auto& diameters = system.grains.diameters;
  largest_ = system.grains.largest_diameter();
  double smallest = 1;
  if (!diameters.empty()) smallest = *std::min_element(diameters.begin(), diameters.end());
  const double last = std::min(system.reach(), farthest * largest_);
  bins_ = bins(smallest, last);
  partial_bins_ = bins(1, last / largest_);
  contact_width_ =
      std::min({contact_range<Dim>(solids_volume_fraction(system)) * smallest / largest_,
                widest_contact, last / largest_ - 1});
}

template <int Dim>
std::vector<SampledColumn> PairSums<Dim>::columns() const {
  if (!is_counted()) return {};
  const std::size_t count = bins_.count();
  std::vector<SampledColumn> columns{{"pair_counts", {count}}};
  if (!are_alike_) {
    if (system_.closed_axis) return columns;
    const std::size_t pairs = system_.pairs_of_kinds();
    columns.push_back({"partial_pair_weights", {pairs, partial_bins_.count()}});
    columns.push_back({"partial_contact_weights", {pairs}});
    return columns;
  }
  columns.push_back({"contact_values"});
  if (system_.closed_axis) columns.push_back({"share_inside", {count}});
  if (system_.shear_rate > 0) columns.push_back({"pair_counts_by_direction", {sectors, count}});
  return columns;
}

template <int Dim>
std::vector<SampledEdges> PairSums<Dim>::edges() const {
  if (!is_counted()) return {};
  std::vector<SampledEdges> edges{{"distance", bins_.edges}};
  if (!are_alike_) edges.push_back({"distance_over_mean_diameter", partial_bins_.edges});
  return edges;
}

template <int Dim>
void PairSums<Dim>::add(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const {
  if (!is_counted()) return;
  are_alike_ ? add_alike(moment, sums) : add_unlike(moment, sums);
}

template <int Dim>
void PairSums<Dim>::add_alike(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const {
  const std::size_t count = bins_.count();
  double* const pairs = sums.take(count);
  double& contact = *sums.take(1);
  if (system_.closed_axis) {
    double* const shares = sums.take(count);
    for (std::size_t n = 0; n < count; ++n) {
      shares[n] += share_inside(moment, (bins_.edges[n] + bins_.edges[n + 1]) / 2);
    }
  }
  double* const directions = system_.shear_rate > 0 ? sums.take(sectors * count) : nullptr;
  const auto shares = shares_at_contact(moment);
  double near = 0;
  const double reach = std::max(bins_.edges.back(), 1 + contact_width_);
  PairSearch<Dim>(system_, moment, reach).visit([&](auto, auto, const auto& dr, double r2) {
    double distance = std::sqrt(r2);
    if (distance < 1 && distance > 1 - slight_overlap) distance = 1;
    if (distance < 1) return;  // a start may overlap
    const double place = (distance - 1) / contact_width_;
    if (place <= 1) {
      const double shell = surface<Dim>(distance) * contact_width_ * interpolated(shares, place);
      near += 2 * end_weight(place) / shell;
    }
    if (distance > bins_.edges.back()) return;
    const std::size_t bin = bins_.of(distance);
    pairs[bin] += 2;
    if constexpr (Dim > 1) {
      if (directions) directions[sector_of(dr[0], dr[1]) * count + bin] += 2;
    }
  });
  const double others = system_.spheres - 1;
  contact += near * volume_of_centres() / (others * system_.spheres);
}

template <int Dim>
void PairSums<Dim>::add_unlike(const SampledMoment<Dim>& moment, SumsOfColumns& sums) const {
  const std::size_t count = partial_bins_.count(), kinds = system_.pairs_of_kinds();
  double* const pairs = sums.take(bins_.count());
  const bool has_partial = !system_.closed_axis;
  double* const weights = has_partial ? sums.take(kinds * count) : nullptr;
  double* const contacts = has_partial ? sums.take(kinds) : nullptr;
  const auto& grains = system_.grains;
  const double reach = std::max(
      bins_.edges.back(), largest_ * std::max(partial_bins_.edges.back(), 1 + contact_width_));
  PairSearch<Dim>(system_, moment, std::min(reach, system_.reach()))
      .visit([&](std::int32_t i, std::int32_t j, const auto&, double r2) {
        const double distance = std::sqrt(r2);
        if (distance >= bins_.first && distance <= bins_.edges.back()) {
          pairs[bins_.of(distance)] += 2;
        }
        if (!has_partial) return;
        const double sigma = (grains.diameter(i) + grains.diameter(j)) / 2;
        double x = distance / sigma;
        if (x < 1 && x > 1 - slight_overlap) x = 1;
        const std::size_t pair = system_.pair_of_kinds(i, j);
        const double ways = grains.kind(i) == grains.kind(j) ? 2 : 1;
        const double weight = ways * volume_of_centres() / std::pow(sigma, Dim);
        if (x < 1) return;
        if (x <= partial_bins_.edges.back()) weights[pair * count + partial_bins_.of(x)] += weight;
        const double place = (x - 1) / contact_width_;
        if (place > 1) return;
        contacts[pair] += weight * end_weight(place) / (surface<Dim>(x) * contact_width_);
      });
}

/// Volume in which centres of unit spheres can be: walls keep them half a diameter away.
template <int Dim>
double PairSums<Dim>::volume_of_centres() const {
  if (!system_.closed_axis) return system_.volume_of_box();
  const double side = system_.sides[*system_.closed_axis];
  return system_.volume_of_box() / side * (side - 1);
}

/// Share of the surface around a sphere where centres can be, mean over all spheres.
template <int Dim>
double PairSums<Dim>::share_inside(const SampledMoment<Dim>& moment, double distance) const {
  if (!system_.closed_axis) return 1;
  const int axis = *system_.closed_axis;
  const auto part = [&](double room) {  // on one side of the centre
    const double end = std::clamp(room / distance, 0.0, 1.0);
    if (Dim == 3) return end / 2;
    if (Dim == 2) return 0.5 - std::acos(end) / std::numbers::pi;
    return end >= 1 ? 0.5 : 0.0;
  };
  double sum = 0;
  for (const auto& place : moment.positions) {
    sum += part(place[axis] - 0.5) + part(system_.sides[axis] - 0.5 - place[axis]);
  }
  return sum / static_cast<double>(moment.positions.size());
}

/// These shares from contact to where the cubic ends; NaN where walls leave no room for a pair.
template <int Dim>
std::vector<double> PairSums<Dim>::shares_at_contact(const SampledMoment<Dim>& moment) const {
  std::vector<double> shares;
  for (std::size_t n = 0; n < share_steps; ++n) {
    const double place = static_cast<double>(n) / (share_steps - 1);
    shares.push_back(share_inside(moment, 1 + place * contact_width_));
  }
  const bool has_room = std::all_of(shares.begin(), shares.end(), [](double s) { return s > 0; });
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  return has_room ? shares : std::vector<double>(share_steps, nothing);
}

#define ZENOSPHERE_INSTANTIATE(Dim) template class PairSums<Dim>;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
