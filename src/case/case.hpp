#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/arrangement.hpp"
#include "model/average_start.hpp"
#include "model/gap_threshold.hpp"
#include "model/oscillation.hpp"
#include "model/overlap_rule.hpp"
#include "model/precision.hpp"

namespace zenosphere {

enum class DriveKind { none, shear, random };
enum class RestitutionLaw { constant, viscoelastic, fixed_loss, two_valued };
enum class CollisionLog { all, window, none };
enum class SnapshotSpacing { linear, logarithmic };
enum class Axis { x, y, z };
enum class SizeDistribution { uniform, normal, lognormal };

/// Coulomb's coefficient of friction; infinite where nothing ever slides.
struct Friction {
  double coefficient = 0;
  friend bool operator==(const Friction&, const Friction&) = default;
};

/// One kind of spheres, as a table [[species]] describes it.
struct Species {
  std::string name{};
  double diameter = 0;
  std::optional<double> mass{};           ///< none: diameter^D, the density of a unit sphere
  std::optional<double> share{};          ///< of the number of spheres
  std::optional<std::int64_t> spheres{};  ///< or their number
  bool immobile = false;
};

/// What holds between two kinds instead of the values for all, as a table [[contact]] has it.
struct SpeciesContact {
  std::array<std::string, 2> between{};
  std::optional<double> restitution{};
  std::optional<double> tangential_restitution{};
  std::optional<Friction> friction{};
};

/// What the rules about the box need to know of the diameters of all spheres.
struct SizeSummary {
  double mean = 1;        ///< diameter
  double mean_power = 1;  ///< mean of diameter^D
  double smallest = 1;
  double largest = 1;
};

/// One run as its user describes it: the resolved content of a case file.
///
/// Lengths are in sphere diameters, masses in sphere masses, times in the case's own unit; where
/// there are species, in the units in which their diameters and masses are given.
/// The members mirror the tables and keys of the file; docs/case-file.md tells what each means.
struct Case {
  struct System {
    int dimension = 0;
    std::int64_t spheres = 0;
    double restitution = 0;             ///< read by RestitutionLaw::constant only
    double solids_volume_fraction = 0;  ///< of the box; 0 where `sides` are given
    double aspect_ratio = 1;            ///< side along x / each other side
    std::vector<double> sides{};        ///< D sides; empty: from the two keys above
    SizeSummary sizes{};                ///< no key: what follows from species and their spread
  } system;
  std::vector<Species> species{};          ///< empty: unit spheres of one kind
  std::vector<SpeciesContact> contacts{};  ///< no two of the same pair
  struct Polydispersity {
    std::optional<SizeDistribution> distribution;  ///< none: all of a kind have its diameter
    double spread = 0;                             ///< standard deviation / mean of the diameter
  } polydispersity;
  struct Start {
    Arrangement arrangement = Arrangement::fcc;
    std::optional<double> granular_temperature;  ///< (diameter/time)^2; none: as given
    std::uint64_t seed = 1;
    std::vector<std::vector<double>> positions{};   ///< N x D, for Arrangement::given
    std::vector<std::vector<double>> velocities{};  ///< N x D, laboratory, likewise
    std::string file{};                             ///< for Arrangement::file
    std::optional<std::int64_t> snapshot{};         ///< of the file, from 0; none: the last
  } start;
  struct Drive {
    DriveKind kind = DriveKind::none;
    double shear_rate = 0;      ///< 1/time
    double noise_strength = 0;  ///< variance of velocity gained per time, diameter^2/time^3
    double kick_interval = 0;   ///< time between kicks
  } drive;
  struct Walls {
    std::optional<Axis> axis;  ///< normal of the walls; none: no walls
    double restitution = 1;
    double tangential_restitution = -1;  ///< -1 smooth, 0 the sphere takes the wall's velocity
    std::optional<Friction> friction{};  ///< of rough spheres; none: unbounded
    double lower_speed = 0;              ///< of the wall along x, diameters/time
    double upper_speed = 0;
    std::optional<OscillationShape> motion{};  ///< of the lower wall along the axis; none: it rests
    double amplitude = 0;                      ///< diameters
    double frequency = 0;                      ///< 1/time
    double resting_flight = 1e-4;  ///< of a sphere that rests on it, periods; 0: it cannot rest
    std::optional<double> lower_temperature{};  ///< mass (diameter/time)^2; none: not thermal
    std::optional<double> upper_temperature{};
  } walls;
  struct Gravity {
    std::vector<double> acceleration{};  ///< D components, diameters/time^2; empty: none
  } gravity;
  struct Collisions {
    OverlapRule overlap = OverlapRule::rewind;
    double guard = 1e-15;  ///< diameter^2/time; only the rule `guarded` reads it
    Precision precision = Precision::double_precision;
    RestitutionLaw restitution_law = RestitutionLaw::constant;
    double viscoelastic_constant = 0;  ///< A, (time/diameter)^(1/5)
    double energy_loss = 0;            ///< of an energetic collision, mass diameter^2/time^2
    double slow_restitution = 0;       ///< of RestitutionLaw::two_valued: below the threshold
    double fast_restitution = 0;       ///< from the threshold on
    double threshold_speed = 0;        ///< diameters/time
    double contact_duration = 0;       ///< of the TC model, time; 0: not used
    double rotation_angle = 0;         ///< largest, radians; 0: not used
    std::optional<double> tangential_restitution;       ///< beta0; none: smooth spheres
    std::optional<Friction> friction;                   ///< mu, together with it
    std::optional<double> reduced_moment_of_inertia{};  ///< q = 4 I/(m s^2); none: solid spheres
  } collision;
  struct Collapse {
    GapThreshold gap_threshold = 1e-16;  ///< diameters
    std::int64_t window = 10000;         ///< collisions
    bool stop_when_collapsed = true;
  } collapse;
  struct Run {
    std::optional<std::int64_t> collisions;
    std::optional<double> time;
  } run;
  struct Measure {
    AverageStart after_time = 0.0;
    std::optional<double> interval;           ///< of the time series; none: from the collision rate
    std::optional<double> sampling_interval;  ///< of what is accumulated; none: nothing is
  } measure;
  struct Output {
    std::optional<double> snapshot_interval;  ///< time; none: only the first and the last state
    SnapshotSpacing snapshot_spacing = SnapshotSpacing::linear;
    CollisionLog collision_log = CollisionLog::all;
    std::int64_t log_first = 1;                         ///< first collision of a windowed log
    std::optional<std::int64_t> log_last;               ///< last collision of a windowed log
    double checkpoint_seconds = 60;                     ///< wall time between checkpoints
    std::optional<std::int64_t> checkpoint_collisions;  ///< collisions between checkpoints
  } output;

  std::string text;  ///< the file as it was read, byte for byte
};

}  // namespace zenosphere
