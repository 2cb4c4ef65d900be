#include "verify/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "case/case_file.hpp"
#include "case/case_grains.hpp"
#include "collapse/verdict.hpp"
#include "model/errors.hpp"
#include "result/summary.hpp"
#include "storage/integrity.hpp"
#include "storage/run_reader.hpp"
#include "storage/sandboxed_read.hpp"
#include "text/counted.hpp"
#include "verify/arrest_recount.hpp"
#include "verify/log_check.hpp"
#include "verify/snapshot_check.hpp"

namespace zenosphere {
namespace {

using verify::Findings;

void read_everything(const std::filesystem::path& path) {
  const RunReader file(path);
  for (std::int64_t n = 0; n < file.info().snapshots; ++n) file.snapshot(n);
  file.for_each_row([](const CollisionRow&) {});
}

/// One file, looked at from its first collision to its last.
template <int Dim>
class Verifier {
 public:
  /// \param loosest_threshold  of the separation criterion, in the coarsest precision of the run
  Verifier(const RunReader& file, const Case& values, const GapThreshold& loosest_threshold)
      : file_(file),
        values_(values),
        grains_(file.grains()),
        replay_(values, file.info().spheres, file.info().criteria_version, grains_),
        log_(values, file.info().spheres, file.info().last_time, loosest_threshold.nearest_double(),
             grains_),
        snapshots_(values, file.info().last_time, grains_),
        arrest_(values, file.info().criteria_version),
        was_raised_(values.collapse.gap_threshold < loosest_threshold) {}

  Verification go() {
    read_snapshot();
    file_.for_each_row([&](const CollisionRow& row) { observe(row); });
    while (next_snapshot_) observe_snapshot();
    if (file_.info().has_ended()) compare_summary();
    result_.collisions = file_.info().logged_collisions;
    result_.coverage = replay_.coverage();
    add_notes();
    return std::move(result_);
  }

 private:
  void read_snapshot() {
    next_snapshot_.reset();
    if (read_ < file_.info().snapshots) next_snapshot_ = file_.snapshot(read_++);
  }

  void observe_snapshot() {
    // What the log has lost up to here is known only where it holds every collision up to here.
    const bool is_known = log_.collisions() == next_snapshot_->step;
    const auto lost = is_known ? log_.take_dissipated() : std::nullopt;
    if (snapshots_.observe(*next_snapshot_, lost, result_.findings)) {
      replay_.observe(*next_snapshot_, result_.findings);
    }
    read_snapshot();
  }

  void observe(const CollisionRow& row) {
    while (next_snapshot_ && next_snapshot_->step < row.k) observe_snapshot();
    const bool is_usable = log_.observe(row, result_.findings);
    arrest_.observe(row, last_gap_);
    last_gap_ = row.gap;
    if (is_usable) replay_.observe(row, result_.findings);
  }

  void compare_summary() {
    const Summary summary = summary_from_json(*file_.info().summary, Dim);
    Findings& findings = result_.findings;
    snapshots_.compare(summary, findings);
    const Course course = course_of(summary);
    const bool is_old = file_.info().criteria_version < 2;
    const Verdict expected = is_old ? verdict_by_window(course) : verdict(course);
    if (summary.verdict != expected) {
      findings.add(fmt::format("summary: verdict = {} (its counts mean {})", word(summary.verdict),
                               word(expected)));
    }
    if (!file_.info().log_complete) return;
    log_.compare(summary, findings);
    if (!was_raised_) arrest_.compare(summary, findings);
  }

  void add_notes() {
    const OutputInfo& info = file_.info();
    auto& notes = result_.notes;
    if (!info.has_ended()) {
      notes.emplace_back(
          "the run is not finished: looked at up to its last checkpoint, where there is no summary "
          "to check (zenosphere resume ends the run)");
    }
    if (info.has_ended() && !info.log_complete) {
      notes.emplace_back(
          "the log does not hold every collision: hits, arrest and counts of the "
          "summary were not counted again");
    }
    if (info.has_ended() && info.log_complete) {
      notes.emplace_back(
          fmt::format("hits, {}verdict and counts of the summary counted again from the "
                      "log",
                      was_raised_ ? "" : "arrest, "));
    }
    if (was_raised_) {
      notes.emplace_back(
          "the precision is higher than in the case file: hits may follow the threshold of either, "
          "and the arrest was not counted again");
    }
    if (values_.collision.rotation_angle > 0) {
      notes.emplace_back(
          "random rotation (collision.rotation_angle): the angles are not in the file, so that a "
          "sphere is followed from a snapshot to its first collision only");
    }
    if (snapshots_.balances() > 0) {
      notes.emplace_back(fmt::format("energy balanced between {} of snapshots",
                                     counted(snapshots_.balances(), "pair")));
    }
    if (values_.drive.kind == DriveKind::random) {
      notes.emplace_back("kicks are not in the file; they were made again from the seed");
    }
  }

