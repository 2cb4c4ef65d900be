#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "storage/records.hpp"

namespace zenosphere {

/// A stretch of the collision log, in columns, one entry a bin of `width` rows (the last may hold
/// fewer): enough to draw it at any zoom without losing an extreme.
struct LogStretch {
  std::int64_t width = 1;           ///< rows a bin
  std::int64_t last = 0;            ///< number of the last collision
  std::vector<double> k;            ///< number of the first collision
  std::vector<double> time;         ///< of the last one
  std::vector<double> gap_low;      ///< smallest known gap of the next pair, diameters; NaN: none
  std::vector<double> gap_high;     ///< largest, likewise
  std::vector<double> speed_low;    ///< smallest closing speed, diameters/time
  std::vector<double> speed_high;   ///< largest
  std::vector<double> flight_low;   ///< shortest time from one collision to the next; NaN: unknown
  std::vector<double> flight_high;  ///< longest
  std::vector<std::int32_t> hits;   ///< collisions with flag 1
  std::vector<std::uint8_t> flags;  ///< which flags occur (docs/file-format.md)
  std::vector<std::int32_t> i, j;   ///< the pair; empty where a bin holds more than one row

  std::size_t bins() const { return k.size(); }
};

/// Bins the rows of a log as they come, in memory that does not grow with the log.
class LogDigest {
 public:
  /// Logs of up to so many rows are kept as they are.
  static constexpr std::int64_t most_rows = 65536;
  /// Longer ones in at most so many bins: eight for each column of pixels of a wide screen.
  static constexpr std::int64_t most_bins = 32768;

  /// \param rows  that will come
  explicit LogDigest(std::int64_t rows)
      : LogDigest(rows, rows <= most_rows ? 1 : (rows + most_bins - 1) / most_bins) {}

  void observe(const CollisionRow& row);
  const LogStretch& stretch() const { return stretch_; }

 private:
  LogDigest(std::int64_t rows, std::int64_t width);
  void begin_bin(const CollisionRow& row);

  LogStretch stretch_;
  std::int64_t in_bin_ = 0;
  std::optional<CollisionRow> before_;
};

/// Keeps every row about one collision of a log that is too long to be kept.
class CloseUp {
 public:
  static constexpr std::int64_t rows_kept = 4096;

  /// \param collision  number of the one in the middle
  explicit CloseUp(std::int64_t collision)
      : first_(collision - rows_kept / 2), digest_(rows_kept) {}

  void observe(const CollisionRow& row) {
    if (row.k >= first_ && row.k - first_ < rows_kept) digest_.observe(row);
  }
  const LogStretch& stretch() const { return digest_.stretch(); }

 private:
  std::int64_t first_;
  LogDigest digest_;
};

}  // namespace zenosphere
