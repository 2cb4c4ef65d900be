#include "report/frames.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "storage/snapshot_motion.hpp"

namespace zenosphere {
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
      dimension_(dimension),
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
  const auto number = static_cast<std::int64_t>(frames_.step.size());
  frames_.step.push_back(static_cast<double>(snapshot.step));
  frames_.time.push_back(snapshot.time);
  frames_.granular_temperature.push_back(
      motion_of(snapshot, dimension_, shear_rate_, grains_).granular_temperature(dimension_));
  if (std::binary_search(frames_.shown.begin(), frames_.shown.end(), number)) {
    keep(snapshot);
  }
}

void FrameCollector::keep(const Snapshot& snapshot) {
  const auto append = [](auto& column, const auto& values) {
    for (const auto value : values) {
      column.push_back(static_cast<typename std::decay_t<decltype(column)>::value_type>(value));
    }
  };
  append(frames_.box_edges, snapshot.box_edges);
  append(frames_.positions, snapshot.positions);
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(spheres_); ++i) {
    const auto [x, y, z] = peculiar_velocity(snapshot, dimension_, shear_rate_, i);
    frames_.speeds.push_back(static_cast<float>(std::sqrt(x * x + y * y + z * z)));
  }
  append(frames_.collisions, counts_);
}

Frames FrameCollector::result(bool is_log_complete) && {
  if (!is_log_complete) frames_.collisions.clear();
  return std::move(frames_);
}

}  // namespace zenosphere
