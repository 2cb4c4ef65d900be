#pragma once

#include <string>

#include "result/summary.hpp"

namespace zenosphere {

/// The line or two of each species for people; nothing where there are none.
std::string species_lines(const Summary& summary);

}  // namespace zenosphere
