#include "io/adjudication.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "io/case_words.hpp"
#include "io/json.hpp"
#include "model/real.hpp"

namespace zenosphere {
namespace {

Json json_of(const Trial& trial) {
  return {{"precision", word(trial.precision)},
          {"overlap", word(trial.rule)},
          {"gap_threshold", trial.gap_threshold},
          {"collisions", trial.collisions},
          {"ended_by", trial.ended_by},
          {"time", trial.time},
          {"hits", trial.hits},
          {"first_hit", or_null(trial.first_hit)},
          {"first_hit_time", or_null(trial.first_hit_time)},
          {"last_hit", or_null(trial.last_hit)},
          {"absorbed", trial.absorbed},
          {"arrest", or_null(trial.arrest)},
          {"collapse_time", or_null(trial.collapse_time)},
          {"collapse_ratio", or_null(trial.collapse_ratio)},
          {"collisions_per_decade", trial.per_decade},
          {"without_gap", trial.without_gap}};
}

/// The trials under the run's own rule, from its own precision upwards.
std::vector<const Trial*> ladder_of(const Adjudication& adjudication) {
  std::vector<const Trial*> ladder;
  for (const Trial& trial : adjudication.trials) {
    if (trial.rule == adjudication.rule) ladder.push_back(&trial);
  }
  return ladder;
}

/// How far two times are apart, to the digits that they have.
double apart(const std::string& one, const std::string& other) {
  return static_cast<double>(abs(Digits100(Digits100(one) - Digits100(other))));
}

/// By how much the time of the first hit changes from one rung of the ladder to the next, and how
/// many decades of gap lie between their thresholds.
struct Step {
  double change;
  double decades;
};

/// The steps up the ladder; nothing where a rung has no hit.
std::optional<std::vector<Step>> steps_of(const std::vector<const Trial*>& ladder) {
  std::vector<Step> steps;
  for (std::size_t k = 0; k < ladder.size(); ++k) {
    if (!ladder[k]->first_hit_time) return std::nullopt;
    if (k == 0) continue;
    steps.push_back({apart(*ladder[k]->first_hit_time, *ladder[k - 1]->first_hit_time),
                     std::log10(ladder[k - 1]->gap_threshold / ladder[k]->gap_threshold)});
  }
  return steps;
}

/// Whether the hits of the rungs belong to one series that ends: each comes within a hundredth of
/// the time between two collisions of a sphere of the one before, and on the last step each decade
/// of gap takes at most a tenth of the time that it took on a step before.
///
/// Where gaps shrink geometrically in time, c - t ~ gap^p, the time for a decade falls whatever p;
/// a gap that shrinks for ever takes the same time or more for each. Nothing is told where the case
/// has fixed the threshold: then the rungs do not differ in it.
bool converges(const std::vector<const Trial*>& ladder, double time_between_collisions) {
  const auto steps = steps_of(ladder);
  if (!steps || steps->size() < 2) return false;
  double slowest = 0;  // time for a decade on the steps before the last one
  for (const auto& [change, decades] : *steps) {
    if (!(change < time_between_collisions / 100) || !(decades > 0)) return false;
    if (&change != &steps->back().change) slowest = std::max(slowest, change / decades);
  }
  return steps->back().change / steps->back().decades <= slowest / 10;
}

/// A time as text, to two digits behind its error.
std::string to_error(const std::string& time, double error) {
  const double digits = error > 0 ? std::ceil(-std::log10(error)) + 1 : 100;
  const auto end = time.find('.') + 1 + static_cast<std::size_t>(std::max(digits, 1.0));
  return time.substr(0, end);
}

std::string names(const std::vector<const Trial*>& ladder) {
  std::string names;
  for (std::size_t k = 1; k < ladder.size(); ++k) {
    names += k == 1 ? "" : k + 1 == ladder.size() ? " and " : ", ";
    names += word(ladder[k]->precision);
  }
  return names;
}

std::string singularity(const std::vector<const Trial*>& ladder) {
  const Trial& top = *ladder.back();
  const Trial& next = *ladder[ladder.size() - 2];
  const double step = steps_of(ladder).value().back().change;
  const std::string rungs = fmt::format("{} to {}", word(next.precision), word(top.precision));
  std::string text = fmt::format("the hit stays in {}, and its time converges", names(ladder));
  if (top.collapse_time && next.collapse_time) {
    const double error = apart(*top.collapse_time, *next.collapse_time);
    return text + fmt::format("; the flights add up to {} +- {:.1g} (the change from {})",
                              to_error(*top.collapse_time, error), error, rungs);
  }
  return text + fmt::format("; collapse at {} +- {:.1g} (the change from {})",
                            to_error(*top.first_hit_time, step), step, rungs);
}

/// What the run itself does.
std::string what_happened(const Trial& run) {
  if (run.arrest) {
    return fmt::format(
        "in {} the clock stands still from collision {} on, with {} impulses absorbed",
        word(run.precision), *run.arrest, run.absorbed);
  }
  return fmt::format("in {} {} hits, the last at collision {}", word(run.precision), run.hits,
                     run.last_hit.value_or(0));
}

}  // namespace

void conclude(Adjudication& adjudication) {
  const auto ladder = ladder_of(adjudication);
  assert(!ladder.empty());
  const Trial& run = *ladder.front();
  const Trial& top = *ladder.back();
  const auto met = std::count_if(ladder.begin() + 1, ladder.end(),
                                 [](const Trial* trial) { return trial->hits > 0; });
  const bool never = met == 0 && ladder.size() > 1;
  const bool always = met + 1 == static_cast<std::ptrdiff_t>(ladder.size());
  const std::string evidence = what_happened(run);
  if (never && run.arrest) {
    adjudication.finding = Finding::arithmetic_arrest;
    adjudication.sentence = fmt::format("{}; in {} there is no hit", evidence, names(ladder));
  } else if (never) {
    adjudication.finding = Finding::chance_close_pair;
    adjudication.sentence = fmt::format("{}; in {} there is none", evidence, names(ladder));
  } else if (always && converges(ladder, adjudication.time_between_collisions)) {
    adjudication.finding = Finding::finite_time_singularity;
    adjudication.sentence = fmt::format("{}; {}", singularity(ladder), evidence);
  } else if (run.arrest && !top.arrest) {
    adjudication.finding = Finding::arithmetic_arrest;
    adjudication.sentence =
        fmt::format("{}; in {} it goes on up to time {}", evidence, word(top.precision), top.time);
  } else {
    adjudication.sentence =
        fmt::format("{}; of {} {} meet the criterion, at times that do not converge", evidence,
                    names(ladder), met);
  }
  if (ladder.size() == 1) adjudication.sentence = "no precision above the run's own was tried";
}

const char* word(Finding finding) {
  switch (finding) {
    case Finding::chance_close_pair:
      return "chance close pair";
    case Finding::finite_time_singularity:
      return "finite-time singularity";
    case Finding::arithmetic_arrest:
      return "arithmetic arrest";
    case Finding::undecided:
      break;
  }
  return "undecided";
}

std::string to_json(const Adjudication& adjudication) {
  Json trials = Json::array();
  for (const Trial& trial : adjudication.trials) trials.push_back(json_of(trial));
  const Json json{{"precision", word(adjudication.precision)},
                  {"overlap", word(adjudication.rule)},
                  {"first_hit", adjudication.hit},
                  {"from_collision", adjudication.from},
                  {"finding", word(adjudication.finding)},
                  {"sentence", adjudication.sentence},
                  {"trials", trials}};
  return json.dump();
}

std::string to_text(const Adjudication& adjudication) {
  const auto number = [](const std::optional<std::int64_t>& value) {
    return value ? fmt::format("{}", *value) : std::string("-");
  };
  std::string text = fmt::format(
      "First hit at collision {}; every trial goes on from the state after {}.\n\n"
      "{:<10} {:<10} {:>9} {:<20} {:>8} {:>9} {:>9} {:>9} {:>9}  {}\n",
      adjudication.hit, adjudication.from, "precision", "overlap", "first hit", "at time", "hits",
      "smallest", "absorbed", "arrest", "end", "ended by");
  for (const Trial& trial : adjudication.trials) {
    const auto smallest = trial.per_decade.size();
    text += fmt::format("{:<10} {:<10} {:>9} {:<20} {:>8} {:>9} {:>9} {:>9} {:>9}  {}\n",
                        word(trial.precision), word(trial.rule), number(trial.first_hit),
                        trial.first_hit_time.value_or("-").substr(0, 20), trial.hits,
                        fmt::format("1e-{}", smallest), trial.absorbed, number(trial.arrest),
                        trial.collisions, trial.ended_by);
  }
  return text + fmt::format("\n{}: {}.\n", word(adjudication.finding), adjudication.sentence);
}

}  // namespace zenosphere
