#pragma once

#include <cstdint>
#include <optional>

#include "model/case_key.hpp"

namespace zenosphere::case_format {

// Thirty years at a million collisions a second, and every count up to it is exact in a double.
inline constexpr double most_collisions = 1e15;

/// The table [run]: where it ends.
struct Run {
  std::optional<std::int64_t> collisions;
  std::optional<double> time;

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(
        CaseKey{"collisions", optional, from_to(0, most_collisions), "the run ends after so many"},
        collisions);
    visit(CaseKey{"time", optional, at_least(0), "the run ends then [time]"}, time);
  }
};

}  // namespace zenosphere::case_format
