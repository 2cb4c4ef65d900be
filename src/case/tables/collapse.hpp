#pragma once

#include <cstdint>

#include "model/case_key.hpp"
#include "model/gap_threshold.hpp"

namespace zenosphere::case_format {

// Arrests were met within 2e6 collisions; a longer window than this only delays the verdict.
inline constexpr double longest_window = 1e8;

/// The table [collapse]: what the criteria of a collapse ask for.
struct Collapse {
  GapThreshold gap_threshold = 1e-16;  ///< diameters
  std::int64_t window = 10000;         ///< collisions
  bool stop_when_collapsed = true;

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"gap_threshold", optional, above(0),
                  "a gap up to this meets the separation criterion [diameters]"},
          gap_threshold);
    visit(CaseKey{"window", optional, from_to(2, longest_window),
                  "length of the arrest criterion [collisions]"},
          window);
    visit(CaseKey{"stop_when_collapsed", optional, any, "the arrest criterion ends the run"},
          stop_when_collapsed);
  }
};

}  // namespace zenosphere::case_format
