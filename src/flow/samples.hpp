#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "flow/collision_sums.hpp"
#include "flow/displacement_sums.hpp"
#include "flow/layer_sums.hpp"
#include "flow/moment_sums.hpp"
#include "flow/pair_sums.hpp"
#include "flow/velocity_sums.hpp"
#include "flow/wave_sums.hpp"

namespace zenosphere {

/// When samples are taken.
struct SampleTimes {
  double interval;        ///< between two of them, whose times are multiples of it
  double from_time;       ///< no sample before it; collisions count from there on
  bool clock_is_limited;  ///< a time ends the run; else intervals grow as intervals_to_next()
};

/// Structure, velocities, profiles, displacements and collisions, accumulated while a run goes on.
///
/// Sums over successive rows of equally many samples, so that errors can be told and a beginning be
/// left out afterwards. Where there are `most_rows`, two and two are put together.
template <int Dim, class Real>
class Samples {
 public:
  static constexpr std::size_t most_rows = 64;

  /// \param simulation  at its start; the same object is handed to every later call
  Samples(const Simulation<Dim, Real>& simulation, const SampleTimes& times);

  /// When the next sample is due; infinity if none is.
  double next() const;

  /// To be called after each collision, in order.
  void observe(const Collision<Dim, Real>& collision, const Simulation<Dim, Real>& simulation);

  /// Takes the sample of the moment, and sets the next one an interval later.
  void take(const Simulation<Dim, Real>& simulation);

  /// What is summed up; `values` has the rows of one.
  const std::vector<SampledColumn>& columns() const { return columns_; }
  /// Where the bins of these columns begin and end.
  std::vector<SampledEdges> edges() const;
  /// Collisions and time at the last sample of each full row.
  const std::vector<std::int64_t>& steps() const { return steps_; }
  const std::vector<double>& times() const { return ends_; }
  /// The sums of a column, row after row.
  ///
  /// \param number  of the column
  std::vector<double> values(std::size_t number) const;

  /// \throws ArchiveError for sums of another system
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.multiple_, self.last_, self.in_a_row_, self.current_, self.sums_, self.ends_,
            self.steps_, self.collisions_, self.displacements_);
    const std::size_t rows = self.steps_.size();
    require_archived(self.current_.size() == self.width_ && self.ends_.size() == rows &&
                         rows < most_rows && self.sums_.size() == rows * self.width_,
                     "samples of another system");
    require_archived(self.multiple_ >= 1 && self.in_a_row_ >= 1 && std::isfinite(self.last_),
                     "samples that there cannot be");
    require_counts(self.multiple_, self.in_a_row_);
  }

 private:
  void put_together();
  void schedule_next(const Simulation<Dim, Real>& simulation);

  /// What is summed up of the moment of a sample alone; a new observable is a name in this list.
  using Moments = MomentSums<Dim, PairSums, VelocitySums, LayerSums, WaveSums>;

  SampledSystem<Dim> system_;
  SampleTimes when_;
  Moments moments_;
  DisplacementSums<Dim> displacements_;
  CollisionSums<Dim, Real> collisions_;
  std::vector<SampledColumn> columns_;
  std::size_t width_ = 0, first_of_collisions_ = 0;
  std::int64_t multiple_ = 1;    ///< of the interval, at which the next sample is due
  double last_;                  ///< sample, time; before it the time from which collisions count
  std::int64_t in_a_row_ = 1;    ///< samples
  std::vector<double> current_;  ///< row that is not full yet
  std::vector<double> sums_;     ///< rows x width
  std::vector<double> ends_;     ///< of full rows
  std::vector<std::int64_t> steps_;
};

}  // namespace zenosphere
