#include "io/case_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "engine/start.hpp"
#include "io/case_table.hpp"

namespace zenosphere::case_format {
namespace {

using Objection = std::optional<std::string>;

/// Densest random arrangement [volume fraction]: above 0.494 hard spheres begin to freeze, so that
/// mixing no longer forgets the order (Hoover & Ree, J. Chem. Phys. 49 (1968) 3609).
constexpr double densest_random = 0.5;

/// Two cells must fit a side, each a little wider than a sphere: as ShearBox has it.
constexpr double smallest_cell_width = 1 + 1e-9;

std::int64_t fcc_places(std::int64_t cells_a_side) {
  return 4 * cells_a_side * cells_a_side * cells_a_side;
}

/// A fraction of 0 means that it is not known.
bool box_is_wide_enough(std::int64_t spheres, const Case& values) {
  const double fraction = values.system.solids_volume_fraction;
  return fraction == 0 || box_side<3>(spheres, fraction) > 2 * smallest_cell_width;
}

/// Smallest number of spheres >= `from` that the arrangement can place in a box wide enough.
std::int64_t fewest_spheres(std::int64_t from, const Case& values) {
  const bool lattice = values.start.arrangement == Arrangement::fcc;
  std::int64_t steps = 0;
  const auto spheres = [&] { return lattice ? fcc_places(steps) : steps; };
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

bool fills_lattice(std::int64_t spheres) {
  std::int64_t cells = 1;
  while (fcc_places(cells) < spheres) ++cells;
  return fcc_places(cells) == spheres;
}

/// May be asked before the density is known: it is 0 then, and every box wide enough.
Objection lattice_not_full(const Case& values) {
  const bool lattice = values.start.arrangement == Arrangement::fcc;
  if (!lattice || fills_lattice(values.system.spheres)) return std::nullopt;
  return "(fcc fills 4 n^3 places)" + nearest_full_lattices(values);
}

Objection box_too_narrow(const Case& values) {
  if (box_is_wide_enough(values.system.spheres, values)) return std::nullopt;
  const double side = box_side<3>(values.system.spheres, values.system.solids_volume_fraction);
  return fmt::format("(the box side would be {:.6g} diameters, must be above 2); use at least {}",
                     side, fewest_spheres(2, values));
}

Objection too_dense_for_random(const Case& values) {
  const bool random = values.start.arrangement == Arrangement::random;
  if (!random || values.system.solids_volume_fraction <= densest_random) return std::nullopt;
  return fmt::format("(must be in (0, {}] for start.arrangement = \"random\")", densest_random);
}

Objection nothing_moves(const Case& values) {
  const bool sheared = values.drive.kind == DriveKind::shear && values.drive.shear_rate > 0;
  if (values.start.granular_temperature > 0 || sheared) return std::nullopt;
  return "(nothing would ever move); use a value above 0, or shear";
}

Objection log_ends_before_it_begins(const Case& values) {
  const auto& output = values.output;
  if (!output.log_last || *output.log_last >= output.log_first) return std::nullopt;
  return fmt::format("(must be >= output.log_first = {})", output.log_first);
}

constexpr std::array<std::string_view, 2> lattice_keys{"system.spheres", "start.arrangement"};
constexpr std::array<std::string_view, 3> box_keys{
    "system.spheres", "system.solids_volume_fraction", "start.arrangement"};
constexpr std::array<std::string_view, 2> density_keys{"system.solids_volume_fraction",
                                                       "start.arrangement"};
constexpr std::array<std::string_view, 3> motion_keys{"start.granular_temperature", "drive.kind",
                                                      "drive.shear_rate"};
constexpr std::array<std::string_view, 2> log_keys{"output.log_last", "output.log_first"};
constexpr std::array all_rules{Rule{lattice_keys, lattice_not_full}, Rule{box_keys, box_too_narrow},
                               Rule{density_keys, too_dense_for_random},
                               Rule{motion_keys, nothing_moves},
                               Rule{log_keys, log_ends_before_it_begins}};

}  // namespace

std::span<const Rule> rules() { return all_rules; }

}  // namespace zenosphere::case_format
