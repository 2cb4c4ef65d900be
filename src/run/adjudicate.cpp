#include "run/adjudicate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "collapse/arrest_criterion.hpp"
#include "collapse/collapse_time.hpp"
#include "collapse/separation_criterion.hpp"
#include "flow/measurements.hpp"
#include "io/case_file.hpp"
#include "io/case_words.hpp"
#include "model/errors.hpp"
#include "run/arithmetic.hpp"
#include "run/random_driving.hpp"
#include "run/setup.hpp"

namespace zenosphere {

namespace {

/// Most digits after the point that a gap is sorted by: below lie only the subnormal numbers.
constexpr std::size_t most_decades = 307;

/// A run that is watched by the criteria and recorded nowhere.
template <int Dim, class Real>
class Watched {
 public:
  Watched(const Case& values, const std::atomic<bool>* interrupt)
      : Watched(values, interrupt, new_simulation<Dim, Real>(values)) {}

  /// Goes on from the state that `state()` gave, perhaps in fewer digits.
  Watched(const Case& values, const std::atomic<bool>* interrupt, ArchiveReader archive)
      : Watched(values, interrupt, archived_simulation<Dim, Real>(values, archive)) {
    archive(driving_);
  }

  /// Goes on until there are so many collisions or hits, or as its case has it.
  void go(std::int64_t collisions, std::int64_t hits) {
    while (!is_over(collisions, hits)) {
      if (const auto collision = simulation_.collision_until(next_pause())) {
        observe(*collision);
      } else if (simulation_.is_waiting()) {
        simulation_.wait_until(next_pause());
        if (simulation_.has_reached(driving_.next_kick())) {
          driving_.kick(simulation_, measurements_);
        }
      }
    }
    if (const auto& pair = simulation_.stopped_before()) separation_.observe_next(pair->gap);
  }

  /// The state of the engine and of what drives it.
  Bytes state() const {
    ArchiveWriter archive;
    simulation_.archive_to(archive);
    archive(driving_);
    return archive.release();
  }

  std::optional<std::int64_t> first_hit() const { return separation_.first_collision(); }
  std::int64_t collisions() const { return simulation_.collisions(); }
  double time() const { return simulation_.time(); }

  Trial trial() const {
    const auto text = [](const std::optional<Real>& number) {
      return number ? std::optional(to_decimal(*number)) : std::nullopt;
    };
    Trial trial;
    trial.precision = values_.collision.precision;
    trial.rule = values_.collision.overlap;
    trial.gap_threshold = values_.collapse.gap_threshold;
    trial.collisions = simulation_.collisions();
    trial.ended_by = ended_by_;
    trial.time = to_decimal(exactly_since_start(simulation_.now(), simulation_.box().clock_unit()));
    trial.hits = separation_.hits();
    trial.first_hit = separation_.first_collision();
    trial.first_hit_time = text(separation_.first_time());
    trial.last_hit = separation_.last_collision();
    trial.absorbed = absorbed_;
    trial.arrest = arrest_.collision();
    trial.collapse_time = text(collapse_time_.time());
    if (collapse_time_.ratio()) trial.collapse_ratio = static_cast<double>(*collapse_time_.ratio());
    trial.per_decade = per_decade_;
    trial.without_gap = without_gap_;
    return trial;
  }

 private:
  Watched(const Case& values, const std::atomic<bool>* interrupt, Simulation<Dim, Real> simulation)
      : values_(values),
        interrupt_(interrupt),
        simulation_(std::move(simulation)),
        driving_(values),
        separation_(values.collapse.gap_threshold, simulation_.box().clock_unit()),
        arrest_(values.collapse.gap_threshold, values.collapse.window,
                simulation_.box().clock_unit()),
        collapse_time_(simulation_.box().clock_unit()),
        measurements_(simulation_, std::numeric_limits<double>::infinity()) {}

  void observe(const Collision<Dim, Real>& collision) {
    separation_.observe(collision);
    arrest_.observe(collision);
    collapse_time_.observe(collision);
    absorbed_ += collision.absorbed;
    const double gap = static_cast<double>(collision.gap_before);
    if (!(gap > 0)) {
      ++without_gap_;
      return;
    }
    const auto digits = static_cast<std::size_t>(std::max(1.0, std::ceil(-std::log10(gap))));
    const std::size_t decade = std::min(digits, most_decades) - 1;
    if (per_decade_.size() <= decade) per_decade_.resize(decade + 1);
    ++per_decade_[decade];
  }

