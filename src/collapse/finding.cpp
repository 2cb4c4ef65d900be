#include "collapse/finding.hpp"

#include <algorithm>
#include <cmath>

namespace zenosphere {
namespace {

constexpr double least_singular_decades = 20;
constexpr double least_visited = 0.25;  // of the decades between: fewer is a jump, not a fall

}  // namespace

const char* word(Finding finding) {
  switch (finding) {
    case Finding::chance_close_pair:
      return "chance close pair";
    case Finding::exact_contact:
      return "exact contact";
    case Finding::near_collapse:
      return "near-collapse";
    case Finding::arithmetic_arrest:
      return "arithmetic arrest";
    case Finding::singular:
      return "singular";
    case Finding::proven:
      return "proven";
    case Finding::undecided:
      break;
  }
  return "undecided";
}

bool converges(const RoundRatio& ratio) {
  constexpr double rounding = 1e-12;  // durations are told in `double`
  return ratio.ratio < 1 && (ratio.change <= rounding || ratio.change <= ratio.change_before / 10);
}

std::optional<RoundRatio> round_ratio(const std::vector<double>& durations) {
  constexpr std::size_t least_rounds = 8;
  if (durations.size() < least_rounds) return std::nullopt;
  const auto ratio = [&](std::size_t k) { return durations[k] / durations[k - 1]; };
  const std::size_t last = durations.size() - 1;
  return RoundRatio{ratio(last), std::abs(ratio(last / 2) - ratio(last / 4 + 1)),
                    std::abs(ratio(last) - ratio(last / 2))};
}

bool runs_out_of_time(const ApproachEvidence& evidence) {
  constexpr double most_of_quarter_before = 0.1;  // a collapse leaves a hundredth and less
  return evidence.ratio ? converges(*evidence.ratio)
                        : evidence.clock_ratio <= most_of_quarter_before;
}

Finding judge(const ApproachEvidence& evidence, double limit) {
  const ClusterApproach& approach = evidence.approach;
  if (!approach.is_spent) {
    const bool is_spared = approach.deepest <= limit - digits_to_spare;
    return approach.reopened_to && is_spared ? Finding::near_collapse : Finding::undecided;
  }
  if (approach.visited < least_visited) return Finding::exact_contact;
  const double wanted = std::min(least_singular_decades, limit / 2);
  const bool is_steady = approach.steady && approach.steady->decades >= wanted;
  return is_steady && runs_out_of_time(evidence) && evidence.is_dissipative ? Finding::singular
                                                                            : Finding::undecided;
}

}  // namespace zenosphere
