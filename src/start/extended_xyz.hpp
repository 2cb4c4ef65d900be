#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace zenosphere {

/// One frame of an extended XYZ file, row-major.
struct XyzFrame {
  std::vector<double> positions;   ///< N x D from the lowest corner of the box, diameters
  std::vector<double> velocities;  ///< N x D, diameters/time; empty if the file has none
  std::vector<double> sides;       ///< D, diameters
  double offset = 0;               ///< of the second box vector along x, diameters
  std::optional<std::array<bool, 3>> is_periodic;  ///< along x, y, z; none: not told
  std::vector<double> diameters{};                 ///< N; empty if the file does not tell them
  std::vector<double> masses{};                    ///< N; likewise
  std::vector<std::string> kinds{};                ///< N words for what the spheres are; likewise
  std::vector<double> spins{};  ///< angular velocities, N x 3, in two dimensions N; likewise
  bool needs_masses = false;    ///< the velocities are momenta of spheres of unknown mass
};

/// Reads a frame of an extended XYZ file.
///
/// A frame is a line with the number of spheres, a line with Lattice="..." and Properties=..., and
/// one line a sphere. Of the columns that Properties names, `pos` and `velo` (also `vel`,
/// `velocity`, `velocities`, `momenta`) are read; `radius`, `diameter` and `mass` say what the
/// spheres are; `kind` (else `type`, else `species`) of which kind, a number in `kind` by the names
/// in the key `Kinds`; `angular_velocity` how they turn; the others are skipped. Momenta are
/// divided by the masses. Without Properties, the columns are a word and three coordinates. In
/// fewer than three dimensions the coordinates beyond must be 0. `Origin` is the lowest corner of
/// the box. Of the numbers of Lattice that are beside its diagonal only the offset of the second
/// vector along the first may not be 0.
///
/// \param dimension  D
/// \param spheres    N, which the frame must have
/// \param number     of the frame, from 0; none: the last one
/// Throws InputError, with file:line, where the file cannot be read, is not of this format, ends
/// within a frame, tells one thing twice, or has lines of more than 1 MiB.
/// Source: https://github.com/libAtoms/extxyz
XyzFrame read_frame(const std::filesystem::path& path, int dimension, std::int64_t spheres,
                    std::optional<std::int64_t> number);

}  // namespace zenosphere
