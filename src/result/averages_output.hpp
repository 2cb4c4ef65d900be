#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "flow/averages.hpp"
#include "text/json.hpp"

namespace zenosphere {

/// The object `averages` of a summary: its keys with null where nothing was averaged.
Json json_of(const std::optional<Averages>& averages, int dimension);

/// The averages for people, each with its error; or, where that is not known, with as many digits
/// as so many collisions support.
std::string text_of(const Averages& averages, std::int64_t collisions, int dimension);

}  // namespace zenosphere
