#include "run/trial_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/instantiate.hpp"
#include "run/ending.hpp"

namespace zenosphere {

Case case_of_trial(Case values, Precision precision, OverlapRule rule) {
  const bool is_scaled = values.collapse.gap_threshold == GapThreshold(values.collision.precision);
  if (is_scaled) values.collapse.gap_threshold = GapThreshold(precision);
  values.collision.precision = precision;
  values.collision.overlap = rule;
  return values;
}

template <int Dim, class Real>
TrialRun<Dim, Real>::TrialRun(const Case& values)
    : TrialRun(values, new_simulation<Dim, Real>(values)) {}

template <int Dim, class Real>
TrialRun<Dim, Real>::TrialRun(const Case& values, ArchiveReader& archive)
    : TrialRun(values, archived_simulation<Dim, Real>(values, archive)) {
  archive(driving_);
}

template <int Dim, class Real>
TrialRun<Dim, Real>::TrialRun(const Case& values, Simulation<Dim, Real> simulation)
    : values_(values),
      limit_(-GapThreshold(values.collision.precision).log10()),
      simulation_(std::move(simulation)),
      driving_(values),
      separation_(values.collapse.gap_threshold.template in<Real>(),
                  simulation_.box().clock_unit()),
      arrest_(values.collapse.gap_threshold.template in<Real>(), values.collapse.window,
              simulation_.box().clock_unit()),
      measurements_(simulation_, std::numeric_limits<double>::infinity()) {}

template <int Dim, class Real>
TrialRun<Dim, Real>::TrialRun(TrialRun&&) noexcept = default;
template <int Dim, class Real>
TrialRun<Dim, Real>::~TrialRun() = default;

template <int Dim, class Real>
void TrialRun<Dim, Real>::go(const TrialEnd& end) {
  while (!is_over(end)) {
    if (const auto next = simulation_.collision_until(next_pause())) {
      observe(*next, end);
    } else if (is_quiet(next.error())) {
      if (next_pause() >= end_of_clock<Real>()) {
        ended_by_ = EndedBy::clock;
        break;
      }
      simulation_.wait_until(next_pause());
      if (simulation_.has_reached(driving_.next_kick())) {
        driving_.kick(simulation_, measurements_);
      }
    }
  }
  if (const auto& pair = simulation_.stopped_before()) separation_.observe_next(pair->gap);
  if (kept_) kept_->end = exactly_since_start(simulation_.now(), simulation_.box().clock_unit());
}

template <int Dim, class Real>
Bytes TrialRun<Dim, Real>::state() const {
  ArchiveWriter archive;
  simulation_.archive_to(archive);
  archive(driving_);
  return archive.release();
}

template <int Dim, class Real>
Trial TrialRun<Dim, Real>::trial() const {
  Trial trial;
  trial.precision = values_.collision.precision;
  trial.rule = values_.collision.overlap;
  trial.gap_threshold = values_.collapse.gap_threshold;
  trial.collisions = simulation_.collisions();
  trial.ended_by = ended_by_;
  trial.time = to_decimal(exactly_since_start(simulation_.now(), simulation_.box().clock_unit()));
  trial.hits = separation_.hits();
  trial.first_hit = separation_.first_collision();
  if (const auto& time = separation_.first_time()) trial.first_hit_time = to_decimal(*time);
  trial.last_hit = separation_.last_collision();
  trial.absorbed = absorbed_;
  trial.arrest = arrest_.collision();
  trial.deepest = deepest_;
  return trial;
}

template <int Dim, class Real>
void TrialRun<Dim, Real>::observe(const Collision<Dim, Real>& collision, const TrialEnd& end) {
  const std::int64_t hits = separation_.hits();
  separation_.observe(collision);
  arrest_.observe(collision);
  absorbed_ += collision.absorbed;
  // The start is not a state after a collision.
  const double depth = collision.number > 1 ? decades_of(collision.gap_before, limit_) : 0.0;
  const DepthRow row{collision.i, collision.j, depth, depth >= limit_};
  last_row_ = row;
  if (!row.at_limit) deepest_ = std::max(deepest_, row.depth);
  if (end.followed && row.depth >= least_approach_depth) {
    const bool is_followed = is_of(*end.followed, row);
    if (is_followed) last_deep_ = collision.number;
    // Within a decade of the limit a gap is a unit or two in the last place.
    (is_followed ? rows_at_limit_ : others_at_limit_) += row.depth >= limit_ - 1;
  }
  if (hit_groups_) {
    if (separation_.hits() > hits) hit_groups_->observe_hit(collision.number - 1, last_time_, row);
    hit_groups_->observe(collision.number, row);
    last_time_ = simulation_.time();
  }
  if (kept_) keep(row, collision);
}

template <int Dim, class Real>
void TrialRun<Dim, Real>::keep(const DepthRow& row, const Collision<Dim, Real>& collision) {
  if (kept_->rows.empty()) kept_->first_number = collision.number;
  kept_->rows.push_back(row);
  kept_->times.push_back(exactly_since_start(collision.time, simulation_.box().clock_unit()));
  const Real& speed = collision.impact.normal_speed;
  const bool loses = collision.impact.impulse < elastic_impulse(collision);
  kept_->dissipative.push_back(speed > 0 && (loses || collision.friction_loss > 0));
  fastest_ = std::max(fastest_, speed);
  kept_->margins.push_back(margin_of_curvature(collision));
}

/// The normal impulse that a collision without loss would have had.
template <int Dim, class Real>
Real TrialRun<Dim, Real>::elastic_impulse(const Collision<Dim, Real>& collision) const {
  const auto& grains = simulation_.grains();
  Real inverse_masses = grains.inverse_mass(collision.i);
  if (!simulation_.wall(collision.j)) inverse_masses += grains.inverse_mass(collision.j);
  return normal_impulse(collision.impact.normal_speed, Real(1), inverse_masses);
}

/// See Curvature; infinite at a wall, which is flat, and where the spheres slide no faster than the
/// rounding of the normals of the contacts before has made them.
template <int Dim, class Real>
double TrialRun<Dim, Real>::margin_of_curvature(const Collision<Dim, Real>& collision) const {
  const double none = std::numeric_limits<double>::infinity();
  const Vec<Dim, Real>& normal = collision.impact.normal;
  const Real& speed = collision.impact.normal_speed;
  if (Dim == 1 || simulation_.wall(collision.j) || !(speed > 0)) return none;
  auto sliding =
      simulation_.peculiar_velocity(collision.j) - simulation_.peculiar_velocity(collision.i);
  if constexpr (Dim > 1) {
    const auto& grains = simulation_.grains();
    const Real sigma = grains.radius(collision.i) + grains.radius(collision.j);
    sliding[0] += simulation_.box().shear_rate() * normal[1] * sigma;
  }
  sliding -= normal * dot(sliding, normal);
  Real longest = 0;
  for (int axis = 0; axis < Dim; ++axis)
    longest = std::max(longest, simulation_.box().sides()[axis]);
  const Real rounded = 4 * std::numeric_limits<Real>::epsilon() * longest * fastest_;
  if (!(dot(sliding, sliding) > rounded * rounded)) return none;
  const Real share = dot(sliding, sliding) * collision.gap_before / (speed * speed);
  return decades_of(share, none);
}

template <int Dim, class Real>
bool TrialRun<Dim, Real>::is_over(const TrialEnd& end) {
  ended_by_ = what_ends(end);
  return ended_by_.has_value();
}

template <int Dim, class Real>
std::optional<EndedBy> TrialRun<Dim, Real>::what_ends(const TrialEnd& end) {
  const auto now = std::chrono::steady_clock::now();
  if (end.on_look && now >= next_look_) {
    constexpr std::chrono::milliseconds between_looks(20);  // prompt for people
    end.on_look();
    next_look_ = now + between_looks;
  }
  if (end.interrupt && *end.interrupt) return EndedBy::interrupted;
  if (arrest_.is_met()) return EndedBy::arrest;
  if (const auto over = end_of_collisions(simulation_, driving_)) return over;
  if (simulation_.collisions() >= end.collisions) return EndedBy::collisions;
  if (const auto late = end_of_time(simulation_, values_)) return late;
  if (now > end.deadline) return EndedBy::budget;
  return end.followed ? what_ends(*end.followed) : std::nullopt;
}

/// Whether the digits of a followed group are spent, or its spheres have long flown apart: a
/// thousand collisions without a small gap, and a tenth of the time between two collisions of a
/// sphere behind the last hit of the run.
template <int Dim, class Real>
std::optional<EndedBy> TrialRun<Dim, Real>::what_ends(const HitGroup& followed) const {
  constexpr std::int64_t enough_at_limit = 32;
  constexpr std::int64_t many_at_limit = 1000;  // more than contacts by chance or symmetry
  constexpr std::int64_t quiet_collisions = 1000;
  if (rows_at_limit_ >= enough_at_limit) return EndedBy::digits;
  if (others_at_limit_ >= many_at_limit) return EndedBy::others;
  const std::int64_t last = std::max(last_deep_, followed.first_hit);
  if (simulation_.collisions() <= last + quiet_collisions) return std::nullopt;
  const double between = mean_time_between_collisions(followed, spheres());
  if (simulation_.time() > followed.last_time + between / 10) return EndedBy::apart;
  return std::nullopt;
}

template <int Dim, class Real>
double TrialRun<Dim, Real>::next_pause() const {
  return std::min(last_moment<Real>(values_), driving_.next_kick());
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class TrialRun<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
