#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "campaign/response.hpp"

namespace zenosphere {

/// Where a probability is sought to cross one half, and how well.
struct SearchRange {
  double from = 0;
  double to = 0;                ///< > from
  double resolution = 0;        ///< length of the 95 % interval at which the search ends
  bool is_whole = false;        ///< x is a count
  std::int64_t most_runs = 0;   ///< the search ends with these, resolved or not
  std::int64_t round_runs = 8;  ///< runs that are placed at once
};

/// What a search knows so far.
enum class BoundaryFinding {
  crossing,    ///< the interval is as narrow as wanted
  below,       ///< P < 1/2 in the whole range, with 97.5 % probability
  above,       ///< P > 1/2 in the whole range, with 97.5 % probability
  unresolved,  ///< none of these yet
};

/// `crossing`, `below`, `above`, `unresolved`.
std::string_view word_of(BoundaryFinding finding);

/// Where P = 1/2 is: posterior median and the 95 % interval between the 2.5 % and 97.5 % quantiles.
/// An end outside the range means that the interval goes on there.
struct Estimate {
  double place = 0;
  double low = 0;
  double high = 0;
};

/// Finds where a probability crosses one half, in rounds of a few runs.
///
/// The first round is spread evenly over the range. Each later one is placed where the mean of P(x)
/// over all that is still possible takes the values (j + 1/2) / k for k runs: while the place is
/// unknown this cuts the possible part into equal shares (a bisection with k cuts), once it is
/// known the runs spread over the slope, where they tell most about c and s both.
///
/// The rounds depend on the results of former rounds only, not on their order, nor on the machine.
///
/// Source: see Response; design points on the slope: K. Chaloner & K. Larntz, J. Stat. Plan.
/// Inference 21 (1989) 191.
class BoundarySearch {
 public:
  explicit BoundarySearch(const SearchRange& range);

  /// The x of the next round, ascending; none once the search has ended.
  std::vector<double> next_round() const;

  /// Learns from one finished run. The order within a round is the caller's promise: that of the
  /// run numbers.
  void observe(double x, bool is_met);

  /// Counts a run that has failed: nothing is learnt, but it has been used.
  void observe_failure() { ++runs_; }

  /// Whether there is no further round.
  bool has_ended() const;

  BoundaryFinding finding() const;
  Estimate estimate() const;
  std::int64_t runs() const { return runs_; }

 private:
  std::vector<double> spread(std::int64_t runs) const;
  double place_of(double level, Response::Direction direction) const;
  double rounded(double x) const;

  SearchRange range_;
  Response response_;
  std::int64_t runs_ = 0;
};

}  // namespace zenosphere
