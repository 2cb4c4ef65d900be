#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/arrangement.hpp"
#include "model/overlap_rule.hpp"

namespace zenosphere {

enum class DriveKind { none, shear };
enum class Precision { double_precision };
enum class CollisionLog { all, window, none };

/// One run as its user describes it: the resolved content of a case file.
///
/// Lengths are in sphere diameters, masses in sphere masses, times in the case's own unit.
/// The members mirror the tables and keys of the file; docs/case-file.md tells what each means.
struct Case {
  struct System {
    int dimension = 0;
    std::int64_t spheres = 0;
    double restitution = 0;
    double solids_volume_fraction = 0;
  } system;
  struct Start {
    Arrangement arrangement = Arrangement::fcc;
    double granular_temperature = 0;  ///< (diameter/time)^2
    std::uint64_t seed = 1;
  } start;
  struct Drive {
    DriveKind kind = DriveKind::none;
    double shear_rate = 0;  ///< 1/time
  } drive;
  struct Collisions {
    OverlapRule overlap = OverlapRule::rewind;
    double guard = 1e-15;  ///< diameter^2/time; only the rule `guarded` reads it
    Precision precision = Precision::double_precision;
  } collision;
  struct Collapse {
    double gap_threshold = 1e-16;  ///< diameters
    std::int64_t window = 10000;   ///< collisions
    bool stop_when_collapsed = true;
  } collapse;
  struct Run {
    std::optional<std::int64_t> collisions;
    std::optional<double> time;
  } run;
  struct Measure {
    double after_time = 0;
  } measure;
  struct Output {
    std::optional<double> snapshot_interval;  ///< time; none: only the first and the last state
    CollisionLog collision_log = CollisionLog::all;
    std::int64_t log_first = 1;            ///< first collision of a windowed log
    std::optional<std::int64_t> log_last;  ///< last collision of a windowed log
  } output;

  std::string text;  ///< the file as it was read, byte for byte
};

}  // namespace zenosphere
