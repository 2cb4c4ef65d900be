#include "export/export_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "case/case_box.hpp"
#include "case/case_file.hpp"
#include "case/case_grains.hpp"
#include "export/sphere_collisions.hpp"
#include "export/tables.hpp"
#include "export/vtk_frame.hpp"
#include "model/errors.hpp"
#include "storage/new_file.hpp"
#include "storage/run_reader.hpp"
#include "storage/sandboxed_read.hpp"
#include "storage/text_target.hpp"
#include "text/counted.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

/// Reads once all that will be read.
void read_everything(const Export& request) {
  const RunReader run(request.run);
  const Exports content = request.format->content;
  if (content == Exports::series) return void(run.series());
  if (content != Exports::collisions) {
    const auto numbers = selected_snapshots(request.selection, run.snapshots(), request.run);
    for (std::int64_t n = numbers.first; n <= numbers.last; n += numbers.step) run.snapshot(n);
  }
  if (content != Exports::collisions && !request.format->shows_spheres) return;
  run.for_each_row([](const CollisionRow&) {});
}

/// The case of a run, if it is that of its data.
Case case_of(const RunReader& run, const fs::path& path) {
  Case values = parse_case(run.info().resolved_case, path.string() + ", its case", {});
  const OutputInfo& info = run.info();
  if (values.system.spheres == info.spheres && values.system.dimension == info.dimension) {
    return values;
  }
  throw InputError(fmt::format("{}: has {} in {} (its case has {} in {}); it is damaged",
                               path.string(), counted(info.spheres, "sphere"),
                               counted(info.dimension, "dimension"), values.system.spheres,
                               values.system.dimension));
}

/// Throws where a viewer could not place a sphere.
void require_numbers(const Snapshot& snapshot, int dimension, const fs::path& path) {
  for (std::size_t at = 0; at < snapshot.positions.size(); ++at) {
    if (std::isfinite(snapshot.positions[at]) && std::isfinite(snapshot.velocities[at])) continue;
    throw InputError(fmt::format(
        "{}: sphere {} is at {} with velocity {} at collision {} (no numbers to show); zenosphere "
        "verify {} tells more",
        path.string(), at / static_cast<std::size_t>(dimension), snapshot.positions[at],
        snapshot.velocities[at], snapshot.step, path.string()));
  }
}

/// Where the frames of a collection go: beside it.
fs::path folder_of_frames(const fs::path& collection) {
  fs::path folder = collection;
  folder.replace_extension();
  folder += "-frames";
  return folder;
}

class Exporter {
 public:
  explicit Exporter(const Export& request)
      : request_(request),
        run_(request.run),
        values_(case_of(run_, request.run)),
        grains_(grains_of(values_)) {
    for (const Species& species : values_.species) species_.push_back(species.name);
    exported_.spheres = run_.info().spheres;
    exported_.complete = run_.info().has_ended();
  }

  Exported go() {
    switch (request_.format->content) {
      case Exports::frames:
        write_frames();
        break;
      case Exports::collection_of_frames:
        write_collection();
        break;
      case Exports::collisions:
        write_collisions();
        break;
      case Exports::series:
        write_series();
        break;
    }
    return exported_;
  }

 private:
  bool is_interrupted() {
    exported_.interrupted = request_.interrupt != nullptr && *request_.interrupt;
    return exported_.interrupted;
  }

  Frame frame(std::int64_t n) {
    Frame frame{.number = n, .dimension = values_.system.dimension, .snapshot = run_.snapshot(n)};
    frame.grains = &grains_;
    frame.species = species_;
    frame.reduced_inertia = reduced_moment_of_inertia(values_);
    frame.shear_rate = values_.drive.shear_rate;
    require_numbers(frame.snapshot, frame.dimension, request_.run);
    frame.cell = cell_of(frame.snapshot, frame.dimension, closed_axis(values_), request_.run);
    if (exported_.collisions_are_counted) frame.collisions = counts_->up_to(frame.snapshot.step);
    return frame;
  }

  /// Calls `action(frame)` for the frames that are selected. Returns whether it came to the end.
  template <class Action>
  bool for_each_frame(Action action) {
    const Numbers numbers = selected_snapshots(request_.selection, run_.snapshots(), request_.run);
    const std::int64_t last = numbers.last - (numbers.last - numbers.first) % numbers.step;
    if (request_.format->shows_spheres) counts_.emplace(run_, request_.run);
    exported_.collisions_are_counted = counts_ && counts_->reaches(run_.snapshot(last).step);
    for (std::int64_t n = numbers.first; n <= last; n += numbers.step) {
      if (is_interrupted()) return false;
      action(frame(n));
      ++exported_.written;
    }
    return true;
  }

