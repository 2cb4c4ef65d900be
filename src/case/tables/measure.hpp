#pragma once

#include <optional>

#include "model/average_start.hpp"
#include "model/case_key.hpp"

namespace zenosphere::case_format {

/// The table [measure]: what is averaged, and how often.
struct Measure {
  AverageStart after_time = 0.0;
  std::optional<double> interval;           ///< of the time series; none: from the collision rate
  std::optional<double> sampling_interval;  ///< of what is accumulated; none: nothing is

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"after_time", optional, at_least(0),
                  "averages start then [time], or where the steady state is found to begin: "
                  "\"auto\""},
          after_time);
    visit(CaseKey{"interval", optional, above(0), "between the values of the time series [time]"},
          interval);
    visit(CaseKey{"sampling_interval", optional, above(0),
                  "between samples of structure and velocities, accumulated in the run [time]"},
          sampling_interval);
  }
};

}  // namespace zenosphere::case_format
