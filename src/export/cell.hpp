#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "storage/records.hpp"

namespace zenosphere {

/// The cell of a snapshot in three dimensions, as viewers know it: its vectors are
/// (sides[0], 0, 0), (tilt, sides[1], 0) and (0, 0, sides[2]).
///
/// An axis that the run does not have is one diameter thick, from -1/2 to 1/2 with the spheres at
/// 0, and not periodic, so that no sphere meets an image of itself there.
struct Cell {
  std::array<double, 3> origin{};  ///< the lowest corner, diameters
  std::array<double, 3> sides{};   ///< diameters
  double tilt = 0;                 ///< the Lees-Edwards offset, in [-sides[0]/2, sides[0]/2)
  std::array<bool, 3> periodic{};  ///< false along the axis of walls, too

  double upper(std::size_t axis) const { return origin[axis] + sides[axis]; }

  /// The x of the image, along x, that lies between the leaning sides of the cell. Positions in the
  /// output file lie in the upright box instead.
  ///
  /// \param x, y  position with 0 <= x < sides[0], diameters; with tilt = 0 the same x is returned
  double leaning_x(double x, double y) const;
};

/// The cell of a snapshot; an offset of more than half a side is reduced to the same lattice.
///
/// \param dimension  D of the run, 1 to 3
/// \param closed     axis of the walls, from 0, if there are any
/// \param path       of the output file, for the message
/// Throws InputError where the edges are not those of a box of this program.
Cell cell_of(const Snapshot& snapshot, int dimension, std::optional<int> closed,
             const std::filesystem::path& path);

}  // namespace zenosphere
