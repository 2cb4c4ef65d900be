#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "case/case_box.hpp"
#include "case/case_cells.hpp"
#include "case/case_rules.hpp"
#include "case/case_table.hpp"
#include "model/shear_box.hpp"

namespace zenosphere::case_format {
namespace {

using Objection = std::optional<std::string>;

/// Densest packing in 1, 2 and 3 dimensions, rounded down: rods, a triangular lattice of disks
/// (pi / (2 sqrt 3) = 0.9068997) and close-packed spheres (pi / (3 sqrt 2) = 0.7404805).
constexpr std::array densest_packing{1.0, 0.90689, 0.74048};

/// Densest random arrangement: where spheres and disks that grow jam (engine/growth.cpp), a little
/// earlier or later by chance; rods need only some room.
constexpr std::array densest_random{0.95, 0.85, 0.64};

double in_dimension(const std::array<double, 3>& densest, const Case& values) {
  return densest[static_cast<std::size_t>(values.system.dimension) - 1];
}

/// A number in six digits, or in as many as it takes to see that it is not the limit.
std::string told_apart(double number, double limit) {
  for (int digits = 6; digits < 17; ++digits) {
    std::string text = fmt::format("{:.{}g}", number, digits);
    if ((std::stod(text) < limit) == (number < limit) && std::stod(text) != limit) return text;
  }
  return fmt::format("{}", number);
}

bool is_lattice(const Case& values) { return values.start.arrangement == Arrangement::fcc; }

/// What a side must be longer than: two cells for the largest spheres, or one of them between
/// walls.
double least_side_of(const Case& values, int axis) {
  return least_side(closed_axis(values) == axis) * std::max(1.0, values.system.sizes.largest);
}

bool are_alike(const Case& values) {
  return values.system.sizes.smallest == values.system.sizes.largest;
}

/// The first axis along which the box is too narrow, if there is one.
std::optional<int> narrow_axis(const Case& values) {
  const std::vector<double> sides = box_sides(values);
  for (int axis = 0; axis < values.system.dimension; ++axis) {
    if (!(sides[static_cast<std::size_t>(axis)] > least_side_of(values, axis))) return axis;
  }
  return std::nullopt;
}

/// Whether the box can hold its spheres, or it is not yet known how large it is.
bool box_is_wide_enough(std::int64_t spheres, const Case& values) {
  const auto& system = values.system;
  constexpr double thinnest = 1e-100;  // far beyond the largest box
  const double densest =
      system.dimension > 0 && are_alike(values) ? in_dimension(densest_packing, values) : 1;
  const bool is_known = system.dimension > 0 && system.solids_volume_fraction > thinnest &&
                        system.solids_volume_fraction <= densest;
  if (!is_known || !system.sides.empty()) return true;
  Case box;
  box.system = system;
  box.system.spheres = spheres;
  box.walls = values.walls;
  return !narrow_axis(box);
}

std::int64_t fcc_places(std::int64_t cells_a_side) {
  return 4 * cells_a_side * cells_a_side * cells_a_side;
}

/// Smallest number of spheres >= `from` that the arrangement can place in a box wide enough.
std::int64_t fewest_spheres(std::int64_t from, const Case& values) {
  std::int64_t steps = 0;
  const auto spheres = [&] { return is_lattice(values) ? fcc_places(steps) : steps; };
  while (spheres() < from || !box_is_wide_enough(spheres(), values)) ++steps;
  return spheres();
}

/// `; use 4000 or 5324`: the full lattices nearest to the number of spheres asked for.
std::string nearest_full_lattices(const Case& values) {
  const auto most = static_cast<std::int64_t>(key_named("system", "spheres")->range.high);
  std::int64_t cells = 0;
  while (fcc_places(cells + 1) < values.system.spheres) ++cells;
  const std::int64_t below = fcc_places(cells);
  const std::int64_t above = fewest_spheres(below + 1, values);
  const bool below_fits = below > 0 && box_is_wide_enough(below, values);
  if (!below_fits) return fmt::format("; use {}", above);
  if (above > most) return fmt::format("; use {}", below);
  return fmt::format("; use {} or {}", below, above);
}

std::int64_t cells_a_side(std::int64_t spheres) {
  std::int64_t cells = 1;
  while (fcc_places(cells) < spheres) ++cells;
  return cells;
}

Objection walls_in_no_dimension(const Case& values) {
  const int dimension = values.system.dimension;
  if (closed_axis(values).value_or(0) < dimension) return std::nullopt;
  const std::string_view axes = dimension == 1 ? "x only" : "x and y";
  return fmt::format("(system.dimension = {} has {})", dimension, axes);
}

Objection lattice_in_other_dimension(const Case& values) {
  if (!is_lattice(values) || values.system.dimension == 3) return std::nullopt;
  return fmt::format("(a lattice in 3 dimensions, system.dimension = {}); use \"random\"",
                     values.system.dimension);
}

/// May be asked before the density is known: every box is wide enough then.
Objection lattice_not_full(const Case& values) {
  const std::int64_t spheres = values.system.spheres;
  if (!is_lattice(values) || fcc_places(cells_a_side(spheres)) == spheres) return std::nullopt;
  return "(fcc fills 4 n^3 places)" + nearest_full_lattices(values);
}

Objection sphere_alone(const Case& values) {
  if (values.system.spheres > 1 || values.walls.axis) return std::nullopt;
  return "(must be at least 2 where there are no walls); use 2 or add [walls]";
}

Objection wrong_number_of_sides(const Case& values) {
  const auto& sides = values.system.sides;
  const int dimension = values.system.dimension;
  if (sides.empty() || sides.size() == static_cast<std::size_t>(dimension)) return std::nullopt;
  return fmt::format("(number of sides = {}, system.dimension = {}); make them equal", sides.size(),
                     dimension);
}

Objection denser_than_packed(const Case& values) {
  const double fraction = values.system.solids_volume_fraction;
  if (values.system.dimension == 1 && fraction == 1) return "(must be below 1; rods need room)";
  const double densest = in_dimension(densest_packing, values);
  if (fraction <= densest || !are_alike(values)) return std::nullopt;
  const std::string_view what = values.system.dimension == 2 ? "disks" : "spheres";
  return fmt::format("(must be in (0, {}]; {} cannot be packed denser)", densest, what);
}

Objection too_dense_for_random(const Case& values) {
  const double densest = in_dimension(densest_random, values);
  const bool random = values.start.arrangement == Arrangement::random && are_alike(values);
  if (!random || values.system.solids_volume_fraction <= densest) return std::nullopt;
  return fmt::format("(must be in (0, {}] for start.arrangement = \"random\")", densest);
}

Objection lattice_is_stretched(const Case& values) {
  if (!is_lattice(values) || values.system.aspect_ratio == 1) return std::nullopt;
  return "(fcc fills a cube); remove it or use start.arrangement = \"random\"";
}

Objection lattice_in_a_cuboid(const Case& values) {
  const auto& sides = values.system.sides;
  const auto differ = [&](double side) { return side != sides.front(); };
  if (!is_lattice(values) || std::none_of(sides.begin(), sides.end(), differ)) return std::nullopt;
  return "(fcc fills a cube); make them equal or use start.arrangement = \"random\"";
}

/// The smallest fraction at which no side of the box is too long.
double least_fraction(const Case& values) {
  const int dimension = values.system.dimension;
  const double ratio = dimension == 1 ? 1 : values.system.aspect_ratio;
  const double other = ratio < 1 ? largest_side : largest_side / ratio;
  double volume = ratio * other;
  for (int axis = 1; axis < dimension; ++axis) volume *= other;
  Case largest;
  largest.system.dimension = dimension;
  largest.system.spheres = values.system.spheres;
  largest.system.sizes = values.system.sizes;
  largest.system.sides = {volume};
  return filled_fraction(largest);
}

Objection box_too_long(const Case& values) {
  if (!values.system.sides.empty()) return std::nullopt;
  const double least = least_fraction(values);
  if (!(values.system.solids_volume_fraction < least)) return std::nullopt;
  constexpr double above_rounding = 1.006;  // of three digits
  return fmt::format("(a side of the box would be above {} diameters); use at least {:.3g}",
                     largest_side, above_rounding * least);
}

/// `the box side would be 1.9 diameters, must be above 2.02`
std::string narrowness(const Case& values, int axis) {
  const auto& system = values.system;
  const double side = box_sides(values)[static_cast<std::size_t>(axis)];
  const double least = least_side_of(values, axis);
  const bool is_cube = system.sides.empty() && system.aspect_ratio == 1 && !values.walls.axis;
  return fmt::format("the box side{} {} {} diameters, must be above {}",
                     is_cube ? "" : fmt::format(" along {}", axis_letter(axis)),
                     system.sides.empty() ? "would be" : "is",
                     system.sides.empty() ? told_apart(side, least) : fmt::format("{}", side),
                     least);
}

Objection too_few_for_the_box(const Case& values) {
  if (!values.system.sides.empty()) return std::nullopt;
  const auto axis = narrow_axis(values);
  if (!axis) return std::nullopt;
  const std::int64_t fewest = fewest_spheres(values.walls.axis ? 1 : 2, values);
  return fmt::format("({}); use at least {}", narrowness(values, *axis), fewest);
}

Objection sides_too_short(const Case& values) {
  if (values.system.sides.empty()) return std::nullopt;
  const auto axis = narrow_axis(values);
  return axis ? Objection(fmt::format("({})", narrowness(values, *axis))) : std::nullopt;
}

Objection sides_hold_too_little(const Case& values) {
  if (values.system.sides.empty()) return std::nullopt;
  const bool random = values.start.arrangement == Arrangement::random;
  const double densest = in_dimension(random ? densest_random : densest_packing, values);
  const double fraction = filled_fraction(values);
  if (values.system.dimension == 1 && fraction == 1) {
    return "(the rods would fill the box; rods need room); use longer sides";
  }
  if (fraction <= (are_alike(values) ? densest : 1)) return std::nullopt;
  return fmt::format("({} spheres would fill {} of the box, at most {}{}); use longer sides",
                     values.system.spheres, told_apart(fraction, densest), densest,
                     random ? " for start.arrangement = \"random\"" : "");
}

/// Cells of a long box are as narrow as its narrowest side asks for.
Objection box_too_long_for_its_width(const Case& values) {
  if (values.system.sides.empty()) return std::nullopt;
  const double most =
      std::max(0x1p20, 8 * static_cast<double>(values.system.spheres));  // some hundred MiB
  const double width = cell_width_of(values);
  double cells = 1;
  for (const double side : values.system.sides) cells *= std::max(std::floor(side / width), 2.0);
  if (cells <= most) return std::nullopt;
  return fmt::format(
      "(cells that suit the shortest side would be {:.3g}, must be at most {:.3g}); make the sides "
      "less unequal",
      cells, most);
}

/// The lattice begins a quarter of its spacing away from the faces.
Objection lattice_touches_walls(const Case& values) {
  if (!is_lattice(values) || !values.walls.axis) return std::nullopt;
  const double spacing =
      box_sides(values).front() / static_cast<double>(cells_a_side(values.system.spheres));
  const double radius = values.system.sizes.largest / 2;
  if (spacing / 4 >= radius) return std::nullopt;
  return fmt::format(
      "(the first layer of fcc would be {} diameters from the wall, must be at "
      "least {}); use start.arrangement = \"random\" or a larger box",
      told_apart(spacing / 4, radius), radius);
}

}  // namespace

std::span<const Rule> box_rules() {
  static const std::vector<Rule> rules{
      {{"walls.axis", "system.dimension"}, walls_in_no_dimension},
      {{"start.arrangement", "system.dimension"}, lattice_in_other_dimension},
      {{"system.spheres", "start.arrangement"}, lattice_not_full},
      {{"system.spheres", "walls.axis"}, sphere_alone},
      {{"system.sides", "system.dimension"}, wrong_number_of_sides},
      {{"system.solids_volume_fraction", "system.dimension"}, denser_than_packed},
      {{"system.solids_volume_fraction", "system.dimension", "start.arrangement"},
       too_dense_for_random},
      {{"system.solids_volume_fraction", "system.dimension", "system.spheres", "system.sides",
        "system.aspect_ratio"},
       box_too_long},
      {{"system.aspect_ratio", "start.arrangement"}, lattice_is_stretched},
      {{"system.sides", "start.arrangement"}, lattice_in_a_cuboid},
      {{"system.spheres", "system.dimension", "system.solids_volume_fraction", "system.sides",
        "system.aspect_ratio", "start.arrangement", "walls.axis"},
       too_few_for_the_box},
      {{"system.sides", "system.dimension", "system.solids_volume_fraction", "walls.axis"},
       sides_too_short},
      {{"system.sides", "system.dimension", "system.spheres", "start.arrangement"},
       sides_hold_too_little},
      {{"system.sides", "system.dimension", "system.spheres", "system.solids_volume_fraction",
        "system.aspect_ratio", "walls.axis"},
       box_too_long_for_its_width},
      {{"walls.axis", "start.arrangement", "system.spheres", "system.sides", "system.dimension",
        "system.solids_volume_fraction", "system.aspect_ratio"},
       lattice_touches_walls}};
  return rules;
}

}  // namespace zenosphere::case_format