  /// Calls `action(row)` for the collisions that are selected, likewise.
  template <class Action>
  bool for_each_collision(Action action) {
    const Numbers numbers = selected_collisions(request_.selection, request_.run);
    for (std::int64_t n = 0; n < run_.log_pieces(); ++n) {
      if (is_interrupted()) return false;
      for (const CollisionRow& row : run_.log_piece(n)) {
        if (!numbers.contain(row.k)) continue;
        action(row);
        ++exported_.written;
      }
    }
    return true;
  }

  /// All frames in one file.
  void write_frames() {
    const ExportFormat& format = *request_.format;
    TextTarget target(request_.target, request_.existing);
    if (format.header) {
      target.file().write(format.header(values_.system.dimension, is_rough(values_)));
    }
    const bool is_whole =
        for_each_frame([&](const Frame& frame) { format.append(target.file(), frame); });
    if (is_whole) target.finish();
  }

  void write_collisions() {
    TextTarget target(request_.target, request_.existing);
    NewFile& file = target.file();
    file.write(collisions_header());
    if (!for_each_collision([&](const CollisionRow& row) { file.write(collisions_row(row)); })) {
      return;
    }
    if (exported_.written == 0) {
      throw InputError(
          fmt::format("{}: its log holds no collision that is selected (it has {}); "
                      "choose others, or run with output.collision_log = \"all\"",
                      request_.run.string(), run_.info().logged_collisions));
    }
    target.finish();
  }

  /// The time series of the run, as a whole: it has some thousand rows at most.
  void write_series() {
    const RecordedSeries series = run_.series();
    if (series.time.empty()) {
      throw InputError(fmt::format(
          "{}: holds no time series (its run was too short, or an older program wrote it); "
          "csv-observables takes what the snapshots tell",
          request_.run.string()));
    }
    TextTarget target(request_.target, request_.existing);
    target.file().write(series_header(series));
    for (std::size_t row = 0; row < series.time.size(); ++row) {
      target.file().write(series_row(series, row));
      ++exported_.written;
    }
    target.finish();
  }

  /// A file for each frame in a folder, and the collection that tells their times.
  void write_collection() {
    AtomicFile list(request_.target, request_.existing);
    const fs::path folder = folder_of_frames(request_.target);
    AtomicFile frames(folder, request_.existing, folder_of_vtk_frames());
    std::vector<TimedFile> files;
    const bool is_whole = for_each_frame([&](const Frame& frame) {
      const fs::path name = vtk_frame_name(frame.number);
      NewFile file(frames.path() / name, folder / name);
      write_vtk_frame(file, frame);
      file.close();
      files.push_back({frame.snapshot.time, folder.filename() / name});
    });
    if (!is_whole) return;
    NewFile collection(list.path(), request_.target);
    collection.write(vtk_collection(files));
    collection.close();
    frames.put_in_place();
    list.put_in_place();
  }

  const Export& request_;
  RunReader run_;
  Case values_;
  Grains<double> grains_;
  std::vector<std::string> species_;
  std::optional<SphereCollisions> counts_;  ///< where the format shows them
  Exported exported_;
};

/// Throws where the target is what is read, or has a name that says something else.
void require_fitting_target(const Export& request) {
  const auto identity = identity_of(request.target);
  if (identity &&
      (identity == identity_of(request.run) || identity == identity_of(journal_of(request.run)))) {
    throw OutputError(request.target.string() + ": is the run itself; choose another name");
  }
  if (request.format->content != Exports::collection_of_frames ||
      request.target.extension() == ".pvd")
    return;
  throw InputError(fmt::format(
      "{}: has not the name of a collection (format vtp writes NAME.pvd, and a file for each "
      "snapshot in NAME-frames); choose one that ends in .pvd",
      request.target.string()));
}

}  // namespace

Exported export_run(const Export& request) {
  require_fitting_target(request);
  sandboxed_read(request.run, bytes_of_run(request.run), [&] { read_everything(request); });
  return Exporter(request).go();
}

std::string to_text(const Exported& exported, const Export& request) {
  const bool is_stream = is_standard_output(request.target);
  if (exported.interrupted) {
    return request.target.string() + (is_stream ? ": interrupted, what was written is cut off\n"
                                                : ": interrupted, nothing was written\n");
  }
  const bool has_rows = request.format->content == Exports::collisions;
  const bool has_series = request.format->content == Exports::series;
  std::string text = fmt::format("{}: {} of {}\n", request.target.string(),
                                 counted(exported.written, has_series ? "interval"
                                                           : has_rows ? "collision"
                                                                      : "snapshot"),
                                 counted(exported.spheres, "sphere"));
  if (!exported.complete) text += "  the run has not ended: up to its last checkpoint\n";
  if (request.format->shows_spheres && !exported.collisions_are_counted) {
    text +=
        "  without the collisions of each sphere: the log does not hold all of them from the "
        "first on\n";
  }
  return text;
}

}  // namespace zenosphere
