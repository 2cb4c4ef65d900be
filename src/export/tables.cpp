#include "export/tables.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace zenosphere {
namespace {

/// Sums over the mobile spheres of a frame, of their velocities relative to the profile, by mass.
struct Sums {
  std::array<double, 3> squares{};  ///< of each component
  double shear = 0;                 ///< x times y component
  double fastest = 0;               ///< largest square of a speed
  double turning = 0;               ///< moment of inertia times square of the angular velocity
  double mobile = 0;                ///< spheres that count
};

/// I w^2.
double turning_energy(const Frame& frame, std::int64_t i) {
  const auto [x, y, z] = frame.spin(i);
  return frame.reduced_inertia * frame.mass(i) * frame.radius(i) * frame.radius(i) *
         (x * x + y * y + z * z);
}

Sums sums_of(const Frame& frame, double shear_rate) {
  Sums sums;
  for (std::int64_t i = 0; i < frame.spheres(); ++i) {
    if (frame.is_immobile(i)) continue;
    const double mass = frame.mass(i);
    ++sums.mobile;
    if (frame.has_spins()) sums.turning += turning_energy(frame, i);
    std::array<double, 3> velocity = frame.velocity(i);
    if (frame.dimension > 1) {
      velocity[0] -= shear_rate * (frame.position(i)[1] - frame.cell.sides[1] / 2);
    }
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double part = velocity[axis] * velocity[axis];
      sums.squares[axis] += mass * part;
      square += part;
    }
    sums.shear += mass * velocity[0] * velocity[1];
    sums.fastest = std::max(sums.fastest, square);
  }
  return sums;
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

std::string observables_row(const Frame& frame, double shear_rate) {
  const Sums sums = sums_of(frame, shear_rate);
  const auto spheres = static_cast<double>(frame.spheres());
  const double all = sums.squares[0] + sums.squares[1] + sums.squares[2];
  std::string text = fmt::format("{},{},{},{},{}", frame.number, frame.snapshot.step,
                                 2 * static_cast<double>(frame.snapshot.step) / spheres,
                                 frame.snapshot.time, shear_rate * frame.snapshot.time);
  if (frame.dimension > 1) text += fmt::format(",{}", frame.cell.tilt);
  text += fmt::format(",{}", all / (sums.mobile * frame.dimension));
  for (int axis = 0; axis < frame.dimension; ++axis) {
    text += fmt::format(",{}", sums.squares[static_cast<std::size_t>(axis)] / sums.mobile);
  }
  if (frame.dimension > 1) text += fmt::format(",{}", sums.shear / sums.mobile);
  if (frame.has_spins()) {
    text += fmt::format(",{}", sums.turning / (sums.mobile * (frame.dimension == 3 ? 3 : 1)));
  }
  return text + fmt::format(",{}\n", std::sqrt(sums.fastest));
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

std::string collisions_header() { return "k,time,i,j,gap,normal_speed,flags\n"; }

std::string collisions_row(const CollisionRow& row) {
  return fmt::format(FMT_COMPILE("{},{},{},{},{},{},{}\n"), row.k, row.time, row.i, row.j, row.gap,
                     row.normal_speed, row.flags);
}

}  // namespace zenosphere
