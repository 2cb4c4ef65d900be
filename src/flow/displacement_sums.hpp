#pragma once

#include <cstdint>
#include <vector>

#include "flow/sampled_system.hpp"

namespace zenosphere {

/// How far spheres come, and for how long their velocities remember: mean-square displacements
/// and velocity autocorrelations over stretches of samples, each with an origin of its own.
///
/// Level n looks at every 2^n-th sample, compares the next `lags` of these with its origin, and
/// begins anew at the last one: ever longer times for the memory of two vectors a sphere and
/// level. A step from one sample to the next is unwrapped by its nearest image, less what the shear
/// has carried the sphere along and the common motion. The same as zenosphere analyse finds in
/// snapshots, defined in docs/measurements.md.
///
/// Source: Frenkel & Smit, Understanding Molecular Simulation, 2nd ed. (2002), section 4.4.2 (the
/// ever coarser levels; here with one origin for each).
template <int Dim>
class DisplacementSums {
 public:
  static constexpr std::size_t lags = 10;
  static constexpr std::size_t most_levels = 8;

  explicit DisplacementSums(const SampledSystem<Dim>& system);

  std::vector<SampledColumn> columns() const;
  /// \param interval  between samples, time
  std::vector<SampledEdges> edges(double interval) const;

  /// Adds the stretches that end with a sample to the sums of `columns()`.
  ///
  /// \param velocities  peculiar
  /// \param multiple    of `interval`, at which the sample is taken
  void add(const SampledMoment<Dim>& moment, const std::vector<Vec<Dim, double>>& velocities,
           std::int64_t multiple, double interval, SumsOfColumns& sums);

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    const std::size_t levels = self.levels_.size();
    archive(self.last_, self.positions_, self.moved_, self.fastest_, self.levels_);
    const auto holds = [&](const auto& vectors) {
      return vectors.empty() || vectors.size() == static_cast<std::size_t>(self.system_.spheres);
    };
    bool fits = self.levels_.size() == levels && holds(self.positions_) && holds(self.moved_);
    for (const Level& level : self.levels_) {
      fits = fits && holds(level.moved) && holds(level.velocities) && level.seen < lags;
      fits = fits && (level.moved.empty() ? level.seen == 0 : !level.velocities.empty());
      fits = fits && level.squares.size() == lags && level.products.size() == lags;
    }
    require_archived(fits && self.moved_.size() == self.positions_.size(),
                     "displacements of another system");
  }

 private:
  using Vector = Vec<Dim, double>;

  /// A stretch that has begun.
  struct Level {
    std::int64_t begin = 0;            ///< multiple of its origin
    std::uint64_t seen = 0;            ///< samples after it
    std::vector<Vector> moved{};       ///< at the origin; empty: none yet
    std::vector<Vector> velocities{};  ///< at the origin
    double square = 0;                 ///< of these, mean over the mobile spheres
    std::vector<Vector> squares = std::vector<Vector>(lags);  ///< displacements at each lag
    std::vector<double> products = std::vector<double>(lags);

    template <class Self, class Archive>
    static void archive_state(Self& self, Archive& archive) {
      archive(self.begin, self.seen, self.moved, self.velocities, self.square, self.squares,
              self.products);
    }
  };

  /// Of all levels, those of `columns()`.
  struct Sums {
    double *stretches, *moving_stretches, *squares, *correlations;
  };

  void go_on(const SampledMoment<Dim>& moment, const std::vector<Vector>& velocities, double time,
             double* uncertain);
  Vector step(std::size_t i, const SampledMoment<Dim>& moment, double time) const;
  void take_off_common(std::vector<Vector>& steps) const;
  void begin(Level& level, const std::vector<Vector>& velocities, std::int64_t multiple) const;
  void look(Level& level, const std::vector<Vector>& velocities) const;
  void end(std::size_t n, const Sums& sums) const;
  double mean_product(const std::vector<Vector>& a, const std::vector<Vector>& b) const;

  SampledSystem<Dim> system_;
  double mobile_ = 0;                ///< spheres that are
  bool has_common_motion_ = true;    ///< which is taken off
  std::int64_t last_ = 0;            ///< sample, as a multiple of the interval
  std::vector<Vector> positions_{};  ///< in it; empty: there is none
  std::vector<Vector> moved_{};      ///< since the first sample, relative to the flow
  Vector fastest_{};                 ///< along each axis in the last sample
  std::vector<Level> levels_;
};

}  // namespace zenosphere
