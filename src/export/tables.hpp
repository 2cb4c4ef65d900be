#pragma once

#include <cstddef>
#include <string>

#include "export/frame.hpp"
#include "storage/new_file.hpp"
#include "storage/records.hpp"

namespace zenosphere {

/// The first line of the table of observables: names of its columns, whose units docs/export.md
/// has.
///
/// \param dimension  D: there are D temperatures and, from two dimensions on, the offset and a
///                   shear component
/// \param turns      whether spheres have angular velocities
std::string observables_header(int dimension, bool turns);

/// Appends a line of it: what follows from the positions and velocities of a snapshot, these
/// relative to the imposed profile.
void append_observables(NewFile& file, const Frame& frame);

/// The first line of the table of a series: `pressure_tensor_xy` is a component along axes,
/// `wall_pressure_0` one of another kind.
std::string series_header(const RecordedSeries& series);

/// One line of it: the averages over an interval, which ends at `step` and `time`.
std::string series_row(const RecordedSeries& series, std::size_t row);

/// The first line of the table of collisions: the columns of the log.
std::string collisions_header();

/// One line of it. A gap that is not known is `nan`.
std::string collisions_row(const CollisionRow& row);

}  // namespace zenosphere
