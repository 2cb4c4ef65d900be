#include "campaign/boundary_search.hpp"

#include <algorithm>
#include <cmath>

namespace zenosphere {
namespace {

/// Both tails of a 95 % interval.
constexpr double tail = 0.025;
/// Rounds before anything is concluded: a flat response may well begin with eight of a kind.
constexpr std::int64_t least_rounds = 2;

}  // namespace

std::string_view word_of(BoundaryFinding finding) {
  switch (finding) {
    case BoundaryFinding::crossing:
      return "crossing";
    case BoundaryFinding::below:
      return "below";
    case BoundaryFinding::above:
      return "above";
    case BoundaryFinding::unresolved:
      break;
  }
  return "unresolved";
}

BoundarySearch::BoundarySearch(const SearchRange& range)
    : range_(range), response_(range.from, range.to, range.resolution) {}

void BoundarySearch::observe(double x, bool is_met) {
  response_.observe(x, is_met);
  ++runs_;
}

Estimate BoundarySearch::estimate() const {
  return {response_.quantile(0.5), response_.quantile(tail), response_.quantile(1 - tail)};
}

BoundaryFinding BoundarySearch::finding() const {
  if (runs_ < least_rounds * range_.round_runs) return BoundaryFinding::unresolved;
  if (response_.below() > 1 - tail) return BoundaryFinding::below;
  if (response_.above() > 1 - tail) return BoundaryFinding::above;
  const Estimate estimate = this->estimate();
  const bool is_inside = estimate.low >= range_.from && estimate.high <= range_.to;
  const bool is_narrow = estimate.high - estimate.low <= range_.resolution;
  return is_inside && is_narrow ? BoundaryFinding::crossing : BoundaryFinding::unresolved;
}

bool BoundarySearch::has_ended() const {
  return runs_ >= range_.most_runs || finding() != BoundaryFinding::unresolved;
}

std::vector<double> BoundarySearch::next_round() const {
  if (has_ended()) return {};
  const std::int64_t runs = std::min(range_.round_runs, range_.most_runs - runs_);
  if (runs_ == 0) return spread(runs);
  std::vector<double> round;
  const auto rising =
      static_cast<std::int64_t>(std::floor(response_.rising() * static_cast<double>(runs) + 0.5));
  for (std::int64_t run = 0; run < runs; ++run) {
    const bool rises = run < rising;
    const auto count = static_cast<double>(rises ? rising : runs - rising);
    const auto number = static_cast<double>(rises ? run : run - rising);
    round.push_back(place_of((number + 0.5) / count,
                             rises ? Response::Direction::rising : Response::Direction::falling));
  }
  std::sort(round.begin(), round.end());
  return round;
}

std::vector<double> BoundarySearch::spread(std::int64_t runs) const {
  std::vector<double> round;
  for (std::int64_t run = 0; run < runs; ++run) {
    const double share = runs == 1 ? 0.5 : static_cast<double>(run) / static_cast<double>(runs - 1);
    round.push_back(rounded(range_.from + share * (range_.to - range_.from)));
  }
  return round;
}

/// By bisection, down to a sixteenth of the resolution; the range's end where P is not reached.
double BoundarySearch::place_of(double level, Response::Direction direction) const {
  double low = range_.from, high = range_.to;
  const bool rises = direction == Response::Direction::rising;
  while (high - low > range_.resolution / 16) {
    const double middle = low + (high - low) / 2;
    const bool is_left = (response_.mean(middle, direction) < level) == rises;
    (is_left ? low : high) = middle;
  }
  if (low == range_.from) return rounded(low);
  return rounded(high == range_.to ? high : low + (high - low) / 2);
}

/// The nearest decimal number with steps of at most a tenth of the resolution, so that tables read
/// well; a whole number for a count.
double BoundarySearch::rounded(double x) const {
  double steps = 1;  // in a unit of x; a power of ten, so that n / steps is the decimal's double
  if (!range_.is_whole) {
    while (steps * range_.resolution < 10 && steps < 1e15) steps *= 10;
  }
  return std::clamp(std::floor(x * steps + 0.5) / steps, range_.from, range_.to);
}

}  // namespace zenosphere
