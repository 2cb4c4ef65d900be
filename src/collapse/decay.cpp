#include "collapse/decay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

constexpr std::size_t most_points = 64;    // points: the beginning is not yet geometric
constexpr std::size_t least_slopes = 5;    // three in line would already look like a law
constexpr std::size_t most_estimates = 4;  // of the collapse time

/// A number that may be anywhere below the range of double becomes its logarithm.
template <class Real>
double logarithm(const Real& value) {
  using std::log;
  return static_cast<double>(log(value));
}

double quantile(std::vector<double> values, double fraction) {
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

/// One quantity over the collisions of a cluster, and its factor per collision.
///
/// The factor is the median of the slopes of its logarithm between any two collisions of one pair:
/// pairs need not be alike, and some that do not fit, or are rounded, do no harm.
/// Source: Sen, J. Am. Stat. Assoc. 63 (1968) 1379.
class Slope {
 public:
  /// \param place  of the collision in the sequence; may lie between two
  template <class Real>
  void add(int pair, double place, const Real& value) {
    points_.push_back({pair, place, logarithm(value)});
  }

  std::optional<DecayRate> rate() const {
    const auto last =
        points_.end() - static_cast<std::ptrdiff_t>(std::min(points_.size(), most_points));
    std::vector<double> slopes;
    for (auto one = last; one < points_.end(); ++one) {
      for (auto other = one + 1; other < points_.end(); ++other) {
        if (one->pair != other->pair) continue;
        slopes.push_back((other->logarithm - one->logarithm) / (other->place - one->place));
      }
    }
    if (slopes.size() < least_slopes) return std::nullopt;
    const double half_range = (quantile(slopes, 0.75) - quantile(slopes, 0.25)) / 2;
    const double ratio = std::exp(quantile(slopes, 0.5));
    return DecayRate{ratio, ratio * half_range};
  }

 private:
  struct Point {
    int pair;
    double place;
    double logarithm;
  };
  std::vector<Point> points_;
};

/// The sum of the geometric series that the last two cycles of a pair begin, after its last
/// collision; or nothing.
template <class Real>
std::optional<Real> time_left(const Real& before, const Real& last) {
  if (!(last < before)) return std::nullopt;  // also where there is none before
  const Real ratio = last / before;
  return last * ratio / (1 - ratio);
}

/// Follows the collisions of a cluster from one of a pair to its next.
template <class Real>
class Cycles {
 public:
  explicit Cycles(const Real& reading)
      : least_gap_(100000 * std::numeric_limits<Real>::epsilon()),
        least_flight_(least_gap_ * reading) {}

  void observe(const ClusterStep<Real>& step) {
    ++number_;
    const bool has_gap = step.gap > least_gap_;
    if (has_gap) gap_.add(step.pair, number_, step.gap);
    auto& pair = pairs_[step.pair];
    const bool has_cycle = pair.number > 0 && step.time - pair.time > least_flight_;
    if (has_cycle) end_cycle(pair, step);
    if ((has_gap || has_cycle) && step.normal_speed > 0) {
      speed_.add(step.pair, number_, step.normal_speed);
    }
    pair = {number_, step.time, has_cycle ? Real(step.time - pair.time) : Real(0)};
  }

  Decay decay() const {
    Decay decay;
    decay.resolution = static_cast<double>(least_gap_);
    if (!lengths_.empty()) decay.cycle = quantile(lengths_, 0.5);
    decay.gap = gap_.rate();
    decay.speed = speed_.rate();
    decay.flight = flight_.rate();
    const std::vector<Real>& ends = measured_ends_.empty() ? ends_ : measured_ends_;
    if (ends.empty()) return decay;
    const auto last = static_cast<std::ptrdiff_t>(std::min(ends.size(), most_estimates));
    const auto [low, high] = std::minmax_element(ends.end() - last, ends.end());
    decay.collapse_time_after = static_cast<double>(ends.back());
    decay.collapse_time_error = static_cast<double>(*high - *low);
    return decay;
  }

 private:
  /// The last collision of a pair.
  struct Pair {
    int number = 0;  ///< from 1
    Real time = 0;
    Real cycle = 0;  ///< duration of the cycle it has ended; 0: too short, or none
  };

  void end_cycle(const Pair& pair, const ClusterStep<Real>& step) {
    const Real cycle = step.time - pair.time;
    lengths_.push_back(number_ - pair.number);
    flight_.add(step.pair, (number_ + pair.number) / 2.0, cycle);
    const auto left = time_left(pair.cycle, cycle);
    if (!left) return;
    ends_.push_back(step.time + *left);
    if (step.gap > least_gap_) measured_ends_.push_back(ends_.back());
  }

  Real least_gap_;
  Real least_flight_;
  int number_ = 0;
  std::map<int, Pair> pairs_;
  Slope gap_, speed_, flight_;
  std::vector<double> lengths_;
  std::vector<Real> ends_;           ///< estimates of the collapse time, from the dissection on
  std::vector<Real> measured_ends_;  ///< those at a gap far above rounding: flights are gaps too
};

}  // namespace

template <class Real>
Decay decay_of(const std::vector<ClusterStep<Real>>& steps, const Real& reading) {
  Cycles<Real> cycles(reading);
  for (const auto& step : steps) cycles.observe(step);
  return cycles.decay();
}

std::optional<ChainFactors> chain_factors(int balls, double restitution) {
  const double half_sum = (1 + restitution) * std::cos(std::numbers::pi / balls) / 2;
  const double square = half_sum * half_sum - restitution;
  if (balls < 3 || square < 0) return std::nullopt;
  const double speed = half_sum + std::sqrt(square);
  const double gap = restitution / speed;
  const auto per_collision = [&](double of_round) { return std::pow(of_round, 2.0 / (balls - 1)); };
  return ChainFactors{per_collision(gap), per_collision(speed), per_collision(gap / speed)};
}

#define ZENOSPHERE_INSTANTIATE(Real) \
  template Decay decay_of<Real>(const std::vector<ClusterStep<Real>>&, const Real&);
ZENOSPHERE_FOR_EACH_REAL(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
