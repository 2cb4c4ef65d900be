#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "collapse/arrest_criterion.hpp"
#include "collapse/separation_criterion.hpp"
#include "flow/measurements.hpp"
#include "result/adjudication.hpp"
#include "run/cluster_gaps.hpp"
#include "run/hit_groups.hpp"
#include "run/kept_collisions.hpp"
#include "run/random_driving.hpp"
#include "run/setup.hpp"

namespace zenosphere {

/// What ends a trial besides its case.
struct TrialEnd {
  std::int64_t collisions = std::numeric_limits<std::int64_t>::max();
  std::optional<HitGroup> followed{};  ///< until its digits are spent, or it has flown apart
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void()> on_look{};  ///< called some times a second; may set the interrupt
};

/// The case of a trial: another precision, with its threshold, and another rule.
Case case_of_trial(Case values, Precision precision, OverlapRule rule);

/// A run that is watched by the criteria and recorded nowhere.
template <int Dim, class Real>
class TrialRun {
 public:
  /// From the start of the case. Throws InputError where that cannot be made.
  explicit TrialRun(const Case& values);

  /// Goes on from the state that `state()` gave, perhaps in fewer digits.
  TrialRun(const Case& values, ArchiveReader& archive);

  TrialRun(TrialRun&&) noexcept;  // these two compiled once, as those of a simulation
  ~TrialRun();

  /// Goes on until the end, or as its case has it.
  void go(const TrialEnd& end);

  /// The state of the engine and of what drives it.
  Bytes state() const;

  std::int32_t spheres() const { return simulation_.spheres(); }
  std::int64_t collisions() const { return simulation_.collisions(); }
  std::int64_t hits() const { return separation_.hits(); }
  const ArrestCriterion<Dim, Real>& arrest() const { return arrest_; }
  std::optional<EndedBy> ended_by() const { return ended_by_; }
  /// The collision observed last, after one.
  const DepthRow& last_row() const { return last_row_; }
  /// Where the spheres are now.
  ClusterGaps<Dim, Real> gaps() const { return ClusterGaps<Dim, Real>(simulation_); }
  Trial trial() const;

  /// Decades of the resolution of Real: gaps below it are rounding.
  double limit() const { return limit_; }

  /// Keeps every collision from now on.
  void keep_collisions() { kept_.emplace(); }
  const KeptCollisions<Real>& kept() const { return *kept_; }

  /// Gathers the hits from now on.
  void gather_hits() { hit_groups_.emplace(spheres()); }
  std::vector<HitGroup> hit_groups() const { return hit_groups_->groups(); }

 private:
  TrialRun(const Case& values, Simulation<Dim, Real> simulation);

  void observe(const Collision<Dim, Real>& collision, const TrialEnd& end);
  void keep(const DepthRow& row, const Collision<Dim, Real>& collision);
  Real elastic_impulse(const Collision<Dim, Real>& collision) const;
  double margin_of_curvature(const Collision<Dim, Real>& collision) const;
  bool is_over(const TrialEnd& end);
  std::optional<EndedBy> what_ends(const TrialEnd& end);
  std::optional<EndedBy> what_ends(const HitGroup& followed) const;
  double next_pause() const;

  Case values_;
  double limit_;
  Simulation<Dim, Real> simulation_;
  RandomDriving<Dim, Real> driving_;
  SeparationCriterion<Dim, Real> separation_;
  ArrestCriterion<Dim, Real> arrest_;
  Measurements<Dim, Real> measurements_;
  std::int64_t absorbed_ = 0;
  double deepest_ = 0;    ///< decades
  double last_time_ = 0;  ///< of the last collision
  std::optional<EndedBy> ended_by_;
  DepthRow last_row_;
  std::int64_t last_deep_ = 0;  ///< collision of the followed spheres
  std::chrono::steady_clock::time_point next_look_{};
  std::int64_t rows_at_limit_ = 0;    ///< likewise
  std::int64_t others_at_limit_ = 0;  ///< of other spheres
  std::optional<HitGroups> hit_groups_;
  std::optional<KeptCollisions<Real>> kept_;
  Real fastest_ = 0;  ///< closing speed among them
};

}  // namespace zenosphere
