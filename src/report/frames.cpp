#include "report/frames.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zenosphere {
namespace {

/// Velocities without the mean flow, squared: one a sphere.
std::vector<double> squared_speeds(const Snapshot& snapshot, std::size_t dimension,
                                   double shear_rate) {
  const std::size_t spheres = snapshot.velocities.size() / dimension;
  std::vector<double> squares(spheres);
  for (std::size_t n = 0; n < spheres; ++n) {
    for (std::size_t d = 0; d < dimension; ++d) {
      double component = snapshot.velocities[n * dimension + d];
      if (d == 0 && dimension > 1) {
        const double middle = snapshot.box_edges[dimension + 1] / 2;
        component -= shear_rate * (snapshot.positions[n * dimension + 1] - middle);
      }
      squares[n] += component * component;
    }
  }
  return squares;
}

}  // namespace

std::vector<std::int64_t> spread_snapshots(std::int64_t snapshots, std::int64_t most) {
  std::vector<std::int64_t> shown;
  const std::int64_t count = std::min(snapshots, std::max<std::int64_t>(most, 2));
  for (std::int64_t n = 0; n < count; ++n) {
    shown.push_back(count == 1 ? 0 : n * (snapshots - 1) / (count - 1));
  }
  return shown;
}

FrameCollector::FrameCollector(std::int64_t spheres, int dimension, Grains<double> grains,
                               double shear_rate, std::vector<std::int64_t> shown)
    : spheres_(static_cast<std::size_t>(spheres)),
      dimension_(static_cast<std::size_t>(dimension)),
      grains_(std::move(grains)),
      shear_rate_(shear_rate),
      counts_(spheres_) {
  frames_.shown = std::move(shown);
}

void FrameCollector::observe(const CollisionRow& row) {
  for (const std::int32_t sphere : {row.i, row.j}) {
    const auto n = static_cast<std::size_t>(sphere);  // a wall, or nonsense, is no sphere
    if (sphere >= 0 && n < spheres_) ++counts_[n];
  }
}

void FrameCollector::observe(const Snapshot& snapshot) {
  std::vector<double> speeds = squared_speeds(snapshot, dimension_, shear_rate_);
  double sum = 0;
  std::int64_t mobile = 0;
  for (std::size_t n = 0; n < speeds.size(); ++n) {
    const auto sphere = static_cast<std::int32_t>(n);
    if (!grains_.is_immobile(sphere)) {
      sum += grains_.mass(sphere) * speeds[n];
      ++mobile;
    }
    speeds[n] = std::sqrt(speeds[n]);
  }
  const auto number = static_cast<std::int64_t>(frames_.step.size());
  frames_.step.push_back(static_cast<double>(snapshot.step));
  frames_.time.push_back(snapshot.time);
  frames_.granular_temperature.push_back(
      sum / (static_cast<double>(mobile) * static_cast<double>(dimension_)));
  if (std::binary_search(frames_.shown.begin(), frames_.shown.end(), number)) {
    keep(snapshot, speeds);
  }
}

void FrameCollector::keep(const Snapshot& snapshot, const std::vector<double>& speeds) {
  const auto append = [](auto& column, const auto& values) {
    for (const auto value : values) {
      column.push_back(static_cast<typename std::decay_t<decltype(column)>::value_type>(value));
    }
  };
  append(frames_.box_edges, snapshot.box_edges);
  append(frames_.positions, snapshot.positions);
  append(frames_.speeds, speeds);
  append(frames_.collisions, counts_);
}

Frames FrameCollector::result(bool is_log_complete) && {
  if (!is_log_complete) frames_.collisions.clear();
  return std::move(frames_);
}

}  // namespace zenosphere
