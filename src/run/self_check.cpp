#include "run/self_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "flow/overlaps.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {
namespace {

/// A look costs as much as up to 1000 collisions of one sphere; so a per cent of the time at most
/// goes there, and a run of few spheres is not looked at all the time.
constexpr std::int64_t least_collisions_between = 65536;
constexpr std::int64_t collisions_between_per_sphere = 1000;

/// Relative rounding that sums over a long run may gather, in units of the last place: 1e-8 in
/// double. The longest runs seen stay below 1e-11; a pair lost or an image mistaken costs 1e-4.
template <class Real>
Real gathered_rounding() {
  return Real(4.5e7) * std::numeric_limits<Real>::epsilon();
}

/// Mass of a sphere, of an immobile one 0: it has no momentum that could change.
template <class Real>
Real mobile_mass(const Grains<Real>& grains, std::int32_t i) {
  return grains.is_immobile(i) ? Real(0) : grains.mass(i);
}

template <int Dim, class Real>
Real total_mass(const Simulation<Dim, Real>& simulation) {
  if (simulation.grains().are_alike()) return Real(simulation.spheres());
  Real sum = 0;
  for (std::int32_t i = 0; i < simulation.spheres(); ++i)
    sum += mobile_mass(simulation.grains(), i);
  return sum;
}

/// Whether something takes up momentum: walls, or spheres that keep their velocity.
template <int Dim, class Real>
bool has_sinks(const Simulation<Dim, Real>& simulation) {
  return simulation.box().closed_axis().has_value() || !simulation.grains().immobile.empty();
}

/// Sum of the momenta, and of their components' sizes.
template <int Dim, class Real>
std::pair<Vec<Dim, Real>, Real> momentum_of(const Simulation<Dim, Real>& simulation) {
  using std::abs;
  Vec<Dim, Real> sum;
  Real scale = 0;
  for (std::int32_t i = 0; i < simulation.spheres(); ++i) {
    auto momentum = simulation.peculiar_velocity(i);
    if (!simulation.grains().are_alike()) momentum *= mobile_mass(simulation.grains(), i);
    sum += momentum;
    for (int axis = 0; axis < Dim; ++axis) scale += abs(momentum[axis]);
  }
  return {sum, scale};
}

}  // namespace

template <int Dim, class Real>
SelfCheck<Dim, Real>::SelfCheck(const Simulation<Dim, Real>& simulation)
    : clock_rounding_(4096 * std::numeric_limits<Real>::epsilon() * simulation.box().clock_unit()),
      gathered_rounding_(gathered_rounding<Real>()) {
  std::tie(momentum_at_start_, momentum_scale_) = momentum_of(simulation);
  next_look_ = std::max(least_collisions_between,
                        collisions_between_per_sphere * std::int64_t{simulation.spheres()});
}

template <int Dim, class Real>
void SelfCheck<Dim, Real>::look(const Simulation<Dim, Real>& simulation,
                                const Measurements<Dim, Real>& measurements) {
  next_look_ = simulation.collisions() +
               std::max(least_collisions_between,
                        collisions_between_per_sphere * std::int64_t{simulation.spheres()});
  look_at_momentum(simulation);
  const double ledger = measurements.ledger_error(simulation);
  const Real rounding = gathered_rounding_ * speeds_with_profile(simulation) / momentum_scale_;
  if (!(ledger <= static_cast<double>(rounding)) && momentum_scale_ > 0) {
    note(simulation.collisions(),
         fmt::format("the energy ledger is open by {:.3g} of its largest term", ledger));
  }
  look_at_places(simulation);
}

template <int Dim, class Real>
void SelfCheck<Dim, Real>::note(std::int64_t collision, const std::string& text) {
  if (violation_) return;
  violation_ = fmt::format(
      "after collision {}: {} (this cannot be right, whatever the case); everything up to here is "
      "saved, please report it with the case",
      collision, text);
}

template <int Dim, class Real>
void SelfCheck<Dim, Real>::note_disorder(const Collision<Dim, Real>& collision) {
  note(collision.number,
       fmt::format("the clock went {:.3g} forward between spheres {} and {}",
                   static_cast<double>(collision.flight), collision.i, collision.j));
}

