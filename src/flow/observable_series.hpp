#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "flow/averages.hpp"
#include "model/archive.hpp"

namespace zenosphere {

/// One number of `Observables`: where it is in a row of a series, and how its averages combine.
struct ObservableColumn {
  std::string name;
  Shape shape;
  Mean mean;
  std::size_t first;  ///< of the components of its observable
  std::size_t count;  ///< of these components
};

/// Averages over successive intervals of equal length, from time 0 on: the time series of a run.
///
/// So that a long run has no more rows than a short one, two and two are put together, and the
/// interval doubles, whenever there are more than `most_rows`, or more than one for every two
/// collisions of a sphere: to close an interval takes as long as some collisions of every sphere.
class ObservableSeries {
 public:
  static constexpr std::size_t most_rows = 1024;

  ObservableSeries() = default;

  /// \param prototype  with rows and matrices of the sizes that all will have
  /// \param interval   time; 0: it is set later
  /// \param spheres    of the system
  ObservableSeries(const Observables& prototype, double interval, std::int64_t spheres);

  bool has_interval() const { return interval_ > 0; }
  void set_interval(double interval) { interval_ = interval; }
  double interval() const { return interval_; }

  std::size_t rows() const { return steps_.size(); }
  /// Where the last interval ends, and the next one.
  double end() const { return end_of(rows()); }
  double next_end() const { return end_of(rows() + 1); }
  double end_of(std::size_t rows) const {
    return rows == 0 ? 0 : static_cast<double>(rows) * interval_;
  }

  /// Appends the averages of the next interval. After it the interval may be twice as long.
  ///
  /// \param step  collisions at its end
  void add(const Observables& averages, std::int64_t step);

  /// Observables of the sizes that all have.
  const Observables& shape() const { return prototype_; }
  /// The observables whose numbers make up a row, in order.
  const std::vector<ObservableColumn>& columns() const { return columns_; }
  std::size_t width() const { return width_; }
  /// Collisions at the end of each interval.
  const std::vector<std::int64_t>& steps() const { return steps_; }

  /// The averages of each interval from `first` on: a number of `columns`, of each component.
  std::vector<double> values(const ObservableColumn& column, std::size_t first = 0) const;

  /// The averages over all intervals from `first` on and, if `span` > 0, over another span of time.
  ///
  /// \param first  below `rows()`, unless there is a span
  Observables mean(std::size_t first, const Observables& after, double span) const;

  /// The series of component `number` of a row, such that its mean is the average of that number,
  /// and its scatter that of the average: of a ratio or a root, linearised about the average.
  std::vector<double> linearised(std::size_t number, std::size_t first) const;

  /// Observables of this shape from the numbers of a row.
  Observables shaped(const std::vector<double>& row) const;

  /// \throws ArchiveError for rows of another width
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.interval_, self.sums_, self.steps_);
    require_archived(self.sums_.size() == self.steps_.size() * self.width_ &&
                         self.steps_.size() <= most_rows && self.interval_ >= 0 &&
                         self.interval_ <= std::numeric_limits<double>::max(),
                     "a series of another system");
  }

 private:
  void put_together();
  double weight_of(Mean mean, const double* row) const;

  Observables prototype_;
  std::vector<ObservableColumn> columns_;
  std::vector<Mean> means_;  ///< of each number of a row
  std::size_t width_ = 0;
  std::size_t collision_rate_ = 0, granular_temperature_ = 0, pressure_ = 0;  ///< that are weights
  std::int64_t spheres_ = 0;
  double interval_ = 0;
  std::vector<double> sums_;  ///< rows x width: averages times weights, which can be added
  std::vector<std::int64_t> steps_;
};

}  // namespace zenosphere
