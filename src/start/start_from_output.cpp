#include "start/start_from_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "model/errors.hpp"
#include "storage/run_reader.hpp"
#include "storage/sandboxed_read.hpp"
#include "text/counted.hpp"

namespace zenosphere {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& text) {
  throw InputError(file + ": " + text);
}

void require_shape(const std::string& file, const OutputInfo& info, const Case& values) {
  const auto& system = values.system;
  if (info.snapshots < 1) refuse(file, "holds no snapshot (its run was ended too early)");
  if (info.dimension != system.dimension) {
    refuse(file, fmt::format("has {} (system.dimension = {}); make them equal",
                             counted(info.dimension, "dimension"), system.dimension));
  }
  if (info.spheres == system.spheres) return;
  refuse(file, fmt::format("has {} (system.spheres = {}); make them equal",
                           counted(info.spheres, "sphere"), system.spheres));
}

std::pair<Snapshot, Grains<double>> snapshot_in(const Case& values, const std::string& file) {
  const RunReader run(file);
  require_shape(file, run.info(), values);
  const auto number = values.start.snapshot;
  if (number && *number >= run.snapshots()) {
    refuse(file, fmt::format("has {} (start.snapshot = {}, counted from 0); choose one of them",
                             counted(run.snapshots(), "snapshot"), *number));
  }
  return {run.snapshot(number.value_or(run.snapshots() - 1)), run.grains()};
}

}  // namespace

GivenStart start_from_output(const Case& values, const std::string& file) {
  const int dimension = values.system.dimension;
  const std::int64_t components = values.system.spheres * dimension;
  const auto bytes = static_cast<std::int64_t>(2 * sizeof(double)) * components;
  sandboxed_read(file, bytes, [&] { snapshot_in(values, file); });
  auto [stored, grains] = snapshot_in(values, file);
  std::vector<double> sides;
  double offset = 0;
  for (int row = 0; row < dimension; ++row) {
    for (int column = 0; column < dimension; ++column) {
      const double edge = stored.box_edges[static_cast<std::size_t>(row * dimension + column)];
      if (row == column) sides.push_back(edge);
      const bool is_offset = row == 1 && column == 0;
      if (is_offset) offset = edge;
      if (row == column || is_offset || std::abs(edge) <= touching) continue;
      refuse(file, fmt::format("has the box edge {} beside the diagonal (only the second one may "
                               "lean, along x); it may be damaged",
                               edge));
    }
  }
  return {
      dimension, std::move(stored.positions), std::move(stored.velocities),        std::move(sides),
      offset,    std::move(grains),           std::move(stored.angular_velocities)};
}

}  // namespace zenosphere
