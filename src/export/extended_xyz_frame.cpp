#include "export/extended_xyz_frame.hpp"

#include <fmt/format.h>

#include <string>

#include "export/sphere_lines.hpp"

namespace zenosphere {
namespace {

std::string comment(const Frame& frame) {
  const Cell& cell = frame.cell;
  const auto letter = [&](std::size_t axis) { return cell.periodic[axis] ? 'T' : 'F'; };
  return fmt::format(
      "Lattice=\"{} 0 0 {} {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\" "
      "Properties=species:S:1:id:I:1:pos:R:3:velo:R:3:momenta:R:3:radius:R:1{} "
      "Time={} Step={} Snapshot={} Units=\"diameter and mass of a sphere, time of the case\"\n",
      cell.sides[0], cell.tilt, cell.sides[1], cell.sides[2], cell.origin[0], cell.origin[1],
      cell.origin[2], letter(0), letter(1), letter(2),
      frame.collisions.empty() ? "" : ":collisions:I:1", frame.snapshot.time, frame.snapshot.step,
      frame.number);
}

}  // namespace

void append_extended_xyz(NewFile& file, const Frame& frame) {
  file.write(fmt::format("{}\n", frame.spheres()));
  file.write(comment(frame));
  write_sphere_lines(file, frame, [&](fmt::appender line, std::int64_t i) {
    const auto [x, y, z] = frame.position(i);
    const auto [vx, vy, vz] = frame.velocity(i);
    fmt::format_to(line, FMT_COMPILE("X {} {} {} {} {} {} {} {} {} {} {}"), i, x, y, z, vx, vy, vz,
                   vx, vy, vz, sphere_radius);
  });
}

}  // namespace zenosphere
