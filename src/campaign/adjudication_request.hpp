#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "model/precision.hpp"

namespace zenosphere {

/// How the hits of each run are adjudicated: the table [adjudicate] of a sweep file.
struct AdjudicationRequest {
  std::optional<std::int64_t> groups{};      ///< of hits of a run, the first ones; none: all
  double seconds = 120;                      ///< for each run, as the command has it
  std::optional<Precision> up_to{};          ///< the highest; none: as the command has it
  std::optional<std::int64_t> collisions{};  ///< of each trial, after the run's hit
  std::string place{};                       ///< of `up_to` in the sweep file, for messages
};

}  // namespace zenosphere
