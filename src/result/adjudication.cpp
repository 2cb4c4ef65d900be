#include "result/adjudication.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "case/case_words.hpp"
#include "text/counted.hpp"
#include "text/json.hpp"

namespace zenosphere {
namespace {

/// A number, or its text where it is too small for one.
Json json_of(const GapThreshold& threshold) {
  return threshold.fits_double() ? Json(threshold.nearest_double()) : Json(threshold.text());
}

Json json_of(const Trial& trial) {
  return {{"precision", word(trial.precision)},
          {"overlap", word(trial.rule)},
          {"gap_threshold", json_of(trial.gap_threshold)},
          {"collisions", trial.collisions},
          {"ended_by", word(trial.ended_by)},
          {"time", trial.time},
          {"hits", trial.hits},
          {"first_hit", or_null(trial.first_hit)},
          {"first_hit_time", or_null(trial.first_hit_time)},
          {"last_hit", or_null(trial.last_hit)},
          {"absorbed", trial.absorbed},
          {"arrest", or_null(trial.arrest)},
          {"deepest_decade", trial.deepest}};
}

Json json_of(const SteadyFall& steady) {
  return {{"decades", steady.decades},
          {"decades_per_collision", steady.per_collision},
          {"unevenness", steady.unevenness}};
}

Json json_of(const Curvature& curvature) {
  return {{"margin", curvature.margin},
          {"margin_per_decade", curvature.per_decade},
          {"gives_way_at_decade", or_null(gives_way_at(curvature))}};
}

Json json_of(const RoundRatio& ratio) {
  return {{"ratio", ratio.ratio},
          {"change_in_second_quarter", ratio.change_before},
          {"change_in_second_half", ratio.change}};
}

template <class Value>
Json json_or_null(const std::optional<Value>& value) {
  return value ? json_of(*value) : Json(nullptr);
}

Json milestones_of(const JudgedApproach& approach) {
  Json milestones = Json::array();
  for (const Milestone& milestone : approach.milestones) {
    milestones.push_back({{"decade", milestone.decade},
                          {"collision", milestone.collision},
                          {"time", milestone.time}});
  }
  return milestones;
}

Json losses_of(const JudgedApproach& approach) {
  Json losses = Json::array();
  for (const Loss& loss : approach.losses) {
    losses.push_back({{"precision", word(loss.precision)},
                      {"collision", or_null(loss.collision)},
                      {"decade", loss.decade}});
  }
  return losses;
}

Json json_of(const JudgedApproach& approach) {
  return {{"finding", word(approach.finding)},
          {"sentence", approach.sentence},
          {"precision", word(approach.precision)},
          {"spheres", approach.spheres},
          {"decades", approach.decades},
          {"first_collision", approach.first_collision},
          {"first_time", approach.first_time},
          {"collapse_time", or_null(approach.collapse_time)},
          {"uncertainty", or_null(approach.uncertainty)},
          {"word", approach.word.letters},
          {"word_is_periodic", approach.word.is_periodic},
          {"round_ratio", json_or_null(approach.ratio)},
          {"steady_fall", json_or_null(approach.steady)},
          {"curvature", json_or_null(approach.curvature)},
          {"reopened_to_decade", or_null(approach.reopened_to)},
          {"enclosed_to", or_null(approach.enclosed_to)},
          {"milestones", milestones_of(approach)},
          {"lost_by", losses_of(approach)},
          {"followed_from", approach.followed_from},
          {"run_hit", approach.run_hit}};
}

std::string text_of(const JudgedApproach& approach) {
  std::string text = fmt::format("{:>9}  {:<18} {:>7} {:>8} {:>12}  {:<22} {}\n", approach.run_hit,
                                 word(approach.finding), approach.spheres.size(), approach.decades,
                                 approach.first_collision, approach.first_time.substr(0, 22),
                                 approach.collapse_time.value_or("-").substr(0, 40));
  return text;
}

std::string text_of(const Trial& trial) {
  const auto number = [](const std::optional<std::int64_t>& value) {
    return value ? fmt::format("{}", *value) : std::string("-");
  };
  return fmt::format("{:<10} {:<10} {:>9} {:<20} {:>8} {:>9} {:>9} {:>9} {:>9}  {}\n",
                     word(trial.precision), word(trial.rule), number(trial.first_hit),
                     trial.first_hit_time.value_or("-").substr(0, 20), trial.hits,
                     trial.deepest > 0 ? fmt::format("1e-{:.0f}", trial.deepest) : "-",
                     trial.absorbed, number(trial.arrest), trial.collisions, word(trial.ended_by));
}

}  // namespace

void refute(JudgedApproach& approach, std::string sentence) {
  approach.finding = Finding::near_collapse;
  approach.collapse_time.reset();
  approach.uncertainty.reset();
  approach.sentence = std::move(sentence);
}

void add_distinct(const std::vector<JudgedApproach>& found, std::vector<JudgedApproach>& all) {
  for (const JudgedApproach& one : found) {
    const bool is_known = std::any_of(all.begin(), all.end(), [&](const JudgedApproach& known) {
      return known.spheres == one.spheres && known.first_collision == one.first_collision &&
             known.first_time == one.first_time && known.finding == one.finding;
    });
    if (!is_known) all.push_back(one);
  }
}

std::string to_json(const Adjudication& adjudication) {
  Json approaches = Json::array();
  for (const JudgedApproach& one : adjudication.approaches) approaches.push_back(json_of(one));
  Json trials = Json::array();
  for (const Trial& trial : adjudication.trials) trials.push_back(json_of(trial));
  const Json json{{"precision", word(adjudication.precision)},
                  {"overlap", word(adjudication.rule)},
                  {"hits", adjudication.hits},
                  {"first_hit", or_null(adjudication.first_hit)},
                  {"finding", adjudication.is_without_hits ? Json() : word(adjudication.finding)},
                  {"sentence", adjudication.sentence},
                  {"approaches", approaches},
                  {"groups_left_out", adjudication.left_out},
                  {"groups_beyond", adjudication.beyond},
                  {"interrupted", adjudication.was_interrupted},
                  {"trials", trials}};
  return json.dump();
}

std::string to_text(const Adjudication& adjudication) {
  if (adjudication.is_without_hits) {
    return fmt::format("Nothing to adjudicate: {}.\n", adjudication.sentence);
  }
  std::string text = counted(adjudication.hits, "hit") + " in " + word(adjudication.precision);
  if (adjudication.first_hit) {
    text += fmt::format(", {}at collision {}", adjudication.hits == 1 ? "" : "the first ",
                        *adjudication.first_hit);
  }
  text += ".\n\n";
  text += fmt::format("{:>9}  {:<18} {:>7} {:>8} {:>12}  {:<22} {}\n", "run's hit", "finding",
                      "spheres", "decades", "met at", "time", "collapse time");
  for (const JudgedApproach& one : adjudication.approaches) text += text_of(one);
  text += fmt::format(
      "\nFrom before the first hit:\n{:<10} {:<10} {:>9} {:<20} {:>8} {:>9} {:>9} "
      "{:>9} {:>9}  {}\n",
      "precision", "overlap", "first hit", "at time", "hits", "smallest", "absorbed", "arrest",
      "end", "ended by");
  for (const Trial& trial : adjudication.trials) text += text_of(trial);
  return text + fmt::format("\n{}: {}.\n", word(adjudication.finding), adjudication.sentence);
}

}  // namespace zenosphere
