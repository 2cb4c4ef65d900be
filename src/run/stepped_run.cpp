#include "run/stepped_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "case/case_file.hpp"
#include "collapse/verdict.hpp"
#include "model/errors.hpp"
#include "run/arithmetic.hpp"
#include "run/recorded_series.hpp"
#include "run/setup.hpp"
#include "run/species_summary.hpp"

namespace zenosphere {

SteppedRun::SteppedRun(const Case& values, const RunOptions& options)
    : values_(values), options_(options) {
  // Before hours are spent on what cannot be kept.
  if (options_.output) permitted_target(*options_.output, options_.existing);
  const CasePrecision here(values_);
  simulation_ = new_observed(values_, options_.interrupt);
  clock_ = RunClock();  // to make the start takes no time of the run
  if (!options_.output) return;
  output_.emplace(values_.output, 0, *options_.output, output_header(values_), options_.existing);
  simulation_->record_to(output_->file());
  output_->file().begin(checkpoint());  // whatever happens now, the start is kept
}

SteppedRun::SteppedRun(const Case& values, RecoveredOutput output, const RunOptions& options)
    : values_(values), options_(options) {
  const CasePrecision here(values_);
  const std::string name = output.path.string();
  try {
    go_on_from(std::move(output));
  } catch (const ArchiveError& error) {
    throw InputError(fmt::format("{}: has a checkpoint that is damaged ({}); run the case again",
                                 name, error.what()));
  }
}

void SteppedRun::go_on_from(RecoveredOutput output) {
  const Bytes bytes = std::move(output.checkpoint.state);
  ArchiveReader state(bytes);
  simulation_ = archived_observed(values_, options_.interrupt, output, state);
  clock_ = RunClock(output.checkpoint.wall_seconds);
  output_.emplace(values_.output, simulation_->collisions(), std::move(output));
  simulation_->record_to(output_->file(), state);
  state.require_end();
  output_->file().go_on(resolved_toml(values_));
}

void SteppedRun::advance(const Piece& piece, std::vector<CollisionRow>* rows) {
  const CasePrecision here(values_);
  begin(piece, rows);
  while (!is_ending() && !is_piece_done()) {
    const Halt halt = simulation_->go_on(next_stretch());
    if (halt.is_waiting) pause();
    attend_to_the_clock(halt.rounds);
  }
  simulation_->end_piece(is_over());
}

/// Sets where the piece ends, and who gets its rows.
void SteppedRun::begin(const Piece& piece, std::vector<CollisionRow>* rows) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  const std::int64_t done = collisions();
  last_collision_ = piece.collisions < most - done ? done + piece.collisions : most;
  last_time_ = piece.time;
  last_second_ = clock_.seconds() + piece.seconds;
  is_stopped_ = false;
  simulation_->begin_piece(rows);
}

bool SteppedRun::is_piece_done() const { return is_stopped_ || collisions() >= last_collision_; }

/// Sets why the run ends, once it does.
bool SteppedRun::is_ending() {
  if (const auto end = simulation_->what_ends()) ended_by_ = end;
  return is_over();
}

/// Up to where the simulation can go on alone.
Stretch SteppedRun::next_stretch() const {
  Stretch stretch{.collisions = last_collision_,
                  .time = std::min(simulation_->next_pause(), last_time_),
                  .rounds = clock_.rounds_left()};
  if (output_) stretch.collisions = std::min(stretch.collisions, output_->next_collisions());
  return stretch;
}

/// Does what is due at this time without a collision. The end of a piece is only noted: there the
/// clock stays where it is.
void SteppedRun::pause() {
  const double until = simulation_->next_pause();
  if (last_time_ < until) {
    is_stopped_ = true;
    stopped_at_ = std::max(stopped_at_, last_time_);
    return;
  }
  // A longer run does not stop the clock at the end of this one: from here it can go on.
  const bool is_last = until >= simulation_->last_moment();
  if (is_last) keep_the_end();
  if (until >= simulation_->end_of_clock()) {
    ended_by_ = EndedBy::clock;
  } else {
    simulation_->pause_at(until, is_last);
  }
}

