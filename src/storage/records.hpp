#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/archive.hpp"

namespace zenosphere {

/// The whole system at one time, in laboratory coordinates and row-major.
struct Snapshot {
  std::int64_t step = 0;  ///< collisions done
  double time = 0;
  std::vector<double> positions{};   ///< N x D, diameters, every component in [0, L)
  std::vector<double> velocities{};  ///< N x D, diameters/time
  std::vector<double> box_edges{};   ///< D x D, diameters; the rows are the box vectors
  /// N x D: through how many boxes a sphere has come since the start, along the box vectors; empty
  /// where that is not known.
  std::vector<std::int32_t> images{};
  /// Angular velocities, radians/time: N x 3, in two dimensions N; empty where nothing turns.
  std::vector<double> angular_velocities{};

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.step, self.time, self.positions, self.velocities, self.box_edges, self.images,
            self.angular_velocities);
  }
};

/// One line of the collision log.
struct CollisionRow {
  std::int64_t k = 0;  ///< number of the collision, from 1
  double time = 0;
  std::int32_t i = 0, j = 0;  ///< the two spheres, i < j, from 0
  double gap = 0;             ///< of the pair that collides next, diameters
  double normal_speed = 0;    ///< diameters/time
  std::uint8_t flags = 0;     ///< sum of collision_flag values

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive);
};

namespace collision_flag {
inline constexpr std::uint8_t hit = 1;            ///< gap at or below the threshold
inline constexpr std::uint8_t overlap = 2;        ///< overlapped while approaching
inline constexpr std::uint8_t absorbed = 4;       ///< changed no bit of a velocity
inline constexpr std::uint8_t receding = 8;       ///< receding by rounding: no impulse
inline constexpr std::uint8_t clock_stood = 16;   ///< the clock did not move forward
inline constexpr std::uint8_t made_elastic = 32;  ///< by the TC model
inline constexpr std::uint8_t sliding = 64;       ///< of rough surfaces: friction was at its limit
inline constexpr std::uint8_t resting = 128;      ///< of a sphere that rests on an oscillating wall
}  // namespace collision_flag

/// Of the columns of the log: to be raised whenever they change. The versions of the journal, which
/// holds rows, and of a checkpoint, in which an unfinished row waits, rise with it.
inline constexpr std::uint32_t log_version = 1;

/// Rows of the collision log, column by column as they are stored.
struct CollisionRows {
  std::vector<std::int64_t> k{};
  std::vector<double> time{};
  std::vector<std::int32_t> i{}, j{};
  std::vector<double> gap{}, normal_speed{};
  std::vector<std::uint8_t> flags{};

  /// Calls `visit(name, column, part)` for each column, `part` being the member of CollisionRow
  /// that it holds: the one list from which the journal, checkpoints, the datasets, their readers,
  /// tables and the arrays of the Python module come.
  template <class Self, class Visitor>
  static void fields(Self&& self, Visitor&& visit) {
    visit("k", self.k, &CollisionRow::k);
    visit("time", self.time, &CollisionRow::time);
    visit("i", self.i, &CollisionRow::i);
    visit("j", self.j, &CollisionRow::j);
    visit("gap", self.gap, &CollisionRow::gap);
    visit("normal_speed", self.normal_speed, &CollisionRow::normal_speed);
    visit("flags", self.flags, &CollisionRow::flags);
  }

  std::size_t size() const { return k.size(); }
  void append(const CollisionRow& row) {
    fields(*this, [&](const char*, auto& column, auto part) { column.push_back(row.*part); });
  }
  CollisionRow row(std::size_t n) const {
    CollisionRow row;
    fields(*this, [&](const char*, const auto& column, auto part) { row.*part = column[n]; });
    return row;
  }
  void reserve(std::size_t rows);
  void clear();

  /// \throws ArchiveError where the columns differ in length
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    fields(self, [&](const char*, auto& column, auto) { archive(column); });
    fields(self, [&](const char*, const auto& column, auto) {
      require_archived(column.size() == self.size(), "columns of different lengths");
    });
  }
};

template <class Self, class Archive>
void CollisionRow::archive_state(Self& self, Archive& archive) {
  CollisionRows::fields(CollisionRows(),
                        [&](const char*, const auto&, auto part) { archive(self.*part); });
}

/// The time series of a run: averages over successive intervals of equal length, from time 0 on.
struct RecordedSeries {
  struct Column {
    std::string name;
    std::vector<std::int64_t> shape{};  ///< of a row; empty: a number
    std::vector<double> values{};       ///< row after row

    std::size_t numbers_a_row() const {
      std::size_t count = 1;
      for (const std::int64_t extent : shape) count *= static_cast<std::size_t>(extent);
      return count;
    }

    template <class Self, class Archive>
    static void archive_state(Self& self, Archive& archive) {
      archive(self.name, self.shape, self.values);
    }
  };
  std::vector<std::int64_t> step{};  ///< collisions at the end of each interval
  std::vector<double> time{};        ///< of its end
  std::vector<Column> columns{};

  /// \throws ArchiveError where columns differ in length
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.step, self.time, self.columns);
    for (const Column& column : self.columns) {
      for (const std::int64_t extent : column.shape) {
        require_archived(extent > 0 && extent < 1 << 20, "a row of no such size");
      }
      const bool is_full = column.values.size() == self.time.size() * column.numbers_a_row();
      require_archived(is_full && self.step.size() == self.time.size(),
                       "columns of different lengths");
    }
  }
};

/// What a run has accumulated of its structure: sums over successive rows of samples.
struct RecordedSamples {
  RecordedSeries sums{};                        ///< row by row; step and time of the last sample
  std::vector<RecordedSeries::Column> edges{};  ///< of the bins of what is counted in bins

  /// \throws ArchiveError where columns differ in length
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.sums, self.edges);
  }
};

/// How far a run has come, and everything that is needed to go on from there.
struct Checkpoint {
  std::int64_t collisions = 0;
  double time = 0;
  double clock_units = 0;      ///< the same time as the clock has it: whole units,
  double clock_remainder = 0;  ///< and the rest, whose resolution does not depend on the length
  std::int64_t log_rows = 0;   ///< rows of the collision log up to here
  std::int64_t snapshots = 0;  ///< likewise
  double wall_seconds = 0;     ///< that the run has taken so far
  std::string summary{};       ///< JSON, of the run so far
  RecordedSeries series{};     ///< likewise
  RecordedSamples samples{};   ///< likewise
  Bytes state{};               ///< of the run and all that observes it; begins with its version

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.collisions, self.time, self.clock_units, self.clock_remainder, self.log_rows,
            self.snapshots, self.wall_seconds, self.summary, self.series, self.samples, self.state);
  }
};

/// The checkpoint that a journal goes on from: the one in the output file, told by its content.
///
/// A journal whose basis is another one is void: all it holds is in the output file already.
struct Basis {
  std::int64_t collisions = 0;
  std::int64_t log_rows = 0;
  std::int64_t snapshots = 0;
  std::uint64_t state_size = 0;
  std::uint32_t state_checksum = 0;

  static Basis of(const Checkpoint& checkpoint);
  friend bool operator==(const Basis&, const Basis&) = default;

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.collisions, self.log_rows, self.snapshots, self.state_size, self.state_checksum);
  }
};

}  // namespace zenosphere
