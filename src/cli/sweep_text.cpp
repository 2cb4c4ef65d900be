#include "cli/sweep_text.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "case/case_entries.hpp"
#include "cli/progress_line.hpp"

namespace zenosphere {

namespace {

/// The first and the last few values of an axis.
std::string values_text(const SweepAxis& axis) {
  constexpr std::size_t shown = 8;
  std::string text;
  for (std::size_t n = 0; n < axis.size(); ++n) {
    if (n == shown && axis.size() > shown + 1) {
      return fmt::format("{}, ... ({} values)", text, axis.size());
    }
    text += (n == 0 ? "" : ", ") + case_format::shown(axis.values[n].value);
  }
  return text;
}

std::string counts_json(const RunCounts& counts) {
  return fmt::format(
      "\"runs\": {}, \"done\": {}, \"failed\": {}, \"pending\": {}, \"to_adjudicate\": {}, "
      "\"failed_adjudications\": {}",
      counts.all(), counts.done, counts.failed, counts.pending, counts.to_adjudicate,
      counts.failed_adjudications);
}

/// What comes on top of the runs: how long it takes is not known before there are hits.
std::string adjudication_line(const AdjudicationRequest& request, std::int64_t done) {
  std::string text = fmt::format(
      "  {:<32}comes on top: {} of each run with hits, at most {} s a run", "adjudication",
      request.groups ? fmt::format("the first {} groups of hits", *request.groups)
                     : std::string("all groups of hits"),
      request.seconds);
  if (done > 0) text += fmt::format("; {} of the runs done have hits to adjudicate", done);
  return text + '\n';
}

}  // namespace

std::string sweep_line(const SweepProgress& progress, std::size_t columns) {
  const RunCounts& counts = progress.counts;
  std::vector<LinePart> parts{{fmt::format("{} of {} runs done", counts.done, counts.all()), 0},
                              {fmt::format("{} running", progress.running), 3},
                              {fmt::format("{} failed", counts.failed), counts.failed > 0 ? 1 : 2}};
  if (progress.ended_here > 0) {
    const double seconds_each = progress.wall_seconds / static_cast<double>(progress.ended_here);
    const double left = seconds_each * static_cast<double>(counts.left());
    parts.push_back({fmt::format("{} left", duration_text(left)), counts.failed > 0 ? 2 : 1});
  }
  return fitted_line(std::move(parts), columns);
}

std::string progress_text(const SweepProgress& progress, const std::string& store) {
  const RunCounts& counts = progress.counts;
  std::string text = fmt::format("{}: {} of {} runs done", store, counts.done, counts.all());
  if (counts.failed > 0) {
    text +=
        fmt::format(", {} failed (column error; --retry-failed runs them again)", counts.failed);
  }
  if (counts.failed_adjudications > 0) {
    text += fmt::format(", {} could not be adjudicated (column error; --retry-failed tries again)",
                        counts.failed_adjudications);
  }
  if (counts.to_adjudicate > 0) {
    text += fmt::format(", {} to be adjudicated", counts.to_adjudicate);
  }
  text += fmt::format("; {} in {:.3g} s", progress.ended_here, progress.wall_seconds);
  if (counts.left() > 0) text += "; interrupted: the same command goes on";
  return text + '\n';
}

std::string progress_json(const SweepProgress& progress, const std::string& store) {
  return fmt::format("{{\"store\": {}, {}, \"ended_here\": {}, \"wall_seconds\": {}}}",
                     case_format::in_quotes(store), counts_json(progress.counts),
                     progress.ended_here, progress.wall_seconds);
}

std::string plan_text(const Sweep& sweep, const SweepPlan& plan, std::size_t workers,
                      const std::string& kind) {
  std::string text;
  for (const SweepAxis& axis : sweep.axes) {
    text += fmt::format("  {:<32}{}\n", axis.path(), values_text(axis));
  }
  if (sweep.boundary) {
    text += fmt::format("  {:<32}{} of {} = 1/2 to {}\n", "boundary", sweep.axes.back().path(),
                        sweep.boundary->criterion_word(), sweep.boundary->range.resolution);
    text += fmt::format("  {:<32}{}\n", "points", sweep.searches());
    text += fmt::format("  {:<32}{}\n", "runs at each, at most", sweep.boundary->range.most_runs);
  } else {
    text += fmt::format("  {:<32}{}\n", "points", sweep.points());
    text += fmt::format("  {:<32}{}\n", "seeds at each", sweep.seeds);
  }
  text += fmt::format("  {:<32}{} ({} done, {} failed)\n", "runs", plan.counts.all(),
                      plan.counts.done, plan.counts.failed);
  text += fmt::format("  {:<32}{} on {} {}, at {:.3g} s a run on average\n", "time, estimated",
                      duration_text(plan.seconds(workers)), workers, kind, plan.seconds_per_run);
  text += fmt::format("  {:<32}{}\n", "  how", plan.source);
  if (sweep.adjudicate) text += adjudication_line(*sweep.adjudicate, plan.counts.to_adjudicate);
  return text;
}

std::string plan_json(const Sweep& sweep, const SweepPlan& plan, std::size_t workers) {
  std::string axes;
  for (const SweepAxis& axis : sweep.axes) {
    std::string values;
    for (const std::string& value : json_values(axis)) {
      values += (values.empty() ? "" : ", ") + value;
    }
    axes += fmt::format("{}{}: [{}]", axes.empty() ? "" : ", ", case_format::in_quotes(axis.path()),
                        values);
  }
  return fmt::format(
      "{{\"axes\": {{{}}}, \"points\": {}, \"seeds\": {}, {}, \"workers\": {}, "
      "\"seconds_per_run\": {}, \"seconds\": {}, \"source\": {}, "
      "\"adjudication_seconds_per_run\": {}}}",
      axes, sweep.points(), sweep.seeds, counts_json(plan.counts), workers, plan.seconds_per_run,
      plan.seconds(workers), case_format::in_quotes(plan.source),
      sweep.adjudicate ? fmt::format("{}", sweep.adjudicate->seconds) : std::string("null"));
}

}  // namespace zenosphere
