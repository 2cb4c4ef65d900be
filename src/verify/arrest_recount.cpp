#include "verify/arrest_recount.hpp"

#include <fmt/format.h>

#include <limits>

namespace zenosphere::verify {

namespace {

/// The criterion of a file; the first version did not ask how often each pair had met.
ArrestCriterion<1, double> criterion(const Case& values, double threshold,
                                     std::int64_t criteria_version) {
  const auto repetitions = ArrestCriterion<1, double>::enough_repetitions;
  return {threshold, values.collapse.window, 1.0, criteria_version < 2 ? 0 : repetitions};
}

/// The threshold of a recount that takes no gap for a hit which may have been none: below the range
/// of double the log does not tell how small a gap was.
double strict_threshold(const GapThreshold& threshold) {
  return threshold.fits_double() ? threshold.nearest_double() : 0.0;
}

}  // namespace

ArrestRecount::ArrestRecount(const Case& values, std::int64_t criteria_version)
    : strict_(criterion(values, strict_threshold(values.collapse.gap_threshold), criteria_version)),
      lenient_(
          criterion(values, values.collapse.gap_threshold.nearest_double(), criteria_version)) {}

void ArrestRecount::observe(const CollisionRow& row, double gap_before) {
  Collision<1, double> collision;
  collision.number = row.k;
  collision.i = row.i;
  collision.j = row.j;
  collision.gap_before = gap_before;
  collision.time.remainder = row.time;
  lenient_.observe(collision);
  moves_ += (row.flags & collision_flag::clock_stood) == 0;
  collision.time = {static_cast<double>(moves_), 0.0};
  strict_.observe(collision);
}

void ArrestRecount::compare(const Summary& summary, Findings& findings) const {
  constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
  const auto& told = summary.arrest;
  const std::int64_t earliest = lenient_.collision().value_or(never);
  const std::int64_t latest = strict_.collision().value_or(never);
  const std::int64_t met = told.collision.value_or(never);
  if (told.met != told.collision.has_value() || met < earliest || met > latest) {
    const auto text = [](std::int64_t k) { return k == never ? "never" : fmt::format("{}", k); };
    findings.add(fmt::format(
        "summary: arrest.met = {}, arrest.collision = {} (the log has it met between {} and {})",
        told.met, text(met), text(earliest), text(latest)));
    return;
  }
  const auto& certain = earliest == met ? lenient_ : strict_;
  if (certain.collision() != told.collision) return;  // between the two: its pairs are not known
  Pairs pairs;
  for (const auto& [i, j] : certain.pairs()) pairs.emplace_back(i, j);
  if (pairs != told.pairs) {
    findings.add(fmt::format("summary: arrest.pairs has {} pairs (the log has {}, or others)",
                             told.pairs.size(), pairs.size()));
  }
}

}  // namespace zenosphere::verify
