#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "export/formats.hpp"
#include "export/sphere_lines.hpp"

namespace zenosphere {
namespace {

/// The box: its bounds are those of the leaning cell, which are wider along x.
std::string header(const Frame& frame) {
  const Cell& cell = frame.cell;
  const auto flags = [&](std::size_t axis) { return cell.periodic[axis] ? "pp" : "ff"; };
  return fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS xy xz yz {} {} {}\n"
      "{} {} {}\n{} {} 0\n{} {} 0\nITEM: ATOMS id type x y z vx vy vz radius{}{}{}{}\n",
      frame.snapshot.step, frame.spheres(), flags(0), flags(1), flags(2),
      cell.origin[0] + std::min(0.0, cell.tilt), cell.upper(0) + std::max(0.0, cell.tilt),
      cell.tilt, cell.origin[1], cell.upper(1), cell.origin[2], cell.upper(2),
      frame.are_alike() ? "" : " mass", frame.has_images() ? " ix iy iz" : "",
      frame.has_spins() ? " omegax omegay omegaz" : "",
      frame.collisions.empty() ? "" : " c_collisions");
}

/// Appends a frame of a LAMMPS text dump, which OVITO, VMD, MDAnalysis and ASE read.
///
/// The sheared cell is a triclinic box with |tilt| <= half a side, as LAMMPS demands, and positions
/// are the images in that box: x differs from that in the output file by a multiple of the side.
/// Columns: id (the number of the sphere plus 1: LAMMPS counts from 1), type 1, x y z, vx vy vz,
/// radius and, where known, c_collisions. The time step is the number of collisions; the format has
/// no place for the time that every reader knows. Source: https://docs.lammps.org/dump.html,
/// https://docs.lammps.org/Howto_triclinic.html
void append_lammps_dump(NewFile& file, const Frame& frame) {
  file.write(header(frame));
  write_sphere_lines(file, frame, [&](fmt::appender line, std::int64_t i) {
    const auto [x, y, z] = frame.position(i);
    const auto [vx, vy, vz] = frame.velocity(i);
    const double leaning_x = frame.cell.leaning_x(x, y);
    line = fmt::format_to(line, FMT_COMPILE("{} {} {} {} {} {} {} {} {}"), i + 1, frame.kind(i) + 1,
                          leaning_x, y, z, vx, vy, vz, frame.radius(i));
    if (!frame.are_alike()) line = fmt::format_to(line, FMT_COMPILE(" {}"), frame.mass(i));
    if (frame.has_images()) {
      const auto [ix, iy, iz] = frame.image(i);
      const double moved = std::round((x - leaning_x) / frame.cell.sides[0]);
      line = fmt::format_to(line, FMT_COMPILE(" {} {} {}"), ix + static_cast<std::int64_t>(moved),
                            iy, iz);
    }
    if (!frame.has_spins()) return;
    const auto [wx, wy, wz] = frame.spin(i);
    fmt::format_to(line, FMT_COMPILE(" {} {} {}"), wx, wy, wz);
  });
}

}  // namespace

ExportFormat lammps_dump() {
  return {"lammps", "OVITO, VMD, MDAnalysis, ASE", Exports::frames, true, append_lammps_dump};
}

}  // namespace zenosphere
