#include "io/derived.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "engine/start.hpp"

namespace zenosphere {
namespace {

// docs/file-format.md: position and velocity, 3 float64 each; k, time, i, j, gap, speed, flags.
constexpr double bytes_per_sphere_and_snapshot = 2 * 3 * 8;
constexpr double bytes_per_logged_collision = 8 + 8 + 4 + 4 + 8 + 8 + 1;

/// Lines `label  value unit`, the values under one another.
class Lines {
 public:
  void add(std::string_view label, double value, std::string_view unit = "") {
    const std::string number = fmt::format("{:.8g}", value);
    text_ += fmt::format("{:<30}{}{}{}\n", label, number, unit.empty() ? "" : " ", unit);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add_box(const Case& values, const ShearBox<3, double>& box, Lines& lines) {
  lines.add("box side", box.sides()[0], "diameters");
  lines.add("number density", static_cast<double>(values.system.spheres) / box.volume(),
            "per diameter^3");
  lines.add("layers", box.cells()[1]);
  lines.add("cells", std::pow(box.cells()[1], 3));
  lines.add("cell width", box.cell_width()[1], "diameters");
}

void add_start(const Case& values, double side, Lines& lines) {
  if (values.start.arrangement == Arrangement::fcc) {
    const double constant = side / std::cbrt(static_cast<double>(values.system.spheres) / 4);
    lines.add("lattice constant", constant, "diameters");
    lines.add("gap of lattice neighbours", constant / std::numbers::sqrt2 - 1, "diameters");
  }
  lines.add("thermal speed at start", std::sqrt(values.start.granular_temperature),
            "diameters/time");
}

void add_shear(const Case& values, double side, Lines& lines) {
  const double rate = values.drive.shear_rate;
  if (values.drive.kind != DriveKind::shear || rate == 0) return;
  lines.add("time of one strain unit", 1 / rate, "time");
  lines.add("speed across the box", rate * side, "diameters/time");
  if (values.run.time) lines.add("strain at run.time", rate * *values.run.time);
  lines.add("strain at measure.after_time", rate * values.measure.after_time);
}

void add_run(const Case& values, Lines& lines) {
  if (!values.run.collisions) return;
  const auto collisions = static_cast<double>(*values.run.collisions);
  const auto spheres = static_cast<double>(values.system.spheres);
  lines.add("collisions per sphere", 2 * collisions / spheres, "at most");
}

/// Most collisions that the log can hold, or infinity where only the time limits the run.
double most_logged(const Case& values) {
  if (values.output.collision_log == CollisionLog::none) return 0;
  double last = values.run.collisions ? static_cast<double>(*values.run.collisions) : HUGE_VAL;
  if (values.output.log_last) last = std::fmin(last, static_cast<double>(*values.output.log_last));
  return std::fmax(0, last - static_cast<double>(values.output.log_first) + 1);
}

void add_output(const Case& values, Lines& lines) {
  constexpr double mebibyte = 1024 * 1024;
  const auto spheres = static_cast<double>(values.system.spheres);
  lines.add("one snapshot", spheres * bytes_per_sphere_and_snapshot / mebibyte, "MiB");
  if (values.run.time && values.output.snapshot_interval) {
    const double between = std::floor(*values.run.time / *values.output.snapshot_interval);
    lines.add("snapshots", 2 + between, "at most");
  }
  const double logged = most_logged(values);
  if (std::isfinite(logged)) {
    lines.add("collision log", logged * bytes_per_logged_collision / mebibyte, "MiB at most");
  }
}

}  // namespace

template <int Dim>
ShearBox<Dim, double> box_of(const Case& values) {
  const double side = box_side<Dim>(values.system.spheres, values.system.solids_volume_fraction);
  Vec<Dim, double> sides;
  for (int axis = 0; axis < Dim; ++axis) sides[axis] = side;
  const double roomy = side / std::pow(2.0 * static_cast<double>(values.system.spheres), 1.0 / Dim);
  const double shear_rate = values.drive.kind == DriveKind::shear ? values.drive.shear_rate : 0;
  return {sides, shear_rate, std::max(1.0, roomy)};
}

template ShearBox<3, double> box_of<3>(const Case&);

std::string derived_text(const Case& values) {
  const ShearBox<3, double> box = box_of<3>(values);
  Lines lines;
  add_box(values, box, lines);
  add_start(values, box.sides()[0], lines);
  add_shear(values, box.sides()[0], lines);
  add_run(values, lines);
  add_output(values, lines);
  return lines.text();
}

}  // namespace zenosphere
