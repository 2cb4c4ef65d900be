#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation.hpp"

namespace zenosphere {

/// What of a system does not change from sample to sample, in `double`.
template <int Dim>
struct SampledSystem {
  std::int32_t spheres;
  Vec<Dim, double> sides;          ///< diameters
  std::optional<int> closed_axis;  ///< between walls
  double shear_rate;               ///< 1/time
  Grains<double> grains;

  template <class Real>
  static SampledSystem of(const Simulation<Dim, Real>& simulation) {
    const auto& box = simulation.box();
    SampledSystem system{
        simulation.spheres(), {}, box.closed_axis(), static_cast<double>(box.shear_rate()), {}};
    for (int axis = 0; axis < Dim; ++axis)
      system.sides[axis] = static_cast<double>(box.sides()[axis]);
    const auto& grains = simulation.grains();
    for (const Real& each : grains.diameters)
      system.grains.diameters.push_back(static_cast<double>(each));
    for (const Real& each : grains.masses)
      system.grains.masses.push_back(static_cast<double>(each));
    system.grains.kinds = grains.kinds;
    system.grains.immobile = grains.immobile;
    return system;
  }

  std::size_t kinds() const { return static_cast<std::size_t>(grains.kind_count()); }
  /// Unordered pairs of kinds: (0, 0), (0, 1), ..., (1, 1), ...
  std::size_t pairs_of_kinds() const { return kinds() * (kinds() + 1) / 2; }
  std::size_t pair_of_kinds(std::int32_t i, std::int32_t j) const {
    const auto [a, b] = std::minmax({grains.kind(i), grains.kind(j)});
    const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
    return first * kinds() - first * (first + 1) / 2 + second;
  }

  /// Across which profiles are taken: the normal of the walls, else the gradient.
  int profile_axis() const { return closed_axis.value_or(std::min(Dim - 1, 1)); }

  /// Half the shortest periodic side: within it two spheres meet in one image at most.
  double reach() const {
    if (Dim == 1 && closed_axis) return sides[0];
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < Dim; ++axis) {
      if (closed_axis != axis) least = std::min(least, sides[axis]);
    }
    return least / 2;
  }

  double volume_of_box() const {
    double product = 1;
    for (int axis = 0; axis < Dim; ++axis) product *= sides[axis];
    return product;
  }
};

/// The spheres at the moment of a sample.
template <int Dim>
struct SampledMoment {
  std::vector<Vec<Dim, double>> positions{};   ///< in [0, side), diameters
  std::vector<Vec<Dim, double>> velocities{};  ///< relative to the imposed profile
  double offset = 0;                           ///< of Lees and Edwards, diameters

  template <class Real>
  static SampledMoment of(const Simulation<Dim, Real>& simulation) {
    const auto in_double = [](const Vec<Dim, Real>& vector) {
      Vec<Dim, double> rounded;
      for (int axis = 0; axis < Dim; ++axis) rounded[axis] = static_cast<double>(vector[axis]);
      return rounded;
    };
    const auto state = simulation.configuration();
    SampledMoment moment{{}, {}, static_cast<double>(state.offset)};
    moment.positions.reserve(state.positions.size());
    moment.velocities.reserve(state.velocities.size());
    for (const auto& place : state.positions) moment.positions.push_back(in_double(place));
    for (const auto& velocity : state.velocities) moment.velocities.push_back(in_double(velocity));
    return moment;
  }
};

/// A quantity whose sums over the samples are kept: its name, and the shape of one of its rows.
struct SampledColumn {
  std::string name;
  std::vector<std::size_t> shape{};  ///< empty: a number

  std::size_t size() const {
    std::size_t size = 1;
    for (const std::size_t extent : shape) size *= extent;
    return size;
  }
};

/// Where the bins of a quantity begin and end.
struct SampledEdges {
  std::string name;
  std::vector<double> values;
};

/// Edges of `bins` bins of equal width.
inline std::vector<double> even_edges(double first, double width, std::size_t bins) {
  std::vector<double> edges;
  for (std::size_t n = 0; n <= bins; ++n) edges.push_back(first + static_cast<double>(n) * width);
  return edges;
}

/// Gives out the room for columns one after the other, in the order of `columns()`.
class SumsOfColumns {
 public:
  explicit SumsOfColumns(double* first) : next_(first) {}
  double* take(std::size_t size) {
    double* const begin = next_;
    next_ += size;
    return begin;
  }

 private:
  double* next_;
};

}  // namespace zenosphere
