#pragma once

#include <string>

#include "result/summary.hpp"
#include "text/json.hpp"

namespace zenosphere {

/// Adds `species` to the JSON of a summary, where it has them.
void add_species(const Summary& summary, Json& json);

/// The line or two of each species for people; nothing where there are none.
std::string species_lines(const Summary& summary);

}  // namespace zenosphere
