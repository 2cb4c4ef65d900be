#pragma once

#include <string>

#include "run/run.hpp"

namespace zenosphere {

/// A time that remains, as in `3:20` or `2 h 05 min`.
std::string duration_text(double seconds);

/// One line that tells how far a run is: collisions, time, speed, hits and the time that remains.
std::string progress_line(const Progress& progress);

}  // namespace zenosphere
