#pragma once

#include "result/summary.hpp"

namespace zenosphere::test {

/// A run of four spheres that collapsed.
inline Summary collapsed_summary() {
  Summary summary;
  summary.collisions = 90;
  summary.collisions_per_sphere = 45;
  summary.outcome = Outcome::collapsed;
  summary.ended_by = EndedBy::arrest;
  summary.verdict = Verdict::arrested;
  summary.separation = {12, 70, 0.25, 90, 0.5, 0.125};
  summary.arrest = {true, 88, 0.5, 10, {{0, 3}, {1, 3}}, {}, {}, 1};
  return summary;
}

/// Averages of two dimensions, without errors.
inline Averages planar_averages() {
  Averages averages;
  averages.granular_temperature = 0.1;
  averages.temperature_diagonal = {0.125, 0.075};
  averages.pressure_tensor = {1, 2, 3, 4};
  averages.to_time = 0.5;
  return averages;
}

}  // namespace zenosphere::test
