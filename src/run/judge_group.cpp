#include "run/judge_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/case_words.hpp"

namespace zenosphere {
namespace {

int whole(double decades) { return static_cast<int>(std::floor(decades)); }

/// A time as text, to two digits behind its error.
std::string to_error(const std::string& time, double error) {
  const auto point = time.find('.');
  if (!(error > 0) || point == std::string::npos || time.find('e') != std::string::npos) {
    return time;
  }
  const double digits = std::max(1.0, std::ceil(-std::log10(error)) + 1);
  return time.substr(0, point + 1 + static_cast<std::size_t>(digits));
}

/// Where a lower precision loses an approach: its gaps are at its limit, or its contacts are others
/// than those of the highest one.
Loss loss_of(const FollowedGroup& lower, const FollowedGroup& top, const SeenApproach& seen) {
  Loss loss{.precision = lower.trial.precision};
  const auto is_in = [&](const DepthRow& row) {
    const auto& spheres = seen.spheres;
    return std::binary_search(spheres.begin(), spheres.end(), row.i) &&
           std::binary_search(spheres.begin(), spheres.end(), row.j);
  };
  const std::size_t end = seen.places.empty() ? 0 : seen.places.back() + 1;
  std::size_t other = 0;
  double deepest = 0;
  for (std::size_t k = 0; k < end; ++k) {
    const DepthRow& row = top.rows[k];
    if (!is_in(row)) continue;
    while (other < lower.rows.size() && !is_in(lower.rows[other])) ++other;
    const bool is_same =
        other < lower.rows.size() && lower.rows[other].i == row.i && lower.rows[other].j == row.j;
    if (!is_same || lower.rows[other].at_limit) {
      loss.collision = top.first_number + static_cast<std::int64_t>(k);
      break;
    }
    if (!row.at_limit) deepest = std::max(deepest, row.depth);
    ++other;
  }
  loss.decade = whole(deepest);
  return loss;
}

std::string names_of(const std::vector<std::int32_t>& spheres) {
  constexpr std::size_t most = 6;
  std::string names;
  for (std::size_t k = 0; k < std::min(spheres.size(), most); ++k) {
    names += fmt::format("{}{}", k == 0 ? "" : "-", spheres[k]);
  }
  return spheres.size() > most ? names + "-..." : names;
}

std::string law_of(const JudgedApproach& judged) {
  std::string law;
  if (judged.steady) {
    law = fmt::format("{:.0f} decades by one law, {:.3g} decades a collision",
                      judged.steady->decades, judged.steady->per_collision);
  }
  if (judged.word.is_periodic && judged.ratio) {
    law += fmt::format("{}word {} with ratio {:.6g}", law.empty() ? "" : "; ", judged.word.letters,
                       judged.ratio->ratio);
  }
  return law;
}

std::string sentence_of(const JudgedApproach& judged, const ClusterApproach& approach) {
  const std::string who =
      fmt::format("{} spheres ({})", judged.spheres.size(), names_of(judged.spheres));
  const std::string precision = word(judged.precision);
  switch (judged.finding) {
    case Finding::singular:
      return fmt::format(
          "the gaps of {} fall to 1e-{}, all that {} has, {}, with energy lost; infinitely many "
          "collisions end at {}",
          who, judged.decades, precision, law_of(judged),
          judged.collapse_time
              ? fmt::format("{} +- {:.1g}", *judged.collapse_time, judged.uncertainty.value_or(0))
              : std::string("a time that was not extrapolated"));
    case Finding::near_collapse:
      return fmt::format(
          "the gaps of {} fall together to 1e-{} and grow again to 1e-{}, with digits of {} to "
          "spare",
          who, judged.decades, whole(judged.reopened_to.value_or(0)), precision);
    case Finding::exact_contact:
      return fmt::format(
          "gaps of {} are zero in {} without having decayed: contact by symmetry or by the start",
          who, precision);
    default:
      break;
  }
  if (!approach.is_spent) {
    return fmt::format(
        "the gaps of {} were still falling at 1e-{} when the trial in {} ended; more --seconds or "
        "--collisions would decide",
        who, judged.decades, precision);
  }
  if (judged.ratio && !converges(*judged.ratio)) {
    return fmt::format(
        "the gaps of {} fall until the digits of {} are spent, but the ratio of their rounds "
        "({:.6g})"
        " still drifts: more digits would tell whether it stays below one",
        who, precision, judged.ratio->ratio);
  }
  return fmt::format(
      "the gaps of {} fall until the digits of {} are spent, by one law over {:.0f} decades only; "
      "more digits would decide",
      who, precision, judged.steady ? judged.steady->decades : 0.0);
}

JudgedApproach judged(const SeenApproach& seen, const std::vector<FollowedGroup>& ladder,
                      const HitGroup& group) {
  const FollowedGroup& top = ladder.back();
  const ClusterApproach& approach = seen.evidence.approach;
  JudgedApproach judged{.finding = judge(seen.evidence, top.limit),
                        .precision = top.trial.precision,
                        .spheres = seen.spheres,
                        .decades = whole(approach.deepest),
                        .first_collision = seen.first_collision,
                        .first_time = seen.first_time,
                        .word = seen.evidence.word,
                        .ratio = seen.evidence.ratio,
                        .steady = approach.steady,
                        .reopened_to = approach.reopened_to,
                        .milestones = seen.milestones,
                        .run_hit = group.first_hit};
  if (seen.collapse_time && judged.finding == Finding::singular) {
    judged.collapse_time = to_error(*seen.collapse_time, seen.uncertainty.value_or(0));
    judged.uncertainty = seen.uncertainty;
  }
  for (auto lower = ladder.begin(); lower + 1 != ladder.end(); ++lower) {
    judged.losses.push_back(loss_of(*lower, top, seen));
  }
  judged.sentence = sentence_of(judged, approach);
  return judged;
}

/// A group that no cluster belongs to in the highest precision: a pair that met once.
JudgedApproach judged_pair(const HitGroup& group, const FollowedGroup& top) {
  JudgedApproach judged{
      .precision = top.trial.precision, .spheres = group.spheres, .run_hit = group.first_hit};
  const DepthRow* deepest = nullptr;
  std::size_t place = 0;
  for (std::size_t k = 0; k < top.rows.size(); ++k) {
    const DepthRow& row = top.rows[k];
    if (row.i != group.i || row.j != group.j) continue;
    if (deepest && row.depth <= deepest->depth) continue;
    deepest = &row;
    place = k;
  }
  if (!deepest) {
    judged.sentence = fmt::format(
        "{} and {}, whose hit the run has at collision {}, did not meet in the trial in {}",
        group.i, group.j, group.first_hit, word(judged.precision));
    return judged;
  }
  judged.first_collision =
      std::max<std::int64_t>(top.first_number + static_cast<std::int64_t>(place) - 1, 0);
  judged.first_time = fmt::format("{}", group.first_time);
  judged.decades = whole(deepest->depth);
  if (deepest->at_limit) {
    judged.finding = Finding::exact_contact;
    judged.sentence = fmt::format(
        "the gap of {} and {} is zero in {} too, and nothing decays: contact by symmetry or by the "
        "start",
        group.i, group.j, word(judged.precision));
  } else {
    judged.finding = Finding::chance_close_pair;
    judged.sentence = fmt::format(
        "{} and {} come close once: with the digits of {} their gap is 1e-{:.1f}, and it does not "
        "go on falling",
        group.i, group.j, word(judged.precision), deepest->depth);
  }
  return judged;
}

bool holds(const std::vector<JudgedApproach>& judged, Finding finding) {
  return std::any_of(judged.begin(), judged.end(),
                     [&](const JudgedApproach& one) { return one.finding == finding; });
}

/// The trial ended before its digits were spent or its spheres had flown apart.
bool was_cut_off(const FollowedGroup& top) {
  const std::string& end = top.trial.ended_by;
  return end == "budget" || end == "collisions" || end == "interrupted";
}

JudgedApproach cut_off(const HitGroup& group, const FollowedGroup& top) {
  const Trial& trial = top.trial;
  return {.sentence = fmt::format(
              "the trial in {} ended at collision {}, time {}, before its spheres had flown apart; "
              "more --seconds or --collisions would decide",
              word(trial.precision), trial.collisions, trial.time.substr(0, 20)),
          .precision = trial.precision,
          .spheres = group.spheres,
          .decades = whole(trial.deepest),
          .first_collision = trial.collisions,
          .first_time = trial.time,
          .run_hit = group.first_hit};
}

/// The clock stands still in the run's precision, and in the highest it does not.
bool is_arithmetic_arrest(const HitGroup& group, const std::vector<FollowedGroup>& ladder) {
  return ladder.size() > 1 && group.arrest && ladder.back().trial.ended_by == "apart";
}

}  // namespace

std::vector<JudgedApproach> judge_group(const HitGroup& group,
                                        const std::vector<FollowedGroup>& ladder) {
  const FollowedGroup& top = ladder.back();
  std::vector<JudgedApproach> all;
  for (const SeenApproach& seen : top.seen) all.push_back(judged(seen, ladder, group));
  if (all.empty()) all.push_back(judged_pair(group, top));
  if (was_cut_off(top) && !holds(all, Finding::singular) && !holds(all, Finding::undecided)) {
    all.push_back(cut_off(group, top));
  }
  if (ladder.size() == 1) {
    for (JudgedApproach& one : all) {
      one.finding = Finding::undecided;
      one.sentence = "no precision above the run's own was tried";
    }
  }
  if (is_arithmetic_arrest(group, ladder) && !holds(all, Finding::singular)) {
    JudgedApproach arrest = all.front();
    arrest.finding = Finding::arithmetic_arrest;
    arrest.sentence = fmt::format(
        "in {} the clock stands still, which is certain at collision {}; in {} it goes on",
        word(ladder.front().trial.precision), *group.arrest, word(top.trial.precision));
    all.push_back(arrest);
  }
  return all;
}

bool wants_more_digits(const FollowedGroup& top) {
  return std::any_of(top.seen.begin(), top.seen.end(), [&](const SeenApproach& seen) {
    return seen.evidence.approach.is_spent && judge(seen.evidence, top.limit) == Finding::undecided;
  });
}

}  // namespace zenosphere
