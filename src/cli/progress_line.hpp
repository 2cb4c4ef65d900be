#pragma once

#include <string>

#include "run/run.hpp"

namespace zenosphere {

/// One line that tells how far a run is: collisions, time, speed, hits and the time that remains.
std::string progress_line(const Progress& progress);

}  // namespace zenosphere
