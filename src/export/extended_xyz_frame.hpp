#pragma once

#include "export/frame.hpp"
#include "storage/new_file.hpp"

namespace zenosphere {

/// Appends a frame of extended XYZ, which OVITO and ASE read and a case can start from.
///
/// Columns: species X, id (the sphere, from 0), pos (in the upright box), velo, momenta, radius
/// and, where known, collisions. OVITO takes the velocities from velo, ASE's get_velocities() from
/// momenta, which are the same numbers since the mass is 1. Lattice holds the rows of the cell and
/// Origin, which only OVITO reads, its corner. Numbers have the digits that give the same bits when
/// they are read. Source: https://github.com/libAtoms/extxyz
void append_extended_xyz(NewFile& file, const Frame& frame);

}  // namespace zenosphere