/// The momentum that gravity and the profile make of that of the start.
template <int Dim, class Real>
Vec<Dim, Real> SelfCheck<Dim, Real>::expected_momentum(
    const Simulation<Dim, Real>& simulation) const {
  const auto& box = simulation.box();
  const Real time = elapsed(Instant<Real>{}, simulation.now(), box.clock_unit());
  const Vector pull = simulation.surroundings().acceleration * total_mass(simulation);
  Vector expected = momentum_at_start_ + pull * time;
  if constexpr (Dim > 1) {
    expected[0] -= box.shear_rate() * time * (momentum_at_start_[1] + pull[1] * time / 2);
  }
  return expected;
}

template <int Dim, class Real>
Real SelfCheck<Dim, Real>::speeds_with_profile(const Simulation<Dim, Real>& simulation) const {
  return momentum_scale_ + simulation.box().slide_speed() * total_mass(simulation);
}

template <int Dim, class Real>
void SelfCheck<Dim, Real>::look_at_momentum(const Simulation<Dim, Real>& simulation) {
  using std::abs;
  const auto [momentum, scale] = momentum_of(simulation);
  momentum_scale_ = std::max(momentum_scale_, scale);
  const Vector expected = expected_momentum(simulation);
  const Real rounding = gathered_rounding_ * speeds_with_profile(simulation);
  for (int axis = 0; axis < Dim; ++axis) {
    const Real change = abs(momentum[axis] - expected[axis]);
    if (has_sinks(simulation) || change <= rounding) continue;
    note(
        simulation.collisions(),
        fmt::format("momentum along axis {} has changed by {:.3g}, of speeds that sum up to {:.3g}",
                    axis, static_cast<double>(change), static_cast<double>(momentum_scale_)));
  }
}

template <int Dim, class Real>
void SelfCheck<Dim, Real>::look_at_places(const Simulation<Dim, Real>& simulation) {
  const Configuration<Dim, Real> state = simulation.configuration();
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    for (int axis = 0; axis < Dim; ++axis) {
      const auto position = static_cast<double>(state.positions[i][axis]);
      const auto velocity = static_cast<double>(state.velocities[i][axis]);
      if (std::isfinite(position) && std::isfinite(velocity)) continue;
      note(simulation.collisions(), fmt::format("sphere {} is at {} with velocity {} along axis {}",
                                                i, position, velocity, axis));
      return;  // what follows needs numbers
    }
  }
  look_at_overlaps(simulation, state);
}

template <int Dim, class Real>
void SelfCheck<Dim, Real>::look_at_overlaps(const Simulation<Dim, Real>& simulation,
                                            const Configuration<Dim, Real>& state) {
  PlacedSpheres spheres{.positions = {},
                        .sides = {},
                        .offset = static_cast<double>(simulation.lees_edwards_offset()),
                        .closed = simulation.box().closed_axis(),
                        .diameters = {},
                        .immobile = state.grains.immobile};
  for (const Real& diameter : state.grains.diameters) {
    spheres.diameters.push_back(static_cast<double>(diameter));
  }
  for (int axis = 0; axis < Dim; ++axis) {
    spheres.sides.push_back(static_cast<double>(simulation.box().sides()[axis]));
  }
  for (const Vector& position : state.positions) {
    for (int axis = 0; axis < Dim; ++axis) {
      spheres.positions.push_back(static_cast<double>(position[axis]));
    }
  }
  const double permitted = deepest_permitted(
      simulation.rules().overlap, static_cast<double>(simulation.rules().guard), simulation.time(),
      *std::max_element(spheres.sides.begin(), spheres.sides.end()),
      static_cast<double>(state.grains.largest_diameter()));
  const Overlap overlap = deepest_overlap(spheres);
  if (overlap.depth > permitted) {
    note(
        simulation.collisions(),
        fmt::format("spheres {} and {} overlap by {:.3g} diameters, at most {:.3g} can be rounding",
                    overlap.i, overlap.j, overlap.depth, permitted));
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class SelfCheck<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
