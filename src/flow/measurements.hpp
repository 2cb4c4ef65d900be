#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/simulation.hpp"
#include "flow/averages.hpp"
#include "flow/observable_series.hpp"
#include "flow/streaks.hpp"
#include "model/average_start.hpp"

namespace zenosphere {

/// Exact time averages and the energy ledger of a run, from its stream of collisions.
///
/// Between two collisions of a sphere its peculiar velocity changes at a constant rate: that of
/// gravity, and -shear_rate v_y along x. So the integrals over each flight are closed formulas, and
/// nothing depends on a sampling interval.
///
/// Source of the pressure tensor: Irving & Kirkwood, J. Chem. Phys. 18 (1950) 817; for hard
/// spheres Alder, Gass & Wainwright, J. Chem. Phys. 53 (1970) 3813.
template <int Dim, class Real>
class Measurements {
 public:
  using Vector = Vec<Dim, Real>;

  /// \param simulation  at its start; the same object is handed to every later call
  /// \param after_time  when averages start, in the case's time unit
  /// \param interval    of the series, time; 0: a power of two, some collisions of each sphere
  Measurements(const Simulation<Dim, Real>& simulation, AverageStart after_time,
               double interval = 0);

  /// Has what is kept of the spheres prefetched, from now on; only the speed depends on it.
  void prefetch_with(Simulation<Dim, Real>& simulation) const {
    simulation.prefetch_too(flight_start_.data(), sizeof flight_start_.front());
  }

  /// To be called once after each collision, in order.
  void observe(const Collision<Dim, Real>& collision, const Simulation<Dim, Real>& simulation);

  /// Changes the velocity of every sphere through `simulation.kick(changes)`, with the work of the
  /// kicks booked.
  void kick(Simulation<Dim, Real>& simulation, const std::vector<Vector>& changes);

  /// Mobile spheres of each kind.
  const std::vector<std::int64_t>& mobile_of_kind() const { return mobile_of_kind_; }

  /// Averages from `after_time` to the simulation's clock, or nothing if that span is empty. Their
  /// errors come from the intervals of the series that lie in it as a whole.
  std::optional<Averages> averages(const Simulation<Dim, Real>& simulation) const;

  /// Averages over the intervals that have ended by now.
  ObservableSeries series(const Simulation<Dim, Real>& simulation) const;

  /// | kinetic energy change - work + dissipation |, relative to the largest of the terms; the work
  /// is that of the shear, of gravity, of moving walls and of kicks.
  ///
  /// The kinetic energy is that of the engine, the work that of the integrals above.
  double ledger_error(const Simulation<Dim, Real>& simulation) const;

  /// \throws ArchiveError for the sums of another number of spheres
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    const std::size_t spheres = self.flight_start_.size();
    const Sums& sums = self.sums_;
    const std::size_t kinds = sums.kinetic_of_kind.size();
    const std::size_t turning = sums.turning_of_kind.size();
    archive(self.initial_energy_, self.sums_, self.sums_before_, self.flight_start_,
            self.sums_at_end_, self.series_, self.next_look_);
    require_archived(self.flight_start_.size() == spheres, "sums of another number of spheres");
    require_archived(sums.kinetic_of_kind.size() == kinds && sums.turning_of_kind.size() == turning,
                     "sums of other kinds of spheres");
    require_archived(self.sums_at_end_.kinetic_of_kind.size() == kinds &&
                         self.sums_at_end_.turning_of_kind.size() == turning,
                     "sums of other kinds of spheres");
    if (!self.sums_before_) return;
    require_archived(self.sums_before_->kinetic_of_kind.size() == kinds &&
                         self.sums_before_->turning_of_kind.size() == turning,
                     "sums of other kinds of spheres");
  }

 private:
  struct Sums {
    std::array<Real, Dim * Dim> kinetic{};      ///< time integral of sum m v_a v_b
    std::array<Real, Dim * Dim> collisional{};  ///< sum of r_a J_b
    std::array<Real, 2> wall_impulse{};         ///< normal to the lower and the upper wall
    Real gravity_work = 0;
    std::array<Real, 2> work_of_wall{};  ///< of the lower and the upper one
    Real wall_work = 0;                  ///< of both, and of immobile spheres
    Real kick_work = 0;
    Real dissipation = 0;
    Real normal_speed = 0;
    std::int64_t collisions = 0;
    std::vector<Real> kinetic_of_kind{};  ///< time integral of sum m v^2; where there are several
    std::vector<Real> turning_of_kind{};  ///< time integral of sum I w^2; where spheres turn

