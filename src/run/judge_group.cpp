#include "run/judge_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "case/case_words.hpp"
#include "run/approach_sentence.hpp"

namespace zenosphere {
namespace {

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

bool have_common(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
  return std::any_of(a.begin(), a.end(), [&](std::int32_t sphere) {
    return std::binary_search(b.begin(), b.end(), sphere);
  });
}

/// Whether the run's own rounding had closed a gap of the spheres before the trial began.
bool was_rounded(double begin_depth, const std::vector<FollowedGroup>& ladder) {
  return begin_depth > ladder.front().limit - digits_to_spare;
}

/// The approach before in which some of the same spheres had used up the digits of the trial.
const SeenApproach* spent_before(const SeenApproach& seen, const FollowedGroup& top) {
  const SeenApproach* last = nullptr;
  for (const SeenApproach& other : top.seen) {
    if (&other == &seen) break;
    const bool is_spent = other.evidence.approach.is_spent &&
                          judge(other.evidence, top.limit) != Finding::exact_contact;
    if (is_spent && have_common(other.spheres, seen.spheres)) last = &other;
  }
  return last;
}

/// Lets a finding say no more than was seen: what rounding may have made is no exact contact, and
/// what comes after the end of the digits is said to be made by the overlap rule.
void weigh_rounding(JudgedApproach& judged, const SeenApproach& seen,
                    const std::vector<FollowedGroup>& ladder) {
  const FollowedGroup& top = ladder.back();
  const bool is_rounded = was_rounded(seen.begin_depth, ladder);
  const SeenApproach* const spent = spent_before(seen, top);
  if (judged.finding == Finding::exact_contact && (is_rounded || spent)) {
    judged.finding = Finding::undecided;
    judged.sentence = fmt::format("gaps of {} are zero in {}", count_and_names(judged.spheres),
                                  word(judged.precision));
  }
  if (spent) {
    judged.sentence += fmt::format(
        "; this comes after the digits were spent at collision {}, from what the overlap rule has "
        "made of it",
        spent->first_collision);
  } else if (is_rounded) {
    judged.sentence += fmt::format(
        "; the rounding of the run in {} had closed gaps of theirs already at collision {}, from "
        "where they were followed: a run with a higher collision.precision would decide",
        word(ladder.front().trial.precision), top.begin.collisions);
  }
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
                        .curvature = seen.evidence.curvature,
                        .reopened_to = approach.reopened_to,
                        .milestones = seen.milestones,
                        .followed_from = top.begin.collisions,
                        .run_hit = group.first_hit};
  if (seen.collapse_time && judged.finding == Finding::singular) {
    judged.collapse_time = to_error(*seen.collapse_time, seen.uncertainty.value_or(0));
    judged.uncertainty = seen.uncertainty;
  }
  for (auto lower = ladder.begin(); lower + 1 != ladder.end(); ++lower) {
    judged.losses.push_back(loss_of(*lower, top, seen));
  }
  judged.sentence = sentence_of(judged, seen.evidence);
  weigh_rounding(judged, seen, ladder);
  if (judged.finding == Finding::exact_contact) judged.decades = 0;  // none was fallen through
  return judged;
}

/// What is said of a pair that met once, from its smallest gap.
void judge_pair(JudgedApproach& judged, const DepthRow& deepest,
                const std::vector<FollowedGroup>& ladder) {
  const std::string precision = word(judged.precision);
  if (!deepest.at_limit) {
    judged.finding = Finding::chance_close_pair;
    judged.sentence =
        deepest.depth < least_approach_depth
            ? fmt::format(
                  "{} and {} do not come close: with the digits of {} their gap is 1e-{:.1f}",
                  deepest.i, deepest.j, precision, deepest.depth)
            : fmt::format(
                  "{} and {} come close once: with the digits of {} their gap is 1e-{:.1f}, and it "
                  "does not go on falling",
                  deepest.i, deepest.j, precision, deepest.depth);
    return;
  }
  const std::int64_t begin = judged.followed_from;
  if (was_rounded(ladder.back().begin.depth, ladder)) {
    judged.sentence = fmt::format(
        "the gap of {} and {} is zero in {} too, but the rounding of the run in {} had closed gaps "
        "already at collision {}, from where they were followed: a run with a higher "
        "collision.precision would decide",
        deepest.i, deepest.j, precision, word(ladder.front().trial.precision), begin);
    return;
  }
  judged.finding = Finding::exact_contact;
  judged.decades = 0;
  judged.sentence = fmt::format(
      "the gap of {} and {} is zero in {} too, and nothing decays: contact by symmetry or by the "
      "start",
      deepest.i, deepest.j, precision);
}

/// A contact of the pair that the run's hit is of, or of two spheres of its group.
bool is_within(const HitGroup& group, const DepthRow& row) {
  const auto is_in = [&](std::int32_t sphere) {
    return std::binary_search(group.spheres.begin(), group.spheres.end(), sphere);
  };
  return (row.i == group.i && row.j == group.j) || (is_in(row.i) && is_in(row.j));
}

/// A group that no cluster belongs to in the highest precision: a pair that met once; nothing where
/// it has not met.
std::optional<JudgedApproach> judged_pair(const HitGroup& group,
                                          const std::vector<FollowedGroup>& ladder) {
  const FollowedGroup& top = ladder.back();
  JudgedApproach judged{.precision = top.trial.precision,
                        .spheres = group.spheres,
                        .followed_from = top.begin.collisions,
                        .run_hit = group.first_hit};
  const DepthRow* deepest = nullptr;
  std::size_t place = 0;
  for (std::size_t k = 0; k < top.rows.size(); ++k) {
    const DepthRow& row = top.rows[k];
    if (!is_within(group, row) || (deepest && row.depth <= deepest->depth)) continue;
    deepest = &row;
    place = k;
  }
  if (!deepest) return std::nullopt;
  judged.first_collision =
      std::max<std::int64_t>(top.first_number + static_cast<std::int64_t>(place) - 1, 0);
  judged.first_time = fmt::format("{}", group.first_time);
  judged.decades = whole(deepest->depth);
  judge_pair(judged, *deepest, ladder);
  return judged;
}

JudgedApproach not_met(const HitGroup& group, const FollowedGroup& top) {
  return {.sentence = fmt::format(
              "{} and {}, whose hit the run has at collision {}, do not meet in {} when followed "
              "from collision {}, where the run was rounded otherwise: a run with a higher "
              "collision.precision would have hits of its own",
              group.i, group.j, group.first_hit, word(top.trial.precision), top.begin.collisions),
          .precision = top.trial.precision,
          .spheres = group.spheres,
          .followed_from = top.begin.collisions,
          .run_hit = group.first_hit};
}

bool holds(const std::vector<JudgedApproach>& judged, Finding finding) {
  return std::any_of(judged.begin(), judged.end(),
                     [&](const JudgedApproach& one) { return one.finding == finding; });
}

/// The trial ended before its digits were spent or its spheres had flown apart.
bool was_cut_off(const FollowedGroup& top) {
  const auto end = top.trial.ended_by;
  return end == EndedBy::budget || end == EndedBy::collisions || end == EndedBy::interrupted ||
         end == EndedBy::others;
}

JudgedApproach cut_off(const HitGroup& group, const FollowedGroup& top) {
  const Trial& trial = top.trial;
  const bool is_by_others = trial.ended_by == EndedBy::others;
  return {
      .sentence = fmt::format(
          "the trial in {} ended at collision {}, time {}, before its spheres had flown apart{}",
          word(trial.precision), trial.collisions, trial.time.substr(0, 20),
          is_by_others ? ": other spheres have used up its digits, and if they collapse there, "
                         "the model has no time after it"
                       : "; more --seconds or --collisions would decide"),
      .precision = trial.precision,
      .spheres = group.spheres,
      .decades = whole(trial.deepest),
      .first_collision = trial.collisions,
      .first_time = trial.time,
      .followed_from = top.begin.collisions,
      .run_hit = group.first_hit};
}

/// The clock stands still in the run's precision, and in the highest it does not.
bool is_arithmetic_arrest(const HitGroup& group, const std::vector<FollowedGroup>& ladder) {
  return ladder.size() > 1 && group.arrest && ladder.back().trial.ended_by == EndedBy::apart;
}

}  // namespace

