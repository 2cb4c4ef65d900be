#include "export/tables.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "storage/snapshot_motion.hpp"

namespace zenosphere {
namespace {

/// Sum of I w^2 over the mobile spheres.
double turning_of(const Frame& frame) {
  double sum = 0;
  for (std::int64_t i = 0; i < frame.spheres(); ++i) {
    if (frame.is_immobile(i)) continue;
    const auto [x, y, z] = frame.spin(i);
    sum += frame.reduced_inertia * frame.mass(i) * frame.radius(i) * frame.radius(i) *
           (x * x + y * y + z * z);
  }
  return sum;
}

std::string component_text(const RecordedSeries::Column& column, std::size_t component) {
  constexpr std::string_view axes = "xyz";
  if (column.shape.empty()) return "";
  if (column.shape.size() == 2) {
    const auto extent = static_cast<std::size_t>(column.shape[1]);
    return fmt::format("_{}{}", axes.at(component / extent), axes.at(component % extent));
  }
  if (column.name == "temperature_diagonal") return fmt::format("_{}", axes.at(component));
  return fmt::format("_{}", component);
}

}  // namespace

std::string observables_header(int dimension, bool turns) {
  std::string text = "snapshot,collisions,collisions_per_sphere,time,strain";
  if (dimension > 1) text += ",offset";
  text += ",granular_temperature";
  for (int axis = 0; axis < dimension; ++axis) {
    text += fmt::format(",temperature_{}", "xyz"[axis]);
  }
  if (dimension > 1) text += ",temperature_xy";
  if (turns) text += ",rotational_temperature";
  return text + ",fastest\n";
}

void append_observables(NewFile& file, const Frame& frame) {
  const Grains<double> alike;
  const SnapshotMotion motion = motion_of(frame.snapshot, frame.dimension, frame.shear_rate,
                                          frame.grains ? *frame.grains : alike);
  const auto spheres = static_cast<double>(frame.spheres());
  std::string text = fmt::format("{},{},{},{},{}", frame.number, frame.snapshot.step,
                                 2 * static_cast<double>(frame.snapshot.step) / spheres,
                                 frame.snapshot.time, frame.shear_rate * frame.snapshot.time);
  if (frame.dimension > 1) text += fmt::format(",{}", frame.cell.tilt);
  text += fmt::format(",{}", motion.granular_temperature(frame.dimension));
  for (int axis = 0; axis < frame.dimension; ++axis) {
    text += fmt::format(",{}", motion.squares[static_cast<std::size_t>(axis)] / motion.mobile);
  }
  if (frame.dimension > 1) text += fmt::format(",{}", motion.shear / motion.mobile);
  if (frame.has_spins()) {
    text +=
        fmt::format(",{}", turning_of(frame) / (motion.mobile * (frame.dimension == 3 ? 3 : 1)));
  }
  text += fmt::format(",{}\n", std::sqrt(motion.fastest));
  file.write(text);
}

std::string series_header(const RecordedSeries& series) {
  std::string text = "step,time";
  for (const RecordedSeries::Column& column : series.columns) {
    for (std::size_t k = 0; k < column.numbers_a_row(); ++k) {
      text += ',' + column.name + component_text(column, k);
    }
  }
  return text + '\n';
}

std::string series_row(const RecordedSeries& series, std::size_t row) {
  std::string text = fmt::format("{},{}", series.step[row], series.time[row]);
  for (const RecordedSeries::Column& column : series.columns) {
    const std::size_t count = column.numbers_a_row();
    for (std::size_t k = 0; k < count; ++k) {
      text += fmt::format(",{}", column.values[row * count + k]);
    }
  }
  return text + '\n';
}

std::string collisions_header() {
  std::string text;
  CollisionRows::fields(CollisionRows(), [&](const char* name, const auto&, auto) {
    if (!text.empty()) text += ',';
    text += name;
  });
  text += '\n';
  return text;
}

std::string collisions_row(const CollisionRow& row) {
  std::string text;
  CollisionRows::fields(CollisionRows(), [&](const char*, const auto&, auto part) {
    fmt::format_to(std::back_inserter(text), FMT_COMPILE("{},"), row.*part);
  });
  text.back() = '\n';
  return text;
}

}  // namespace zenosphere
