#pragma once

namespace zenosphere {

/// How the spheres are placed before the run.
enum class Arrangement {
  fcc,     ///< face-centred cubic lattice that fills the box
  random,  ///< random places, overlaps pushed apart, mixed by an elastic run
  given,   ///< positions and velocities written in the case file
  file,    ///< positions and velocities read from a file
};

}  // namespace zenosphere
