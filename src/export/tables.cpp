#include "export/tables.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zenosphere {
namespace {

/// Sums over the spheres of a frame, of their velocities relative to the profile.
struct Sums {
  std::array<double, 3> squares{};  ///< of each component
  double shear = 0;                 ///< x times y component
  double fastest = 0;               ///< largest square of a speed
};

Sums sums_of(const Frame& frame, double shear_rate) {
  Sums sums;
  for (std::int64_t i = 0; i < frame.spheres(); ++i) {
    std::array<double, 3> velocity = frame.velocity(i);
    if (frame.dimension > 1) {
      velocity[0] -= shear_rate * (frame.position(i)[1] - frame.cell.sides[1] / 2);
    }
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double part = velocity[axis] * velocity[axis];
      sums.squares[axis] += part;
      square += part;
    }
    sums.shear += velocity[0] * velocity[1];
    sums.fastest = std::max(sums.fastest, square);
  }
  return sums;
}

}  // namespace

std::string observables_header(int dimension) {
  std::string text = "snapshot,collisions,collisions_per_sphere,time,strain";
  if (dimension > 1) text += ",offset";
  text += ",granular_temperature";
  for (int axis = 0; axis < dimension; ++axis) {
    text += fmt::format(",temperature_{}", "xyz"[axis]);
  }
  if (dimension > 1) text += ",temperature_xy";
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
  text += fmt::format(",{}", all / (spheres * frame.dimension));
  for (int axis = 0; axis < frame.dimension; ++axis) {
    text += fmt::format(",{}", sums.squares[static_cast<std::size_t>(axis)] / spheres);
  }
  if (frame.dimension > 1) text += fmt::format(",{}", sums.shear / spheres);
  return text + fmt::format(",{}\n", std::sqrt(sums.fastest));
}

std::string collisions_header() { return "k,time,i,j,gap,normal_speed,flags\n"; }

std::string collisions_row(const CollisionRow& row) {
  return fmt::format(FMT_COMPILE("{},{},{},{},{},{},{}\n"), row.k, row.time, row.i, row.j, row.gap,
                     row.normal_speed, row.flags);
}

}  // namespace zenosphere
