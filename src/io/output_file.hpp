#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/summary.hpp"

namespace zenosphere {

/// The format that `OutputFile` writes; docs/file-format.md tells it.
inline constexpr std::int64_t output_format_version = 1;

/// The whole system at one time, in laboratory coordinates and row-major.
struct Snapshot {
  std::int64_t step = 0;  ///< collisions done
  double time = 0;
  std::vector<double> positions;   ///< N x D, diameters, every component in [0, L)
  std::vector<double> velocities;  ///< N x D, diameters/time
  std::vector<double> box_edges;   ///< D x D, diameters; the rows are the box vectors
};

/// One line of the collision log.
struct CollisionRow {
  std::int64_t k = 0;  ///< number of the collision, from 1
  double time = 0;
  std::int32_t i = 0, j = 0;  ///< the two spheres, i < j, from 0
  double gap = 0;             ///< of the pair that collides next, diameters
  double normal_speed = 0;    ///< diameters/time
  std::uint8_t flags = 0;     ///< sum of collision_flag values
};

namespace collision_flag {
inline constexpr std::uint8_t hit = 1;           ///< gap at or below the threshold
inline constexpr std::uint8_t overlap = 2;       ///< overlapped while approaching
inline constexpr std::uint8_t absorbed = 4;      ///< changed no bit of a velocity
inline constexpr std::uint8_t receding = 8;      ///< receding by rounding: no impulse
inline constexpr std::uint8_t clock_stood = 16;  ///< the clock did not move forward
}  // namespace collision_flag

/// The output of one run, in HDF5 after H5MD 1.1.
///
/// The file has its final name as soon as the object exists, and says `complete` = 0 until
/// `finish`. Each function throws `OutputError` with the name of the file and the system's reason;
/// after that the object is good only for being destroyed. Destroying it unfinished writes what is
/// buffered and closes the file, silently; it stays readable and incomplete.
class OutputFile {
 public:
  struct Header {
    std::string case_text;      ///< the case file as it was read
    std::string resolved_case;  ///< TOML, every key with the value used
    int dimension = 0;
    std::int64_t spheres = 0;
    std::vector<std::string> boundary{};  ///< D words, "periodic" or "none"; empty: periodic
  };
  enum class Existing { refuse, replace };

  /// Throws the OutputError that the constructor would, where it can be known without creating the
  /// file: before hours are spent on what cannot be kept.
  static void check_target(const std::filesystem::path& path, Existing existing);

  /// Creates the file. Where that fails, nothing new is left behind and an old file is untouched.
  ///
  /// \param existing  `replace` puts the new file in the place of an old one in one step, at the
  ///                  end of this constructor: construct this last, once the run can start
  OutputFile(const std::filesystem::path& path, const Header& header, Existing existing);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Appends a snapshot of the N spheres in D dimensions that the header tells.
  void write(const Snapshot& snapshot);

  /// Appends a row to the collision log, in buffers of 65536 rows (2.7 MB).
  void append(const CollisionRow& row);

  /// Hands everything so far to the system: other processes can read it while the run goes on, and
  /// it outlives this one.
  void flush();

  /// Writes the summary and the marks of completeness, and closes. The last call.
  void finish(const Summary& summary);

 private:
  struct Contents;  // the HDF5 side; absent once closed

  template <class Action>
  void guarded(Action action);

  std::filesystem::path path_;
  int dimension_;
  std::int64_t spheres_;
  std::unique_ptr<Contents> contents_;
};

}  // namespace zenosphere
