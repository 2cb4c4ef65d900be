#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/boundary_search.hpp"
#include "campaign/database.hpp"
#include "campaign/sweep.hpp"

namespace zenosphere {

/// What a search has found at one point of the other axes.
struct FoundBoundary {
  std::vector<std::string> values;  ///< of the other axes, as in their columns
  BoundaryFinding finding = BoundaryFinding::unresolved;
  Estimate estimate{};
  std::int64_t rounds = 0;
  std::int64_t runs = 0;  ///< failed ones included
};

/// Creates the table `boundary` of a store that is new.
void create_boundary_table(Database& database, const Sweep& sweep);

/// Throws an InputError where a store and a sweep are not both searches for the same.
void require_same_search(Database& database, const Sweep& sweep);

/// The rounds of a search, one at each point of the other axes at a time.
///
/// All points go on in step: when every run of a round has ended, the next round of all points that
/// still search is added to the table `run`, in the order of the points. So the store depends on
/// nothing but the sweep file, whoever did the runs and in whatever order.
class BoundaryRounds {
 public:
  /// \param database, sweep  outlive this; the sweep is a search
  BoundaryRounds(Database& database, const Sweep& sweep);

  /// Learns from all runs that have ended since the last call, updates the table `boundary` and
  /// adds the runs of the next round; to be called when none is pending. Throws OutputError.
  ///
  /// \return  whether there is a next round
  bool place_next();

  /// What is known at each point, as of the last call of place_next.
  std::vector<FoundBoundary> found() const;

 private:
  struct Point {
    std::vector<Cell> cells;  ///< of the other axes
    BoundarySearch search;
    std::int64_t rounds = 0;
    std::int64_t failed = 0;
  };

  void learn();
  void write_table();
  bool add_runs();

  Database& database_;
  const Sweep& sweep_;
  std::vector<Point> points_{};
  std::int64_t next_run_ = 0;
};

}  // namespace zenosphere
