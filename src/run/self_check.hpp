#pragma once

#include <optional>
#include <string>

#include "engine/simulation.hpp"
#include "flow/measurements.hpp"
#include "model/archive.hpp"
#include "model/overlap_rule.hpp"
#include "text/printable.hpp"

namespace zenosphere {

/// Looks whether a run still obeys what must hold in every run, often enough to lose little and
/// seldom enough to cost little (below 1 % of the time).
///
/// Each collision: the clock goes forward, but for what the overlap rule permits. From time to
/// time: all numbers are finite, momentum is kept where nothing takes it up, the energy ledger is
/// closed, spheres are between the walls and not in each other.
template <int Dim, class Real>
class SelfCheck {
 public:
  /// \param simulation  at its start; the same object is handed to every later call
  explicit SelfCheck(const Simulation<Dim, Real>& simulation);

  /// To be called once after each collision, in order.
  void observe(const Collision<Dim, Real>& collision, const Simulation<Dim, Real>& simulation) {
    if (collision.flight >= -clock_rounding_) return;
    const Real rounding =
        clock_rounding_ * Real(simulation.stride());  // of what the clock counts in
    if (collision.flight >= -rounding) return;
    const bool is_rewind = collision.overlapping &&
                           simulation.rules().overlap == OverlapRule::rewind &&
                           -collision.flight <= simulation.longest_rewind() + rounding &&
                           collision.time.remainder >= simulation.earliest_rewind();
    if (!is_rewind && !violation_) note_disorder(collision);
  }

  /// Whether it is time to look at the whole state.
  bool is_due(const Simulation<Dim, Real>& simulation) const {
    return simulation.collisions() >= next_look_;
  }

  /// Looks at the whole state now: costs about as much as some hundred collisions a sphere.
  void look(const Simulation<Dim, Real>& simulation, const Measurements<Dim, Real>& measurements);

  /// \throws ArchiveError for a finding in other letters than `note` writes
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    // The tolerances too: a run that goes on in more digits keeps the rounding of those before.
    archive(self.clock_rounding_, self.gathered_rounding_, self.momentum_at_start_,
            self.momentum_scale_, self.next_look_, self.violation_);
    require_archived(!self.violation_ || is_plain(*self.violation_), "a finding that is no text");
  }

  /// What was found, for people, or nothing. The first finding stays.
  const std::optional<std::string>& violation() const { return violation_; }

 private:
  using Vector = Vec<Dim, Real>;

  void note(std::int64_t collision, const std::string& text);
  void note_disorder(const Collision<Dim, Real>& collision);
  void look_at_momentum(const Simulation<Dim, Real>& simulation);
  void look_at_places(const Simulation<Dim, Real>& simulation);
  /// The speeds that are rounded, summed up: under shear they have the profile of a layer in them,
  /// which may be far above those of the spheres among each other.
  Real speeds_with_profile(const Simulation<Dim, Real>& simulation) const;
  Vector expected_momentum(const Simulation<Dim, Real>& simulation) const;
  void look_at_overlaps(const Simulation<Dim, Real>& simulation,
                        const Configuration<Dim, Real>& state);

  Real clock_rounding_;  ///< of a clock that counts in single units, time
  Real gathered_rounding_;
  Vector momentum_at_start_;
  Real momentum_scale_ = 0;  ///< largest sum of |v| so far
  std::int64_t next_look_ = 0;
  std::optional<std::string> violation_;
};

}  // namespace zenosphere