  const RunReader& file_;
  const Case& values_;
  Grains<double> grains_;
  verify::Replay<Dim> replay_;
  verify::LogCheck log_;
  verify::SnapshotCheck snapshots_;
  verify::ArrestRecount arrest_;
  bool was_raised_;
  std::optional<Snapshot> next_snapshot_;
  std::int64_t read_ = 0;
  double last_gap_ = std::numeric_limits<double>::quiet_NaN();
  Verification result_;
};

/// Throws where the case of a file is not that of its data, or asks for more than can be done.
void require_fitting(const std::filesystem::path& path, const OutputInfo& info,
                     const Case& values) {
  if (values.system.spheres != info.spheres || values.system.dimension != info.dimension) {
    throw InputError(fmt::format("{}: has {} in {} (its case has {} in {}); it is damaged",
                                 path.string(), counted(info.spheres, "sphere"),
                                 counted(info.dimension, "dimension"), values.system.spheres,
                                 values.system.dimension));
  }
  // Some hours; no run has made as many.
  constexpr double most_kicks = 1e12;
  const double kicks =
      values.drive.kind == DriveKind::random ? info.last_time / values.drive.kick_interval : 0.0;
  if (std::isfinite(info.last_time) && kicks * static_cast<double>(info.spheres) <= most_kicks) {
    return;
  }
  throw InputError(
      fmt::format("{}: ends at time {} (that is {:.3g} kicks of {}, too many to make again)",
                  path.string(), info.last_time, kicks, counted(info.spheres, "sphere")));
}

/// Throws where spheres are of a kind for which the case has no constants of contact.
void require_known_kinds(const std::filesystem::path& path, const Grains<double>& grains,
                         const Case& values) {
  const auto table = contact_table_of<double>(values);
  if (!table || grains.kind_count() <= table->kinds()) return;
  throw InputError(fmt::format("{}: has spheres of {} (its case has {}); it is damaged",
                               path.string(), counted(grains.kind_count(), "kind"),
                               table->kinds()));
}

/// The precision that a run began with, as far as its case file tells: `resume` can raise it.
Precision first_precision(const OutputInfo& info, const Case& values) {
  try {
    const Case begun = parse_case(info.case_text, "case", {});
    return std::min(begun.collision.precision, values.collision.precision);
  } catch (const InputError&) {  // it was completed by overrides
    return values.collision.precision;
  }
}

template <int Dim>
Verification verification_of(const RunReader& file, Case values) {
  GapThreshold loosest_threshold = values.collapse.gap_threshold;
  const Precision first = first_precision(file.info(), values);
  if (loosest_threshold == GapThreshold(values.collision.precision)) {
    loosest_threshold = GapThreshold(first);
  }
  values.collision.precision = first;  // its rounding is in the state to the end
  return Verifier<Dim>(file, values, loosest_threshold).go();
}

Verification verification_of(const RunReader& file, const Case& values) {
  switch (file.info().dimension) {
    case 1:
      return verification_of<1>(file, values);
    case 2:
      return verification_of<2>(file, values);
    default:
      return verification_of<3>(file, values);
  }
}

}  // namespace

Verification verify_file(const std::filesystem::path& path) {
  const Integrity integrity = checked_integrity(path);
  sandboxed_read(path, bytes_of_run(path), [&] { read_everything(path); });
  const RunReader file(path);
  const Case values = parse_case(file.info().resolved_case, path.string() + ", its case", {});
  require_fitting(path, file.info(), values);
  require_known_kinds(path, file.grains(), values);
  Verification result = verification_of(file, values);
  result.notes.push_back("checksums " + sentence(integrity));
  return result;
}

std::string to_text(const Verification& verification, const std::string& file) {
  std::string text;
  for (const auto& finding : verification.findings.texts()) {
    text += fmt::format("{}: {}\n", file, finding);
  }
  const std::int64_t found = verification.findings.count();
  const auto kept = static_cast<std::int64_t>(verification.findings.texts().size());
  if (found > kept) text += fmt::format("{}: and {} more\n", file, found - kept);
  const verify::Coverage& coverage = verification.coverage;
  text += found == 0 ? "No contradiction found.\n\n" : "The file contradicts itself.\n\n";
  text += fmt::format("  logged collisions       {}\n", verification.collisions);
  text +=
      fmt::format("  replayed                {} (to 1e-9 diameters {}, to 1e-6 {}, to 1e-3 all)\n",
                  coverage.replayed, coverage.within[0], coverage.within[1]);
  text += fmt::format("  beyond predictability   {}\n", coverage.beyond);
  text += fmt::format("  not reachable           {}\n", coverage.unreached);
  text +=
      fmt::format("  snapshots compared      {} ({}, {} more beyond predictability)\n",
                  coverage.snapshots, counted(coverage.spheres, "sphere"), coverage.lost_spheres);
  for (const std::string& note : verification.notes) text += fmt::format("  {}\n", note);
  return text;
}

}  // namespace zenosphere
