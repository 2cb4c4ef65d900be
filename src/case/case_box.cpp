#include "case/case_box.hpp"

#include <cmath>
#include <functional>
#include <numeric>

#include "engine/box_side.hpp"
#include "model/power.hpp"

namespace zenosphere {
namespace {

/// Side of the cube, square or line that the spheres of a case fill to `fraction`: unit spheres
/// would fill less of it where they are smaller in the mean.
double cube_side(const Case& values, double fraction) {
  const auto spheres = values.system.spheres;
  const double of_unit_spheres = fraction / values.system.sizes.mean_power;
  if (values.system.dimension == 1) return box_side<1>(spheres, of_unit_spheres);
  if (values.system.dimension == 2) return box_side<2>(spheres, of_unit_spheres);
  return box_side<3>(spheres, of_unit_spheres);
}

double volume_of(const std::vector<double>& sides) {
  return std::accumulate(sides.begin(), sides.end(), 1.0, std::multiplies<>());
}

}  // namespace

std::vector<double> box_sides(const Case& values) {
  const auto& system = values.system;
  if (!system.sides.empty()) return system.sides;
  const bool is_line = system.dimension == 1;
  const double ratio = is_line ? 1 : system.aspect_ratio;
  const double other = cube_side(values, system.solids_volume_fraction * ratio);
  std::vector<double> sides(static_cast<std::size_t>(system.dimension), other);
  sides.front() = ratio * other;
  return sides;
}

double mean_side(const Case& values) {
  const auto& sides = values.system.sides;
  if (sides.empty()) return cube_side(values, values.system.solids_volume_fraction);
  return std::pow(volume_of(sides), 1.0 / static_cast<double>(sides.size()));
}

double filled_fraction(const Case& values) {
  const double sphere = unit_sphere_volume(values.system.dimension);
  const double spheres =
      static_cast<double>(values.system.spheres) * values.system.sizes.mean_power;
  return spheres * sphere / volume_of(box_sides(values));
}

std::optional<int> closed_axis(const Case& values) {
  if (!values.walls.axis) return std::nullopt;
  return static_cast<int>(*values.walls.axis);
}

char axis_letter(int axis) { return "xyz"[axis]; }

}  // namespace zenosphere
