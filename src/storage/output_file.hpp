#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "result/summary.hpp"
#include "storage/atomic_file.hpp"
#include "storage/journal.hpp"
#include "storage/output_datasets.hpp"
#include "storage/records.hpp"
#include "storage/recovery.hpp"

namespace zenosphere {

/// The output of one run that goes on: an HDF5 file after H5MD 1.1, and a journal beside it.
///
/// The HDF5 file is complete and consistent at every moment; it is only ever replaced as a whole,
/// in one step. What comes later goes to the next HDF5 file, `OUT.h5.part`, until the first
/// checkpoint, and then to the journal, which is folded into a new HDF5 file when it has outgrown
/// the old one. docs/decisions/0006-checkpoints-and-journal.md tells why.
///
/// Each function throws `OutputError` with the name of the file, the system's reason, what is kept
/// and how to go on; after that the object is good only for being destroyed. Destroying it
/// unfinished drops what came after the last checkpoint, as a crash does.
class OutputFile {
 public:
  using Header = OutputHeader;

  /// Makes the output of a new run and locks it; it gets its name with `begin`.
  ///
  /// \param existing  `replace` puts the new file in the place of an old one in one step, at
  ///                  `begin`; before that an old file is untouched
  OutputFile(const std::filesystem::path& path, const Header& header, Existing existing);
  /// Takes over the output of a run that is to go on; nothing is written before `go_on`.
  explicit OutputFile(RecoveredOutput recovered);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Appends a snapshot of the N spheres in D dimensions that the header tells.
  void write(const Snapshot& snapshot);

  /// Appends a row to the collision log, in buffers of `log_buffer` rows.
  void append(const CollisionRow& row) {
    buffer_.append(row);
    ++log_rows_;
    if (buffer_.size() >= log_buffer) flush_buffer();
  }

  /// Gives a new output its name, with the checkpoint of the start in it.
  void begin(Checkpoint checkpoint);

  /// Goes on with a recovered output behind its last checkpoint.
  ///
  /// \param resolved_case  of the run from now on
  void go_on(const std::string& resolved_case);

  /// Makes sure that the run can go on from here, whatever happens: all is on the disk when this
  /// returns.
  ///
  /// \param checkpoint  its counts of rows and snapshots are filled in here
  void checkpoint(Checkpoint checkpoint);

  /// Folds the journal into the HDF5 file if it has outgrown it. To be called after `checkpoint`.
  void fold_if_due();

  /// The checkpoint from which a finished run can be extended: what is written after this call
  /// belongs to the end of the run.
  void end(Checkpoint checkpoint);

  /// Writes summary, anatomy, the checkpoint of `end` and the marks of completeness: one file is
  /// left.
  ///
  /// \param anatomy  what was found in a collapse, if there was one
  /// \param series   averages over the intervals of the whole run
  /// \param samples  what it has accumulated of its structure
  void finish(const Summary& summary, const Anatomy& anatomy = {},
              const RecordedSeries& series = {}, const RecordedSamples& samples = {});

  /// Throws where the files of this output are no longer under their names: what is written then is
  /// lost to every reader.
  void require_in_place() const;

 private:
  /// So many that a write costs little a row: 168 KB.
  static constexpr std::size_t log_buffer = 4096;

  template <class Action>
  void guarded(Action action);
  void flush_buffer();
  void flush_rows();
  void keep_in_mind(Checkpoint checkpoint);
  Checkpoint counted(Checkpoint checkpoint) const;
  Checkpoint fold();
  void replay(const Bytes& payload, RecordKind kind);
  void close_part();
  void publish();
  std::string what_is_kept() const;

  std::filesystem::path path_;    ///< as the user calls it
  std::filesystem::path target_;  ///< without symbolic links
  std::filesystem::path part_path_;
  Existing existing_;
  Journal journal_;
  std::unique_ptr<OutputDatasets> part_;  ///< where new data goes as long as the journal is empty
  std::optional<FileIdentity> published_{};  ///< of the HDF5 file under its name
  std::string resolved_case_{};              ///< of a recovered run
  Basis basis_{};                            ///< of the journal
  Checkpoint last_{};                        ///< the last one that is safe; without its state
  Checkpoint ending_{};                      ///< as long as there is no journal to hold it
  CollisionRows buffer_{};
  std::int64_t log_rows_ = 0;
  std::int64_t snapshots_ = 0;
};

}  // namespace zenosphere
