#include "run/snapshot_of.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model/instantiate.hpp"
#include "model/offset.hpp"

namespace zenosphere {

namespace {

/// A number of boxes as files have it; one that no file can hold becomes the last that one can.
std::int32_t image_flag(double boxes) {
  using Limits = std::numeric_limits<std::int32_t>;
  return static_cast<std::int32_t>(std::clamp<double>(boxes, Limits::min(), Limits::max()));
}

}  // namespace

template <int Dim, class Real>
Snapshot snapshot_of(const Simulation<Dim, Real>& simulation) {
  const auto& box = simulation.box();
  Snapshot snapshot{.step = simulation.collisions(),
                    .time = simulation.time(),
                    .positions = {},
                    .velocities = {},
                    .box_edges = std::vector<double>(Dim * Dim, 0.0),
                    .images = {},
                    .angular_velocities = {}};
  for (int axis = 0; axis < Dim; ++axis) {
    snapshot.box_edges[static_cast<std::size_t>(axis * (Dim + 1))] =
        static_cast<double>(box.sides()[axis]);
  }
  Configuration<Dim, Real> state = simulation.configuration();
  if constexpr (Dim > 1) {
    double& offset = snapshot.box_edges[Dim];
    const double side = snapshot.box_edges[0];
    offset = reduced_offset(static_cast<double>(state.offset), side);
    const double more = std::round((static_cast<double>(state.offset) - offset) / side);
    for (auto& boxes : state.boxes) boxes[0] += boxes[1] * more;
  }
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    auto velocity = state.velocities[i];
    velocity[0] += box.profile(state.positions[i]);
    for (int axis = 0; axis < Dim; ++axis) {
      snapshot.positions.push_back(static_cast<double>(state.positions[i][axis]));
      snapshot.velocities.push_back(static_cast<double>(velocity[axis]));
      snapshot.images.push_back(image_flag(state.boxes[i][axis]));
    }
  }
  for (const auto& spin : state.spins) {
    for (const Real& component : spin.components) {
      snapshot.angular_velocities.push_back(static_cast<double>(component));
    }
  }
  return snapshot;
}

template <int Dim, class Real>
std::vector<double> peculiar_velocities_of(const Simulation<Dim, Real>& simulation) {
  std::vector<double> velocities;
  velocities.reserve(static_cast<std::size_t>(simulation.spheres()) * Dim);
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    const auto velocity = simulation.peculiar_velocity(i);
    for (int axis = 0; axis < Dim; ++axis) {
      velocities.push_back(static_cast<double>(velocity[axis]));
    }
  }
  return velocities;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                 \
  template Snapshot snapshot_of<Dim, Real>(const Simulation<Dim, Real>&); \
  template std::vector<double> peculiar_velocities_of<Dim, Real>(const Simulation<Dim, Real>&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
