#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "case/tables/run.hpp"
#include "model/case_key.hpp"
#include "model/word_table.hpp"

namespace zenosphere {

enum class CollisionLog { all, window, none };
inline constexpr std::array log_words{Word{"all", CollisionLog::all},
                                      Word{"window", CollisionLog::window},
                                      Word{"none", CollisionLog::none}};
inline const auto& words_of(CollisionLog) { return log_words; }

enum class SnapshotSpacing { linear, logarithmic };
inline constexpr std::array spacing_words{Word{"linear", SnapshotSpacing::linear},
                                          Word{"log", SnapshotSpacing::logarithmic}};
inline const auto& words_of(SnapshotSpacing) { return spacing_words; }

namespace case_format {

inline constexpr When only_with_snapshots{
    "output.snapshot_interval", "",
    [](const auto& c) { return c.output.snapshot_interval.has_value(); },
    "an output.snapshot_interval"};
inline constexpr When only_windowed{
    "output.collision_log", "",
    [](const auto& c) { return c.output.collision_log == CollisionLog::window; },
    "output.collision_log = \"window\""};

/// The table [output]: what of a run is kept in its file.
struct Output {
  std::optional<double> snapshot_interval;  ///< time; none: only the first and the last state
  SnapshotSpacing snapshot_spacing = SnapshotSpacing::linear;
  CollisionLog collision_log = CollisionLog::all;
  std::int64_t log_first = 1;                         ///< first collision of a windowed log
  std::optional<std::int64_t> log_last;               ///< last collision of a windowed log
  double checkpoint_seconds = 60;                     ///< wall time between checkpoints
  std::optional<std::int64_t> checkpoint_collisions;  ///< collisions between checkpoints

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"snapshot_interval", optional, above(0), "between snapshots [time]"},
          snapshot_interval);
    visit(CaseKey{"snapshot_spacing", optional, any,
                  "how snapshots follow each other; log: ten in each decade of time"},
          snapshot_spacing, only_with_snapshots);
    visit(CaseKey{"collision_log", optional, any, "which collisions are stored"}, collision_log);
    visit(CaseKey{"log_first", optional, from_to(1, most_collisions), "first collision stored"},
          log_first, only_windowed);
    visit(CaseKey{"log_last", optional, from_to(1, most_collisions), "last collision stored"},
          log_last, only_windowed);
    visit(CaseKey{"checkpoint_seconds", optional, above(0),
                  "wall time between checkpoints, at least [s]"},
          checkpoint_seconds);
    visit(CaseKey{"checkpoint_collisions", optional, from_to(1, most_collisions),
                  "a checkpoint after every so many"},
          checkpoint_collisions);
  }
};

}  // namespace case_format
}  // namespace zenosphere
