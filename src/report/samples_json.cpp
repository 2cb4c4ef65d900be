#include "report/samples_json.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "case/case_box.hpp"

namespace zenosphere {
namespace {

using Numbers = std::vector<double>;

/// What a run has accumulated, over all of its rows.
class Totals {
 public:
  explicit Totals(const RecordedSamples& samples) : samples_(samples) {}

  bool has(const std::string& name) const { return column(name) != nullptr; }

  /// Sums of a column; empty where there is none.
  Numbers of(const std::string& name) const {
    const auto* const found = column(name);
    if (!found) return {};
    const auto size = static_cast<std::size_t>(found->numbers_a_row());
    Numbers sums(size);
    for (std::size_t n = 0; n < found->values.size(); ++n) sums[n % size] += found->values[n];
    return sums;
  }
  double number(const std::string& name) const {
    const Numbers sums = of(name);
    return sums.empty() ? 0 : sums.front();
  }

  /// Edges of the bins of a quantity; empty where there is none.
  Numbers edges(const std::string& name) const {
    for (const auto& each : samples_.edges) {
      if (each.name == name) return each.values;
    }
    return {};
  }

 private:
  const RecordedSeries::Column* column(const std::string& name) const {
    const auto& all = samples_.sums.columns;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
  }

  const RecordedSamples& samples_;
};

Numbers middles(const Numbers& edges) {
  Numbers found;
  for (std::size_t n = 1; n < edges.size(); ++n) found.push_back((edges[n - 1] + edges[n]) / 2);
  return found;
}

/// Volume (area, length) of a sphere.
double ball(int dimension, double radius) {
  constexpr double pi = std::numbers::pi;
  if (dimension == 1) return 2 * radius;
  return dimension == 2 ? pi * radius * radius : 4 * pi / 3 * radius * radius * radius;
}

double volume_of(const std::vector<double>& sides) {
  return std::accumulate(sides.begin(), sides.end(), 1.0, std::multiplies<>());
}

Json radial_json(const Totals& totals, const Case& values) {
  const Numbers edges = totals.edges("distance");
  const Numbers counts = totals.of("pair_counts"), shares = totals.of("share_inside");
  if (counts.size() + 1 != edges.size()) return {};
  const auto sides = box_sides(values);
  double volume = volume_of(sides);  // in which centres of unit spheres can be
  if (const auto closed = closed_axis(values)) {
    const double side = sides[static_cast<std::size_t>(*closed)];
    volume *= (side - 1) / side;
  }
  const auto spheres = static_cast<double>(values.system.spheres);
  const double samples = totals.number("samples"), pairs = spheres * (spheres - 1);
  Numbers g;
  for (std::size_t n = 0; n < counts.size(); ++n) {
    const double shell =
        ball(values.system.dimension, edges[n + 1]) - ball(values.system.dimension, edges[n]);
    const double share = n < shares.size() ? shares[n] : samples;
    g.push_back(counts[n] * volume / (pairs * shell * share));
  }
  return {{"r", middles(edges)}, {"g", g}};
}

/// Up to where anything was counted.
Json velocity_json(const Totals& totals, const Case& values) {
  const Numbers counts = totals.of("component_counts");
  const Numbers places = middles(totals.edges("velocity_component"));
  const double number = totals.number("velocities") * values.system.dimension;
  if (counts.empty() || counts.size() != places.size() || number == 0) return {};
  const double width = places[1] - places[0];
  double fastest = 0;
  for (std::size_t n = 0; n < counts.size(); ++n) {
    if (counts[n] > 0) fastest = std::max(fastest, std::abs(places[n]));
  }
  Numbers shown, density, maxwell;
  for (std::size_t n = 0; n < counts.size(); ++n) {
    const double v = places[n];
    if (std::abs(v) > fastest) continue;
    shown.push_back(v);
    density.push_back(counts[n] / (number * width));
    maxwell.push_back(std::exp(-v * v / 2) / std::sqrt(2 * std::numbers::pi));
  }
  return {{"component", shown}, {"density", density}, {"maxwell", maxwell}};
}

/// Solids fraction, velocity along x and temperature of each layer.
Json profiles_json(const Totals& totals, const Case& values) {
  const Numbers edges = totals.edges("layer"), spheres = totals.of("layer_spheres");
  const Numbers mass = totals.of("layer_mass"), momentum = totals.of("layer_momentum");
  const Numbers kinetic = totals.of("layer_kinetic"), diameters = totals.of("layer_diameters");
  const auto d = static_cast<std::size_t>(values.system.dimension);
  const std::size_t layers = spheres.size();
  if (layers == 0 || edges.size() != layers + 1 || mass.size() != layers ||
      momentum.size() != layers * d || kinetic.size() != layers * d * d || diameters.empty()) {
    return {};
  }
  const auto closed = closed_axis(values);
  const int axis = closed.value_or(std::min(values.system.dimension - 1, 1));
  const bool is_sheared = values.drive.kind == DriveKind::shear;
  const std::size_t kinds = diameters.size() / layers;
  const double layer = volume_of(box_sides(values)) / static_cast<double>(layers);
  const double unit = ball(values.system.dimension, 0.5) / layer / totals.number("samples");
  const Numbers y = middles(edges);
  Numbers fraction, velocity, temperature;
  for (std::size_t n = 0; n < layers; ++n) {
    double square = 0, energy = 0, solids = 0;
    for (std::size_t a = 0; a < d; ++a) {
      square += momentum[n * d + a] * momentum[n * d + a];
      energy += kinetic[n * d * d + a * d + a];
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) solids += diameters[n * kinds + kind];
    fraction.push_back(solids * unit);
    const double imposed = is_sheared ? values.drive.shear_rate * (y[n] - edges.back() / 2) : 0;
    velocity.push_back(momentum[n * d] / mass[n] + imposed);
    temperature.push_back((energy - square / mass[n]) / (static_cast<double>(d) * spheres[n]));
  }
  return {{"axis", std::string(1, axis_letter(axis))},
          {"y", y},
          {"solids_volume_fraction", fraction},
          {"velocity", velocity},
          {"granular_temperature", temperature}};
}

}  // namespace

Json samples_json(const RecordedSamples& samples, const Case& values) {
  const Totals totals(samples);
  const double number = totals.number("samples");
  if (samples.sums.time.empty() || number == 0) return {};
  const double span = totals.number("span"), last = samples.sums.time.back();
  return {{"samples", number},
          {"from_time", last - span},
          {"to_time", last},
          {"radial_distribution", radial_json(totals, values)},
          {"velocity_distribution", velocity_json(totals, values)},
          {"profiles", profiles_json(totals, values)}};
}

}  // namespace zenosphere
