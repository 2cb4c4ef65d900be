#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "case/case.hpp"
#include "result/adjudication.hpp"

namespace zenosphere {

/// How much an adjudication may cost.
struct AdjudicationLimits {
  std::optional<Precision> highest{};        ///< none: digits100, and more while digits run out
  std::optional<std::int64_t> collisions{};  ///< of each trial, after the run's hit
  std::optional<std::int64_t> groups{};      ///< of hits that are followed, the first ones
  double seconds = 120;
  bool tries_other_rules = true;  ///< on the first group, in the run's own precision
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(const std::string&)> on_trial{};  ///< called before each, with what it is
  std::function<void()> on_look{};  ///< called some times a second; may set the interrupt
};

/// Physics or rounding? Finds the separation hits of a run, and follows each group of them, from a
/// state before it, in every precision from the run's own upwards, until the digits are spent, the
/// spheres have flown apart, or a limit is reached. What approached is judged in the highest
/// precision.
///
/// The run is done again from its start. A group is followed from a collision a sphere (at least a
/// hundred collisions) before its first hit: close enough for all precisions to meet the same
/// spheres before chaos parts them. That state is promoted: its numbers are the same in more
/// digits.
///
/// A run without a separation hit within the limits of its case has no approaches: that is an
/// answer, too.
Adjudication adjudicate(const Case& values, const AdjudicationLimits& limits);

}  // namespace zenosphere