/// Now and then shows the progress, and makes sure that a killed run loses little.
void SteppedRun::attend_to_the_clock(int rounds) {
  if (output_ && output_->is_due_after(collisions())) checkpoint_now();
  if (!clock_.is_due(rounds)) return;
  const double seconds = clock_.seconds();
  if (options_.on_progress && clock_.is_report_due(seconds)) options_.on_progress(progress());
  if (output_) output_->look_at(seconds);
  if (output_ && output_->is_due_at(seconds)) checkpoint_now();
  if (seconds >= last_second_) is_stopped_ = true;
}

double SteppedRun::time() const {
  const CasePrecision here(values_);
  return std::max(simulation_->time(), stopped_at_);
}

Summary SteppedRun::summary() const {
  const CasePrecision here(values_);
  return summary_at(stopped_at_);
}

SphereState SteppedRun::state() const {
  const CasePrecision here(values_);
  return simulation_->state(stopped_at_);
}

void SteppedRun::save() {
  const CasePrecision here(values_);
  if (output_ && output_->is_recording()) checkpoint_now();
}

Summary SteppedRun::finish() {
  const CasePrecision here(values_);
  if (!is_over()) ended_by_ = EndedBy::signal;
  keep_the_end();
  simulation_->close(stopped_at_);
  if (simulation_->what_ends() == EndedBy::self_check) ended_by_ = EndedBy::self_check;
  Summary result = summary_at(simulation_->time());
  if (output_) {
    output_->file().finish(result, simulation_->anatomy(), series(), simulation_->samples());
  }
  return result;
}

void SteppedRun::keep_the_end() {
  if (output_ && output_->is_recording()) output_->end(checkpoint());
}

void SteppedRun::checkpoint_now() {
  output_->checkpoint(clock_, [this] { return checkpoint(); });
}

/// The state at the last event, also where the piece has ended later.
Checkpoint SteppedRun::checkpoint() const {
  Checkpoint checkpoint;
  simulation_->add_to(checkpoint);
  checkpoint.wall_seconds = clock_.wall_seconds();
  checkpoint.summary = to_json(summary_at(checkpoint.time), values_.system.dimension);
  checkpoint.series = series();
  checkpoint.samples = simulation_->samples();
  return checkpoint;
}

RecordedSeries SteppedRun::series() const {
  return recorded(simulation_->series(), values_.system.dimension);
}

Summary SteppedRun::summary_at(double time) const {
  Summary summary;
  simulation_->add_to(summary, time);
  summary.species = species_summary(values_, summary.averages);
  summary.ended_by = ended_by_;
  summary.verdict = verdict(course_of(summary));
  summary.outcome = outcome_of(ended_by_);
  summary.wall_seconds = clock_.wall_seconds();
  summary.collisions_per_second = static_cast<double>(summary.collisions) / summary.wall_seconds;
  summary.peak_memory_bytes = peak_memory_bytes();
  return summary;
}

Progress SteppedRun::progress() const {
  const auto part = [](double done, const auto& limit) {
    return limit && *limit > 0 ? done / static_cast<double>(*limit) : 0;
  };
  const std::int64_t collisions = this->collisions();
  const auto done = static_cast<double>(collisions);
  const double time = simulation_->time();
  const double wall_seconds = clock_.wall_seconds();
  return {.collisions = collisions,
          .time = time,
          .collisions_per_second = done / wall_seconds,
          .separation_hits = simulation_->separation_hits(),
          .done = std::max(part(done, values_.run.collisions), part(time, values_.run.time)),
          .wall_seconds = wall_seconds};
}

std::unique_ptr<SteppedRun> start_run(const Case& values, const RunOptions& options) {
  return std::make_unique<SteppedRun>(values, options);
}

std::unique_ptr<SteppedRun> resumed_run(const Case& values, RecoveredOutput output,
                                        const RunOptions& options) {
  return std::make_unique<SteppedRun>(values, std::move(output), options);
}

}  // namespace zenosphere
