#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace zenosphere {

/// Two spheres, or a sphere and a wall, that met again and again; and how often.
struct RepeatedContact {
  std::int32_t i = 0;
  std::int32_t j = 0;           ///< > i; the number of spheres and one more stand for the two walls
  std::int64_t collisions = 0;  ///< among those that were kept

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.i, self.j, self.collisions);
  }
};

/// Spheres connected by repeated contacts.
struct Cluster {
  std::vector<std::int32_t> spheres;      ///< ascending
  std::vector<double> positions;          ///< of each, D components from their mean, diameters
  std::vector<RepeatedContact> contacts;  ///< of these spheres, in order of i and j
  std::vector<std::int32_t> chain;        ///< its backbone, ContactGraph::longest_way
  double straightness = 1;                ///< distance of the chain's ends / its number of bonds
  std::vector<double> bends;  ///< between successive bonds of the chain, radians; 0: none

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.spheres, self.positions, self.contacts, self.chain, self.straightness, self.bends);
  }
};

/// The collisions of one cluster, one row each, up to the moment of a dissection.
///
/// A flight is counted from the collision of the cluster before; the gap is what it closed.
struct ClusterCollisions {
  std::vector<std::int64_t> k;       ///< number of the collision
  std::vector<double> time;          ///< from the moment of the dissection on, <= 0
  std::vector<std::int32_t> i, j;    ///< as in the log
  std::vector<double> gap;           ///< diameters
  std::vector<double> normal_speed;  ///< diameters/time
  std::vector<double> flight;        ///< time

  /// Calls `visit(name, column)` for each column.
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("k", self.k);
    visit("time", self.time);
    visit("i", self.i);
    visit("j", self.j);
    visit("gap", self.gap);
    visit("normal_speed", self.normal_speed);
    visit("flight", self.flight);
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    fields(self, [&](const char*, auto& column) { archive(column); });
  }
};

/// A factor per collision: a median over the last collisions, and half their interquartile range.
struct DecayRate {
  double ratio = 1;
  double spread = 0;

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.ratio, self.spread);
  }
};

/// Factors per collision of a straight chain of balls.
struct ChainFactors {
  double gap = 0;
  double speed = 0;
  double flight = 0;

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.gap, self.speed, self.flight);
  }
};

/// How a cluster collapses: what its gaps, speeds and flights are multiplied by at each collision.
///
/// Each is measured where it is far above rounding, and absent where that never was.
struct Decay {
  double cycle = 0;  ///< collisions of the cluster until the same pair collides again, median
  /// Gaps above it count, diameters; flights above it x the clock unit, or what the clock stood at.
  double resolution = 0;
  std::optional<DecayRate> gap;
  std::optional<DecayRate> speed;
  std::optional<DecayRate> flight;
  std::optional<ChainFactors> exact;    ///< of a straight chain of as many balls, if that collapses
  std::optional<double> collapse_time;  ///< extrapolated, since the start
  std::optional<double> collapse_time_after;  ///< the same, from the moment of the dissection on
  double collapse_time_error = 0;             ///< the range of the last estimates of the latter

  /// Error of `collapse_time`: since the start, it is rounded besides.
  double error_since_start() const {
    return collapse_time_error +
           std::numeric_limits<double>::epsilon() * std::abs(collapse_time.value_or(0));
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.cycle, self.resolution, self.gap, self.speed, self.flight, self.exact,
            self.collapse_time, self.collapse_time_after, self.collapse_time_error);
  }
};

/// What was found at a hit of the separation criterion or at an arrest.
struct Dissection {
  std::int64_t collision = 0;                                ///< the one after which it was made
  double time = 0;                                           ///< of that
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;  ///< of the hit, or of the arrest
  std::vector<Cluster> clusters;  ///< those of the pairs in their order, then the others by size
  ClusterCollisions collisions;   ///< of the first cluster
  Decay decay;                    ///< of the first cluster

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.collision, self.time, self.pairs, self.clusters, self.collisions, self.decay);
  }
};

/// Whether i is a sphere, and j one behind it or a wall.
bool is_pair(const std::pair<std::int32_t, std::int32_t>& pair, std::int32_t spheres);

/// Whether a dissection can be one of so many spheres: it has a cluster, names no other spheres,
/// and what belongs together is of one length.
bool is_possible(const Dissection& dissection, int dimension, std::int32_t spheres);

/// The first hit and the arrest of a run, as far as they happened.
struct Anatomy {
  std::optional<Dissection> hit;
  std::optional<Dissection> arrest;

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.hit, self.arrest);
  }
};

}  // namespace zenosphere
