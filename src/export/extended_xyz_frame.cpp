#include <fmt/format.h>

#include <string>

#include "export/formats.hpp"
#include "export/sphere_lines.hpp"

namespace zenosphere {
namespace {

/// Columns and keys of what unit spheres of one kind that do not turn lack.
std::string more_columns(const Frame& frame) {
  return fmt::format("{}{}{}", frame.are_alike() ? "" : ":masses:R:1:kind:I:1",
                     frame.has_spins() ? ":angular_velocity:R:3" : "",
                     frame.collisions.empty() ? "" : ":collisions:I:1");
}

std::string kinds(const Frame& frame) {
  if (frame.are_alike() || frame.species.empty()) return "";
  std::string names;
  for (const std::string& name : frame.species) names += (names.empty() ? "" : " ") + name;
  return fmt::format(" Kinds=\"{}\"", names);
}

std::string comment(const Frame& frame) {
  const Cell& cell = frame.cell;
  const auto letter = [&](std::size_t axis) { return cell.periodic[axis] ? 'T' : 'F'; };
  return fmt::format(
      "Lattice=\"{} 0 0 {} {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\" "
      "Properties=species:S:1:id:I:1:pos:R:3:velo:R:3:momenta:R:3:radius:R:1{} "
      "Time={} Step={} Snapshot={}{} Units=\"diameter and mass of a sphere, time of the case\"\n",
      cell.sides[0], cell.tilt, cell.sides[1], cell.sides[2], cell.origin[0], cell.origin[1],
      cell.origin[2], letter(0), letter(1), letter(2), more_columns(frame), frame.snapshot.time,
      frame.snapshot.step, frame.number, kinds(frame));
}

/// Appends a frame of extended XYZ, which OVITO and ASE read and a case can start from.
///
/// Columns: species X, id (the sphere, from 0), pos (in the upright box), velo, momenta, radius
/// and, where known, collisions. OVITO takes the velocities from velo, ASE's get_velocities() from
/// momenta, which are the same numbers since the mass is 1. Lattice holds the rows of the cell and
/// Origin, which only OVITO reads, its corner. Numbers have the digits that give the same bits when
/// they are read. Source: https://github.com/libAtoms/extxyz
void append_extended_xyz(NewFile& file, const Frame& frame) {
  file.write(fmt::format("{}\n", frame.spheres()));
  file.write(comment(frame));
  write_sphere_lines(file, frame, [&](fmt::appender line, std::int64_t i) {
    const auto [x, y, z] = frame.position(i);
    const auto [vx, vy, vz] = frame.velocity(i);
    const double mass = frame.mass(i);
    line = fmt::format_to(line, FMT_COMPILE("X {} {} {} {} {} {} {} {} {} {} {}"), i, x, y, z, vx,
                          vy, vz, mass * vx, mass * vy, mass * vz, frame.radius(i));
    if (!frame.are_alike()) {
      line = fmt::format_to(line, FMT_COMPILE(" {} {}"), mass, frame.kind(i));
    }
    if (!frame.has_spins()) return;
    const auto [wx, wy, wz] = frame.spin(i);
    fmt::format_to(line, FMT_COMPILE(" {} {} {}"), wx, wy, wz);
  });
}

}  // namespace

ExportFormat extended_xyz() {
  return {"extxyz", "OVITO, ASE", Exports::frames, true, append_extended_xyz};
}

}  // namespace zenosphere
