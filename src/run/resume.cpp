#include "run/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "case/case_file.hpp"
#include "case/case_table.hpp"
#include "case/case_words.hpp"
#include "model/errors.hpp"
#include "result/summary.hpp"

namespace zenosphere {
namespace {

constexpr std::array changeable{"run.collisions",
                                "run.time",
                                "collision.precision",
                                "collapse.stop_when_collapsed",
                                "output.checkpoint_seconds",
                                "output.checkpoint_collisions"};

/// \param file  the output of the run
void require_changeable(const std::string& override, const std::string& file) {
  std::string key = override.substr(0, override.find('='));
  key.erase(std::remove(key.begin(), key.end(), ' '), key.end());
  if (std::find(changeable.begin(), changeable.end(), key) != changeable.end()) return;
  const std::size_t dot = std::min(key.find('.'), key.size());
  const std::string table = key.substr(0, dot);
  const std::string name = key.substr(std::min(dot + 1, key.size()));
  if (!case_format::key_named(table, name)) {
    const case_format::Key* const meant = case_format::nearest_key(table, name);
    throw InputError(fmt::format("--set {}: unknown key {}{}", override, key,
                                 meant ? fmt::format("; did you mean {}?", meant->path()) : ""));
  }
  throw InputError(fmt::format(
      "--set {}: cannot be changed in a run that has begun (only run.collisions, run.time, "
      "collision.precision, collapse.stop_when_collapsed and output.checkpoint_* can); to go on "
      "from where it is, run its case with the change and, in place of all that is under [start], "
      "arrangement = \"file\" and file = \"{}\"",
      override, file));
}

std::string collisions_are_done(std::int64_t limit, std::int64_t collisions) {
  return fmt::format(
      "has done {} collisions (run.collisions = {} is reached); raise it: --set run.collisions={}",
      collisions, limit, 2 * std::min(collisions, most_counted) + 1);
}

std::string time_is_up(double limit, double time) {
  return fmt::format("is at time {} (run.time = {} is reached); raise it: --set run.time={}", time,
                     limit, 2 * time + 1);
}

std::string has_collapsed(const Summary& reached) {
  return fmt::format(
      "collapsed at collision {} (collapse.stop_when_collapsed = true); to go on nevertheless: "
      "--set collapse.stop_when_collapsed=false",
      reached.arrest.collision.value_or(0));
}

std::string cannot_be_right(const std::string& finding) {
  return fmt::format("was ended by a self-check, {}; run the case again", finding);
}

/// Why a run that has ended cannot go on, and what to do.
std::optional<std::string> reason_to_stay(const Case& values, const Summary& reached) {
  if (reached.self_check) return cannot_be_right(*reached.self_check);
  const auto& limits = values.run;
  if (limits.collisions && *limits.collisions <= reached.collisions) {
    return collisions_are_done(*limits.collisions, reached.collisions);
  }
  if (limits.time && *limits.time <= reached.time) return time_is_up(*limits.time, reached.time);
  if (reached.arrest.met && values.collapse.stop_when_collapsed) return has_collapsed(reached);
  if (reached.ended_by == EndedBy::overlap) {
    return "ended before an overlap, as collision.overlap = \"stop\" asks; there is nothing to "
           "resume";
  }
  if (reached.ended_by == EndedBy::clock) {
    return fmt::format("has come to the end of its clock, at time {}; there is nothing to resume",
                       reached.time);
  }
  if (reached.ended_by != EndedBy::at_rest) return std::nullopt;
  return fmt::format("is at rest since time {}; there is nothing to resume", reached.time);
}

/// Why a run that was cut off would have ended before the place where it stands, and what to do.
std::optional<std::string> reason_to_refuse(const Case& values, const Summary& reached) {
  if (reached.self_check) return cannot_be_right(*reached.self_check);
  const auto& limits = values.run;
  if (limits.collisions && *limits.collisions < reached.collisions) {
    return collisions_are_done(*limits.collisions, reached.collisions);
  }
  if (limits.time && *limits.time < reached.time) return time_is_up(*limits.time, reached.time);
  const bool is_behind = reached.arrest.met && reached.arrest.collision < reached.collisions;
  if (is_behind && values.collapse.stop_when_collapsed) return has_collapsed(reached);
  return std::nullopt;
}

/// Gives a run that goes on in more digits the threshold of its new precision.
void promote(const Case& before, const std::string& file, Case& values) {
  const Precision precision = values.collision.precision;
  if (precision < before.collision.precision) {
    throw InputError(fmt::format(
        "{}: is in {} (collision.precision = {} has fewer digits, which cannot be taken away); run "
        "the case again",
        file, word(before.collision.precision), word(precision)));
  }
  if (values.collapse.gap_threshold == GapThreshold(before.collision.precision)) {
    values.collapse.gap_threshold = GapThreshold(precision);
  }
}

}  // namespace

Case case_to_resume(const RecoveredOutput& output, std::span<const std::string> overrides) {
  for (const std::string& override : overrides) {
    require_changeable(override, output.path.string());
  }
  Case values = parse_case(output.info.resolved_case, output.path.string(), overrides);
  values.text = output.info.case_text;
  promote(parse_case(output.info.resolved_case, output.path.string(), {}), output.path.string(),
          values);
  // A run that was cut off at its very end has its end still to write. One that was made longer and
  // cut off before its first checkpoint has a journal, and stands where it had ended nevertheless.
  const bool has_ended =
      output.info.complete && (output.journal.size() == 0 || output.checkpoint.summary.empty());
  const std::string summary =
      has_ended ? output.info.summary.value_or("") : output.checkpoint.summary;
  const Summary reached = summary_from_json(summary, output.info.dimension);
  const auto reason =
      has_ended ? reason_to_stay(values, reached) : reason_to_refuse(values, reached);
  if (reason) {
    throw InputError(fmt::format("{}: {}", output.path.string(), *reason));
  }
  return values;
}

}  // namespace zenosphere
