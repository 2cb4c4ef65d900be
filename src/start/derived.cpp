#include "start/derived.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "case/case_box.hpp"
#include "case/case_cells.hpp"
#include "case/case_grains.hpp"
#include "model/restitution/laws.hpp"
#include "start/start_file.hpp"

namespace zenosphere {
namespace {

// docs/file-format.md: position and velocity, D float64 each; k, time, i, j, gap, speed, flags.
constexpr double bytes_per_component_and_snapshot = 2 * 8;
constexpr double bytes_per_logged_collision = 8 + 8 + 4 + 4 + 8 + 8 + 1;

/// Lines `label  value unit`, the values under one another.
class AlignedLines {
 public:
  void add(std::string_view label, double value, std::string_view unit = "") {
    add(label, fmt::format("{:.8g}", value), unit);
  }
  void add(std::string_view label, const std::string& value, std::string_view unit) {
    text_ += fmt::format("{:<30}{}{}{}\n", label, value, unit.empty() ? "" : " ", unit);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// `12.5`, or `25 x 12.5 x 12.5` where the sides differ.
template <int Dim>
std::string lengths(const Vec<Dim, double>& of) {
  std::string text = fmt::format("{:.8g}", of[0]);
  std::string all = text;
  for (int axis = 1; axis < Dim; ++axis) all += fmt::format(" x {:.8g}", of[axis]);
  for (int axis = 1; axis < Dim; ++axis) {
    if (of[axis] != of[0]) return all;
  }
  return text;
}

template <int Dim>
void add_box(const Case& values, const ShearBox<Dim, double>& box, AlignedLines& lines) {
  constexpr std::array units{"per diameter", "per diameter^2", "per diameter^3"};
  lines.add("box side", lengths(box.sides()), "diameters");
  lines.add("number density", static_cast<double>(values.system.spheres) / box.volume(),
            units[Dim - 1]);
  if (!values.system.sides.empty()) lines.add("solids volume fraction", filled_fraction(values));
  if constexpr (Dim > 1) lines.add("layers", box.cells()[1]);
  double cells = 1;
  for (const int count : box.cells()) cells *= count;
  lines.add("cells", cells);
  lines.add("cell width", lengths(box.cell_width()), "diameters");
}

/// Checks what the case gives, too.
void add_given_start(const Case& values, AlignedLines& lines) {
  double square = 0;
  for (const double component : given_start(values).velocities) square += component * component;
  if (!values.start.granular_temperature) {
    lines.add("kinetic energy at start", square / 2, "mass diameter^2/time^2");
  }
}

void add_start(const Case& values, double side, AlignedLines& lines) {
  const Arrangement arrangement = values.start.arrangement;
  if (arrangement == Arrangement::fcc) {
    const double constant = side / std::cbrt(static_cast<double>(values.system.spheres) / 4);
    lines.add("lattice constant", constant, "diameters");
    lines.add("gap of lattice neighbours", constant / std::numbers::sqrt2 - 1, "diameters");
  }
  const bool is_given = arrangement == Arrangement::given || arrangement == Arrangement::file;
  if (is_given) add_given_start(values, lines);
  if (const auto& temperature = values.start.granular_temperature) {
    lines.add("thermal speed at start", std::sqrt(*temperature), "diameters/time");
  }
}

void add_shear(const Case& values, double side, AlignedLines& lines) {
  const double rate = values.drive.shear_rate;
  if (values.drive.kind != DriveKind::shear || rate == 0) return;
  lines.add("time of one strain unit", 1 / rate, "time");
  lines.add("speed across the box", rate * side, "diameters/time");
  if (values.run.time) lines.add("strain at run.time", rate * *values.run.time);
  if (values.measure.after_time.is_found()) return;
  lines.add("strain at measure.after_time", rate * values.measure.after_time.time());
}

void add_kicks(const Case& values, AlignedLines& lines) {
  if (values.drive.kind != DriveKind::random || !values.run.time) return;
  lines.add("kicks until run.time", std::floor(*values.run.time / values.drive.kick_interval));
}

void add_plate(const Case& values, AlignedLines& lines) {
  const auto& walls = values.walls;
  if (!walls.motion) return;
  const Oscillation<double> plate(*walls.motion, walls.amplitude, 1 / walls.frequency);
  lines.add("peak acceleration of plate", plate.peak_acceleration(), "diameters/time^2");
  const auto& pull = values.gravity.acceleration;
  const double gravity = pull.empty() ? 0 : -pull[static_cast<std::size_t>(*walls.axis)];
  if (gravity > 0) lines.add("the same over gravity", plate.peak_acceleration() / gravity);
}

void add_contact(const Case& values, AlignedLines& lines) {
  const auto& collision = values.collision;
  const auto law = RestitutionLaws::chosen<double>(collision.restitution_law, collision);
  if (!law) return;
  const std::string whose = grains_of(values).are_alike() ? "" : "of two unit spheres";
  const auto add = [&]<class Restitution>(const Restitution& restitution) {
    if constexpr (std::is_same_v<Restitution, FixedLossRestitution<double>>) {
      lines.add("energy lost above the speed", restitution.threshold(),
                "diameters/time" + (whose.empty() ? "" : ", " + whose));
    }
    for (const double speed : Restitution::shown_speeds) {
      lines.add(fmt::format("restitution at the speed {:g}", speed), restitution(speed), whose);
    }
  };
  std::visit(add, *law);
}

/// `400 spheres of diameter 1.4, mass 2.744`
void add_species(const Case& values, AlignedLines& lines) {
  const std::vector<std::int64_t> counts = spheres_by_species(values);
  for (std::size_t kind = 0; kind < values.species.size(); ++kind) {
    const Species& species = values.species[kind];
    const double mass = species.mass.value_or(std::pow(species.diameter, values.system.dimension));
    lines.add(fmt::format("species {}", species.name),
              fmt::format("{} spheres, diameter {:.8g}, {}", counts[kind], species.diameter,
                          species.immobile ? "immobile" : fmt::format("mass {:.8g}", mass)),
              "");
  }
  const SizeSummary& sizes = values.system.sizes;
  if (sizes.smallest == sizes.largest) return;
  lines.add("smallest and largest diameter",
            fmt::format("{:.8g}, {:.8g}", sizes.smallest, sizes.largest), "");
}

void add_run(const Case& values, AlignedLines& lines) {
  if (!values.run.collisions) return;
  const auto collisions = static_cast<double>(*values.run.collisions);
  const auto spheres = static_cast<double>(values.system.spheres);
  lines.add("collisions per sphere", 2 * collisions / spheres, "at most");
}

/// What the criteria of collapse are asked to see: a warning where that is not the end of the
/// digits.
void add_collapse(const Case& values, AlignedLines& lines) {
  const double decades =
      values.collapse.gap_threshold.log10() - GapThreshold(values.collision.precision).log10();
  constexpr double most = 2;  // gaps are good to some ten times it in a box of twenty diameters
  if (decades > most) {
    lines.add(
        "gap threshold",
        fmt::format("{:.3g} times that of the precision (warning: spheres that are close count "
                    "as hits, and only the clock tells an arrest)",
                    std::pow(10.0, decades)),
        "");
  }
  const auto spheres = static_cast<double>(values.system.spheres);
  lines.add("window", 2 * static_cast<double>(values.collapse.window) / spheres,
            "collisions per sphere");
}

/// Most collisions that the log can hold, or infinity where only the time limits the run.
double most_logged(const Case& values) {
  if (values.output.collision_log == CollisionLog::none) return 0;
  double last = values.run.collisions ? static_cast<double>(*values.run.collisions) : HUGE_VAL;
  if (values.output.log_last) last = std::fmin(last, static_cast<double>(*values.output.log_last));
  return std::fmax(0, last - static_cast<double>(values.output.log_first) + 1);
}

void add_output(const Case& values, AlignedLines& lines) {
  constexpr double mebibyte = 1024 * 1024;
  const auto spheres = static_cast<double>(values.system.spheres);
  const double components = spheres * values.system.dimension;
  lines.add("one snapshot", components * bytes_per_component_and_snapshot / mebibyte, "MiB");
  if (values.run.time && values.output.snapshot_interval) {
    const double intervals = *values.run.time / *values.output.snapshot_interval;
    const bool is_even = values.output.snapshot_spacing == SnapshotSpacing::linear;
    const double between =
        std::floor(is_even ? intervals : std::fmax(0, 1 + 10 * std::log10(intervals)));
    lines.add("snapshots", 2 + between, "at most");
  }
  const double logged = most_logged(values);
  if (std::isfinite(logged)) {
    lines.add("collision log", logged * bytes_per_logged_collision / mebibyte, "MiB at most");
  }
}

template <int Dim>
std::string text_in(const Case& values) {
  const auto box = box_of<Dim, double>(values);
  AlignedLines lines;
  add_box(values, box, lines);
  add_species(values, lines);
  add_start(values, box.sides()[0], lines);
  if constexpr (Dim > 1) add_shear(values, box.sides()[1], lines);
  add_kicks(values, lines);
  add_plate(values, lines);
  add_contact(values, lines);
  add_collapse(values, lines);
  add_run(values, lines);
  add_output(values, lines);
  return lines.text();
}

}  // namespace

std::string derived_text(const Case& values) {
  if (values.system.dimension == 1) return text_in<1>(values);
  if (values.system.dimension == 2) return text_in<2>(values);
  return text_in<3>(values);
}

}  // namespace zenosphere