    template <class Self, class Archive>
    static void archive_state(Self& self, Archive& archive) {
      archive(self.kinetic, self.collisional, self.wall_impulse, self.gravity_work,
              self.work_of_wall, self.wall_work, self.kick_work, self.dissipation,
              self.normal_speed, self.collisions, self.kinetic_of_kind, self.turning_of_kind);
      require_counts(self.collisions);
    }
  };

  /// What counts of a flight.
  struct Flight {
    Vector mean;    ///< of the peculiar velocity
    Vector change;  ///< of it
    Real weight;    ///< mass x duration
  };

  // Some are inlined where GCC would call them, for each collision: to hand vectors over in memory
  // takes longer than to add them up.
  void look(const Simulation<Dim, Real>& simulation, const Collision<Dim, Real>* collision);
  void start_averages(const Simulation<Dim, Real>& simulation,
                      const Collision<Dim, Real>* collision);
  void end_intervals(ObservableSeries& series, Sums& sums_at_end,
                     const Simulation<Dim, Real>& simulation,
                     const Collision<Dim, Real>* collision) const;
  void choose_interval(const Simulation<Dim, Real>& simulation);
  std::optional<Averages> averages_of_steady_state(const Simulation<Dim, Real>& simulation) const;
  Inertia inertia(const Simulation<Dim, Real>& simulation) const;
  Observables observables(const Sums& before, const Sums& now, const Real& span,
                          const Simulation<Dim, Real>& simulation) const;
  void observe_pair(const Collision<Dim, Real>& collision, const Simulation<Dim, Real>& simulation);
  [[gnu::always_inline]] inline void end_flight(std::int32_t sphere,
                                                const Collision<Dim, Real>& collision,
                                                const Simulation<Dim, Real>& simulation);
  void add_contact(const Collision<Dim, Real>& collision);
  void add_unlike_loss(const Collision<Dim, Real>& collision,
                       const Simulation<Dim, Real>& simulation);
  void add_wall_contact(const Collision<Dim, Real>& collision, int wall,
                        const Simulation<Dim, Real>& simulation);
  [[gnu::always_inline]] inline void add_transfer(const Impact<Dim, Real>& impact,
                                                  const Vector& momentum);
  [[gnu::always_inline]] inline Flight flight(const Vector& velocity_at_end, const Real& duration,
                                              const Real& weight) const;
  template <std::size_t Count>
  [[gnu::always_inline]] inline void add(Sums& sums,
                                         const std::array<Flight, Count>& flights) const;
  void add_unlike_flight(Sums& sums, std::int32_t sphere, const Vector& velocity_at_end,
                         const Spin<Dim, Real>& spin, const Real& duration,
                         const Simulation<Dim, Real>& simulation) const;
  Spin<Dim, Real> spin_before(std::int32_t sphere, const Collision<Dim, Real>* collision,
                              const Simulation<Dim, Real>& simulation) const;
  Real twice_turning_energy(std::int32_t sphere, const Spin<Dim, Real>& spin,
                            const Simulation<Dim, Real>& simulation) const;
  void add_temperatures(Observables& averages, const Sums& sums, const Sums& before,
                        const Real& span) const;
  void add_flights_until(Sums& sums, const Instant<Real>& end,
                         const Simulation<Dim, Real>& simulation,
                         const Collision<Dim, Real>* collision) const;
  Vector velocity_at(const Real& ahead, std::int32_t sphere, const Collision<Dim, Real>* collision,
                     const Simulation<Dim, Real>& simulation) const;
  double sonine_a2_at(const Instant<Real>& end, const Simulation<Dim, Real>& simulation,
                      const Collision<Dim, Real>* collision) const;
  Sums sums_now(const Simulation<Dim, Real>& simulation) const;
  Real shear_work(const Sums& sums) const;
  Real kinetic_energy(const Simulation<Dim, Real>& simulation) const;
  [[gnu::always_inline]] inline Vector velocity_before(
      std::int32_t sphere, const Collision<Dim, Real>& collision,
      const Simulation<Dim, Real>& simulation) const;

  Real shear_rate_;
  Vector acceleration_;
  bool falls_;       ///< the acceleration is not zero
  bool are_unlike_;  ///< spheres have masses of their own, or turn
  std::vector<std::int64_t> mobile_of_kind_;
  std::int64_t mobile_ = 0;
  Real clock_unit_;
  bool is_start_found_;  ///< after the fact, in the series
  double after_time_;    ///< infinity where it is
  Instant<Real> after_;
  Real initial_energy_;
  Sums sums_;
  std::optional<Sums> sums_before_;  ///< at `after_time`
  std::vector<Instant<Real>> flight_start_;
  Sums sums_at_end_;  ///< of the last interval
  ObservableSeries series_;
  Instant<Real> next_look_;  ///< when the averages start or an interval ends, the earlier of both
};

}  // namespace zenosphere
