#pragma once

#include <string>

#include "campaign/search.hpp"

namespace zenosphere {

/// What a search has found, a line for each point; empty for a grid and for an interrupted search.
std::string found_text(const Sweep& sweep, const SearchResult& result);

}  // namespace zenosphere
