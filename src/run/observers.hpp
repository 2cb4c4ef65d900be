#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "collapse/arrest_criterion.hpp"
#include "collapse/collapse_time.hpp"
#include "collapse/dissector.hpp"
#include "collapse/separation_criterion.hpp"
#include "flow/measurements.hpp"
#include "result/summary.hpp"
#include "run/collision_counts.hpp"
#include "run/self_check.hpp"
#include "run/setup.hpp"

namespace zenosphere {

/// Everything that watches a run and goes into its summary.
template <int Dim, class Real>
class Observers {
 public:
  /// \param simulation  at its start; the same object is handed to every later call
  Observers(const Case& values, const Simulation<Dim, Real>& simulation)
      : constant_restitution_(values.system.restitution),
        separation_(values.collapse.gap_threshold.template in<Real>(),
                    simulation.box().clock_unit()),
        arrest_(values.collapse.gap_threshold.template in<Real>(), values.collapse.window,
                simulation.box().clock_unit()),
        collapse_time_(simulation.box().clock_unit()),
        dissector_(values.collapse.gap_threshold.template in<Real>(), simulation.spheres(),
                   simulation.box().clock_unit(), constant_restitution(values)),
        measurements_(simulation, values.measure.after_time, values.measure.interval.value_or(0)),
        self_check_(simulation) {}

  /// To be called once after each collision, in order.
  void observe(const Collision<Dim, Real>& collision, const Simulation<Dim, Real>& simulation) {
    separation_.observe(collision);
    arrest_.observe(collision);
    collapse_time_.observe(collision);
    dissector_.observe(collision);
    if (arrest_.is_met()) dissector_.observe_arrest(arrest_.pairs());
    measurements_.observe(collision, simulation);
    self_check_.observe(collision, simulation);
    counts_.observe(collision);
    if (self_check_.is_due(simulation)) look(simulation);
  }

  /// The pair that would have collided next and its gap at the last collision.
  void observe_next(std::int32_t i, std::int32_t j, const Real& gap) {
    separation_.observe_next(gap);
    dissector_.observe_next({i, j}, gap);
  }

  /// Looks at the whole state now for what cannot be right.
  void look(const Simulation<Dim, Real>& simulation) {
    self_check_.look(simulation, measurements_);
  }

  bool has_arrested() const { return arrest_.is_met(); }
  bool has_violation() const { return self_check_.violation().has_value(); }
  std::int64_t hits() const { return separation_.hits(); }
  const Anatomy& anatomy() const { return dissector_.anatomy(); }
  Measurements<Dim, Real>& measurements() { return measurements_; }
  const Measurements<Dim, Real>& measurements() const { return measurements_; }

  /// What has been seen so far; the rest of the summary is left as it is, the verdict too.
  void add_to(Summary& summary, const Simulation<Dim, Real>& simulation) const {
    summary.collisions = simulation.collisions();
    summary.collisions_per_sphere =
        2 * static_cast<double>(summary.collisions) / static_cast<double>(simulation.spheres());
    summary.time = simulation.time();
    summary.strain = static_cast<double>(simulation.box().shear_rate()) * summary.time;
    add_collapse(summary, simulation);
    summary.absorbed = counts_.absorbed;
    summary.overlap_collisions = counts_.overlapping;
    summary.overlaps_ignored = simulation.overlaps_ignored();
    summary.receding = counts_.receding;
    summary.contact = contact(simulation);
    summary.anatomy = in_short(dissector_.anatomy());
    summary.averages = measurements_.averages(simulation);
    summary.ledger_error = measurements_.ledger_error(simulation);
    summary.self_check = self_check_.violation();
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.separation_, self.arrest_, self.collapse_time_, self.dissector_,
            self.measurements_, self.counts_, self.self_check_);
  }

 private:
  void add_collapse(Summary& summary, const Simulation<Dim, Real>& simulation) const {
    summary.separation = separation_.result();
    summary.arrest = {arrest_.is_met(),
                      arrest_.collision(),
                      arrest_.time(),
                      arrest_.window(),
                      {},
                      in_double(collapse_time_.time()),
                      in_double(collapse_time_.ratio()),
                      std::nullopt};
    for (const auto& [i, j] : arrest_.pairs()) summary.arrest.pairs.emplace_back(i, j);
    if (arrest_.is_met()) summary.arrest.others_moving = others_moving(simulation);
  }

  /// Spheres that move and are in none of the pairs that arrest.
  std::int64_t others_moving(const Simulation<Dim, Real>& simulation) const {
    std::vector<char> is_arrested(static_cast<std::size_t>(simulation.spheres()) + 2);  // and walls
    for (const auto& [i, j] : arrest_.pairs()) {
      is_arrested[static_cast<std::size_t>(i)] = is_arrested[static_cast<std::size_t>(j)] = 1;
    }
    std::int64_t moving = 0;
    for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
      const bool rests = simulation.peculiar_velocity(i) == Vec<Dim, Real>{};
      moving += !is_arrested[static_cast<std::size_t>(i)] && !rests;
    }
    return moving;
  }

  Summary::Contact contact(const Simulation<Dim, Real>& simulation) const {
    const auto counts = simulation.contact_counts();
    if (!counts) return {constant_restitution_, 0, 0};
    Summary::Contact contact{std::nullopt, counts->made_elastic, counts->rotated};
    if (counts->collisions > 0) contact.mean_restitution = counts->mean_restitution;
    return contact;
  }

  static std::optional<double> in_double(const std::optional<Real>& number) {
    return number ? std::optional<double>(static_cast<double>(*number)) : std::nullopt;
  }

  double constant_restitution_;
  SeparationCriterion<Dim, Real> separation_;
  ArrestCriterion<Dim, Real> arrest_;
  CollapseTime<Dim, Real> collapse_time_;
  Dissector<Dim, Real> dissector_;
  Measurements<Dim, Real> measurements_;
  SelfCheck<Dim, Real> self_check_;
  CollisionCounts counts_;
};

}  // namespace zenosphere
