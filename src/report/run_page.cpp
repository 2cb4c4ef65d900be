#include "report/run_page.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "case/case_file.hpp"
#include "case/case_grains.hpp"
#include "report/frames.hpp"
#include "report/frequent_pairs.hpp"
#include "report/log_digest.hpp"
#include "report/run_json.hpp"
#include "result/summary.hpp"
#include "storage/run_reader.hpp"
#include "storage/sandboxed_read.hpp"

namespace zenosphere {
namespace {

constexpr std::int64_t most_frame_bytes = 8'000'000;
constexpr std::int64_t most_spheres = 1'000'000;  // two snapshots of so many take 40 MB

/// Collisions worth a closer look where the log is too long to be kept.
std::vector<std::int64_t> remarkable_collisions(const OutputInfo& info) {
  std::vector<std::int64_t> collisions;
  if (info.logged_collisions <= LogDigest::most_rows) return collisions;
  std::string text = info.summary.value_or("");
  if (text.empty() && info.checkpoint) text = info.checkpoint->summary;
  if (text.empty()) return collisions;
  const Summary summary = summary_from_json(text, info.dimension);
  const auto& hits = summary.separation;
  for (const auto& k : {hits.first_collision, summary.arrest.collision, hits.last_collision}) {
    if (k) collisions.push_back(*k);
  }
  return collisions;
}

/// The pairs that get a row of their own where the log is too long to be kept.
std::vector<PairCount> pairs_of_raster(const RunReader& file) {
  if (file.info().logged_collisions <= LogDigest::most_rows) return {};
  FrequentPairs pairs;
  file.for_each_row([&](const CollisionRow& row) { pairs.observe(row); });
  return pairs.most_frequent(PairRaster::most_pairs);
}

/// What a page shows of one file; a log that is too long to be kept is read twice.
class RunDigest {
 public:
  /// \param pairs  that get a row of the raster
  RunDigest(const RunReader& file, const Case& values, std::vector<PairCount> pairs)
      : file_(file),
        log_(file.info().logged_collisions),
        frames_(file.info().spheres, file.info().dimension, grains_of(values),
                values.drive.kind == DriveKind::shear ? values.drive.shear_rate : 0.0,
                shown_snapshots(file.info())),
        raster_(std::move(pairs), log_.stretch().width) {
    for (const auto k : remarkable_collisions(file.info())) close_ups_.emplace_back(k);
  }

  void read() {
    file_.for_each_row([this](const CollisionRow& row) {
      while (!are_all_read() && next_step() < row.k) read_snapshot();
      observe(row);
    });
    while (!are_all_read()) read_snapshot();
  }

  Frames frames() && { return std::move(frames_).result(file_.info().log_complete); }

  const PairRaster& raster() const { return raster_; }

  std::vector<const LogStretch*> stretches() const {
    std::vector<const LogStretch*> found{&log_.stretch()};
    for (const auto& close_up : close_ups_) found.push_back(&close_up.stretch());
    return found;
  }

 private:
  static std::vector<std::int64_t> shown_snapshots(const OutputInfo& info) {
    if (info.spheres > most_spheres) return {};
    constexpr std::int64_t bytes = 3 * sizeof(float) + sizeof(float) + sizeof(std::int32_t);
    return spread_snapshots(info.snapshots, most_frame_bytes / (info.spheres * bytes));
  }

  bool are_all_read() const { return read_ == file_.info().snapshots; }

  std::int64_t next_step() {
    if (!next_) next_ = file_.snapshot(read_);
    return next_->step;
  }

  void read_snapshot() {
    next_step();
    frames_.observe(*next_);
    next_.reset();
    ++read_;
  }

  void observe(const CollisionRow& row) {
    log_.observe(row);
    for (auto& close_up : close_ups_) close_up.observe(row);
    frames_.observe(row);
    if (log_.stretch().width > 1) raster_.observe(row);
  }

  const RunReader& file_;
  LogDigest log_;
  std::vector<CloseUp> close_ups_;
  FrameCollector frames_;
  PairRaster raster_;
  std::optional<Snapshot> next_;
  std::int64_t read_ = 0;
};

Case case_of(const std::filesystem::path& path, const OutputInfo& info) {
  return parse_case(info.resolved_case, path.string() + ", its case", {});
}

/// Whatever a page needs, once: for the sandbox.
void read_everything(const std::filesystem::path& path) {
  const RunReader file(path);
  file.anatomy();
  file.series();
  file.samples();
  RunDigest(file, case_of(path, file.info()), {}).read();
}

void add_stretch(PageWriter& page, const std::string& name, const LogStretch& stretch) {
  page.add_column(name + ".k", stretch.k);
  page.add_column(name + ".time", stretch.time);
  page.add_column(name + ".gap_low", stretch.gap_low);
  page.add_column(name + ".speed_low", stretch.speed_low);
  page.add_column(name + ".flags", stretch.flags);
  if (stretch.width == 1) {
    page.add_column(name + ".i", stretch.i);
    page.add_column(name + ".j", stretch.j);
  } else {
    page.add_column(name + ".gap_high", stretch.gap_high);
    page.add_column(name + ".speed_high", stretch.speed_high);
    page.add_column(name + ".flight_low", stretch.flight_low);
    page.add_column(name + ".flight_high", stretch.flight_high);
    page.add_column(name + ".hits", stretch.hits);
  }
}

}  // namespace

void write_run_page(const std::filesystem::path& output, const std::filesystem::path& page,
                    Existing existing) {
  sandboxed_read(output, bytes_of_run(output), [&] { read_everything(output); });
  const RunReader file(output);
  const Case values = case_of(output, file.info());
  PageWriter writer(page, existing);
  RunDigest digest(file, values, pairs_of_raster(file));
  digest.read();
  std::vector<StretchName> names;
  for (const auto* stretch : digest.stretches()) {
    if (stretch->bins() == 0) continue;
    names.push_back(
        {"log" + std::to_string(names.size()), stretch->width, stretch->bins(), stretch->last});
    add_stretch(writer, names.back().name, *stretch);
  }
  if (!digest.raster().bins().empty()) writer.add_column("log0.pairs", digest.raster().bins());
  const std::vector<PairCount> pairs = digest.raster().pairs();
  const Frames frames = std::move(digest).frames();
  writer.add_column("frames.positions", frames.positions);
  writer.add_column("frames.speeds", frames.speeds);
  writer.add_column("frames.collisions", frames.collisions);
  writer.add_json("run", run_json(output.filename().string(), file, values, frames, names, pairs));
  writer.finish();
}

}  // namespace zenosphere
