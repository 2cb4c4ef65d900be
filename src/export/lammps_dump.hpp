#pragma once

#include "export/frame.hpp"
#include "storage/new_file.hpp"

namespace zenosphere {

/// Appends a frame of a LAMMPS text dump, which OVITO, VMD, MDAnalysis and ASE read.
///
/// The sheared cell is a triclinic box with |tilt| <= half a side, as LAMMPS demands, and positions
/// are the images in that box: x differs from that in the output file by a multiple of the side.
/// Columns: id (the number of the sphere plus 1: LAMMPS counts from 1), type 1, x y z, vx vy vz,
/// radius and, where known, c_collisions. The time step is the number of collisions; the format has
/// no place for the time that every reader knows. Source: https://docs.lammps.org/dump.html,
/// https://docs.lammps.org/Howto_triclinic.html
void append_lammps_dump(NewFile& file, const Frame& frame);

}  // namespace zenosphere
