#pragma once

#include <string>
#include <vector>

#include "run/run.hpp"

namespace zenosphere {

/// A time that remains, as in `3:20` or `2 h 05 min`.
std::string duration_text(double seconds);

/// A part of a progress line; where not all of them fit, those of the highest rank are left out.
struct LinePart {
  std::string text;
  int rank;
};

/// The parts side by side, at most so many columns wide where the part of the lowest rank is.
std::string fitted_line(std::vector<LinePart> parts, std::size_t columns);

/// One line that tells how far a run is: collisions, time, speed, hits and the time that remains;
/// on a narrow terminal not all of that.
std::string progress_line(const Progress& progress, std::size_t columns);

}  // namespace zenosphere