std::vector<JudgedApproach> judge_group(const HitGroup& group,
                                        const std::vector<FollowedGroup>& ladder) {
  const FollowedGroup& top = ladder.back();
  std::vector<JudgedApproach> all;
  for (const SeenApproach& seen : top.seen) all.push_back(judged(seen, ladder, group));
  if (all.empty()) {
    const auto pair = judged_pair(group, ladder);
    all.push_back(pair || !was_cut_off(top) ? pair.value_or(not_met(group, top))
                                            : cut_off(group, top));
  }
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

std::vector<JudgedApproach>::iterator strongest(std::vector<JudgedApproach>& approaches) {
  return std::max_element(
      approaches.begin(), approaches.end(),
      [](const JudgedApproach& a, const JudgedApproach& b) { return a.finding < b.finding; });
}

bool wants_more_digits(const FollowedGroup& top) {
  return std::any_of(top.seen.begin(), top.seen.end(), [&](const SeenApproach& seen) {
    const ClusterApproach& approach = seen.evidence.approach;
    // Elastic gaps that are zero by symmetry are rounded to the last digit of any precision.
    const bool is_reversed =
        seen.evidence.is_dissipative && approach.deepest > top.limit - digits_to_spare;
    const bool is_at_end = approach.is_spent || is_reversed;
    return is_at_end && judge(seen.evidence, top.limit) == Finding::undecided;
  });
}

}  // namespace zenosphere