  /// Sets why the trial ends, once it does.
  bool is_over(std::int64_t collisions, std::int64_t hits) {
    const auto& limits = values_.run;
    if (interrupt_ && *interrupt_) throw InputError("interrupted; nothing was stored");
    if (arrest_.is_met()) {
      ended_by_ = "arrest";
    } else if (simulation_.stopped_before()) {
      ended_by_ = "overlap";
    } else if (simulation_.is_at_rest() && !driving_.is_on()) {
      ended_by_ = "at rest";
    } else if (simulation_.collisions() >= collisions || separation_.hits() >= hits) {
      ended_by_ = "collisions";
    } else if (limits.time && simulation_.has_reached(*limits.time)) {
      ended_by_ = "time";
    }
    return !ended_by_.empty();
  }

  double next_pause() const {
    const double end = values_.run.time.value_or(std::numeric_limits<double>::max());
    return std::min(end, driving_.next_kick());
  }

  Case values_;
  const std::atomic<bool>* interrupt_;
  Simulation<Dim, Real> simulation_;
  RandomDriving<Dim, Real> driving_;
  SeparationCriterion<Dim, Real> separation_;
  ArrestCriterion<Dim, Real> arrest_;
  CollapseTime<Dim, Real> collapse_time_;
  Measurements<Dim, Real> measurements_;
  std::int64_t absorbed_ = 0;
  std::vector<std::int64_t> per_decade_;
  std::int64_t without_gap_ = 0;
  std::string ended_by_;
};

constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();

/// A state before the first hit of a run.
struct Before {
  std::int64_t hit = 0;
  double time = 0;  ///< of the hit
  std::int64_t collisions = 0;
  int digits = 0;  ///< of the numbers in `state`
  Bytes state{};
};

template <int Dim, class Real>
Before state_before_hit(const Case& values, const std::atomic<bool>* interrupt) {
  Watched<Dim, Real> whole(values, interrupt);
  whole.go(values.run.collisions.value_or(kNoLimit), 1);
  if (!whole.first_hit()) {
    throw InputError(fmt::format(
        "no separation hit in {} collisions: there is nothing to adjudicate; raise run.collisions "
        "or run.time, or choose another case",
        whole.collisions()));
  }
  Before before{
      .hit = *whole.first_hit(), .time = whole.time(), .digits = std::numeric_limits<Real>::digits};
  const std::int64_t lead = std::max<std::int64_t>(values.system.spheres, 100);
  Watched<Dim, Real> again(values, interrupt);
  again.go(std::max<std::int64_t>(before.hit - lead, 0), kNoLimit);
  before.collisions = again.collisions();
  before.state = again.state();
  return before;
}

template <int Dim, class Real>
Trial trial_from(const Before& before, const Case& values, const AdjudicationLimits& limits) {
  ArchiveReader state(before.state);
  if (before.digits < std::numeric_limits<Real>::digits) state.promote_from(before.digits);
  Watched<Dim, Real> watched(values, limits.interrupt, state);
  watched.go(before.hit + limits.collisions, kNoLimit);
  return watched.trial();
}

/// The case of a trial: another precision, with its threshold, and another rule.
Case case_of_trial(Case values, Precision precision, OverlapRule rule) {
  const bool is_scaled =
      values.collapse.gap_threshold == default_gap_threshold(values.collision.precision);
  if (is_scaled) values.collapse.gap_threshold = default_gap_threshold(precision);
  values.collision.precision = precision;
  values.collision.overlap = rule;
  return values;
}

}  // namespace

Adjudication adjudicate(const Case& values, const AdjudicationLimits& limits) {
  Adjudication result;
  result.precision = values.collision.precision;
  result.rule = values.collision.overlap;
  if (limits.highest < result.precision) {
    throw InputError(fmt::format(
        "the run is in {} already, and digits cannot be taken away; choose a higher --up-to",
        word(result.precision)));
  }
  const Before before = in_arithmetic_of(values, [&]<int Dim, class Real>() {
    return state_before_hit<Dim, Real>(values, limits.interrupt);
  });
  result.hit = before.hit;
  result.from = before.collisions;
  result.time_between_collisions = before.time * static_cast<double>(values.system.spheres) /
                                   static_cast<double>(2 * std::max<std::int64_t>(before.hit, 1));
  constexpr std::array rules{OverlapRule::rewind, OverlapRule::immediate, OverlapRule::guarded,
                             OverlapRule::stop};
  const auto add = [&](Precision precision, OverlapRule rule) {
    const Case trial = case_of_trial(values, precision, rule);
    if (limits.on_trial) limits.on_trial(fmt::format("{}, {}", word(precision), word(rule)));
    result.trials.push_back(in_arithmetic_of(trial, [&]<int Dim, class Real>() {
      return trial_from<Dim, Real>(before, trial, limits);
    }));
  };
  for (const Precision precision :
       {Precision::double_precision, Precision::extended, Precision::quad, Precision::digits100}) {
    if (precision < result.precision || precision > limits.highest) continue;
    add(precision, result.rule);
    for (const OverlapRule rule : rules) {
      if (rule != result.rule) add(precision, rule);
    }
  }
  conclude(result);
  return result;
}

}  // namespace zenosphere
