#include "engine/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/time_apart.hpp"
#include "engine/time_apart_sheared.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Whether two spheres that fly straight may meet in some image: not where they are apart across
/// the axes along which they move, for good. Along several axes at once they come close one day.
/// Under shear all images but one move along x, and there they may lie anywhere in a box whose
/// images are displaced.
template <int Dim, class Real>
bool may_meet(const System<Dim, Real>& system, std::int32_t i, std::int32_t j) {
  const Vec<Dim, Real> velocity = system.spheres[j].velocity - system.spheres[i].velocity;
  const bool is_one_frame = !system.box().is_sheared() || system.spheres.share_layer(i, j);
  if (velocity == Vec<Dim, Real>{} && is_one_frame) return false;
  Vec<Dim, Real> across = system.spheres.sliding_box().shortest_image(
      system.spheres.position_at(j, system.clock.remainder()) -
          system.spheres.position_at(i, system.clock.remainder()),
      system.clock.remainder());
  for (int axis = 0; axis < Dim; ++axis) {
    const bool is_displaced =
        system.box().is_sheared() || system.spheres.sliding_box().has_displaced_images();
    if (velocity[axis] != 0 || (axis == 0 && is_displaced)) across[axis] = 0;
  }
  const Real margin = approach_margin;
  const Real sigma = system.spheres.sigma(i, j);
  return dot(across, across) < sigma * sigma + margin;
}

/// How sphere i sees sphere j in the laboratory.
template <int Dim, class Real>
ShearedFlight<Dim> flight_between(const Configuration<Dim, Real>& state, std::size_t i,
                                  std::size_t j, const ShearBox<Dim, Real>& box) {
  const Vec<Dim, Real> displacement = state.positions[j] - state.positions[i];
  Vec<Dim, Real> velocity = state.velocities[j] - state.velocities[i];  // peculiar
  velocity[0] += box.shear_rate() * displacement[1];
  ShearedFlight<Dim> flight{};
  for (int axis = 0; axis < Dim; ++axis) {
    flight.displacement[axis] = static_cast<double>(displacement[axis]);
    flight.velocity[axis] = static_cast<double>(velocity[axis]);
    flight.sides[static_cast<std::size_t>(axis)] = static_cast<double>(box.sides()[axis]);
  }
  flight.slide = static_cast<double>(box.shear_rate() * box.sides()[1]);
  return flight;
}

}  // namespace

template <int Dim, class Real>
bool move_as_one(const System<Dim, Real>& system) {
  using std::abs;
  const Vec<Dim, Real>& first = system.spheres[0].velocity;
  for (int axis = 0; axis < Dim; ++axis) {
    if (!system.frame.is_free(axis) && first[axis] != 0) return false;
    const Real rounding = 2 * std::numeric_limits<Real>::epsilon() * abs(first[axis]);
    for (std::int32_t i = 1; i < system.count(); ++i) {
      if (abs(system.spheres[i].velocity[axis] - first[axis]) > rounding) return false;
    }
  }
  return true;
}

template <int Dim, class Real>
Real fastest_beside(const System<Dim, Real>& system, const Vec<Dim, Real>& velocity) {
  using std::abs;
  Real fastest = 0;
  for (std::int32_t i = 0; i < system.count(); ++i) {
    const Vec<Dim, Real> relative = system.spheres[i].velocity - velocity;
    for (int axis = 0; axis < Dim; ++axis) {
      if (system.frame.is_free(axis)) fastest = std::max(fastest, Real(abs(relative[axis])));
    }
  }
  return fastest;
}

template <int Dim, class Real>
bool never_meet(const System<Dim, Real>& system) {
  if (system.count() > most_in_pairs) return false;
  for (std::int32_t i = 0; i < system.count(); ++i) {
    if (const auto axis = system.box().closed_axis();
        axis && system.spheres[i].velocity[*axis] != 0)
      return false;
    for (std::int32_t j = 0; j < i; ++j) {
      if (may_meet(system, i, j)) return false;
    }
  }
  return true;
}

template <int Dim, class Real>
bool stay_apart_sheared(const System<Dim, Real>& system, double time) {
  if constexpr (Dim == 1) {
    return false;
  } else {
    const Configuration<Dim, Real> state = system.configuration();
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        ShearedFlight<Dim> flight = flight_between(state, i, j, system.box());
        flight.offset = static_cast<double>(system.lees_edwards_offset());
        if (time_apart_sheared(flight, time) < time) return false;
      }
    }
    return true;
  }
}

template <int Dim, class Real>
Real certainly_apart(const System<Dim, Real>& system, const Real& most, const Real& least) {
  const Real fastest = system.speed(system.fastest());
  Real apart = most;
  const int pairs = system.count() * (system.count() - 1) / 2;
  const int searches = std::max(8, 4096 / std::max(pairs, 1));
  StraightFlight<Dim> flight{};
  flight.speed = 1;  // in units of the fastest
  for (int axis = 0; axis < Dim; ++axis) {
    flight.periods[static_cast<std::size_t>(axis)] =
        system.box().is_closed(axis) ? std::numeric_limits<double>::infinity()
                                     : static_cast<double>(system.box().sides()[axis]);
  }
  for (std::int32_t i = 0; i < system.count(); ++i) {
    for (std::int32_t j = 0; j < i && apart > least; ++j) {
      const Vec<Dim, Real> displacement = system.spheres.position_at(j, system.clock.remainder()) -
                                          system.spheres.position_at(i, system.clock.remainder());
      const Vec<Dim, Real> velocity = system.spheres.velocity_at(j, system.clock.remainder()) -
                                      system.spheres.velocity_at(i, system.clock.remainder());
      for (int axis = 0; axis < Dim; ++axis) {
        flight.displacement[axis] = static_cast<double>(displacement[axis]);
        flight.velocity[axis] = static_cast<double>(Real(velocity[axis] / fastest));
      }
      const auto until = static_cast<double>(Real(apart * fastest));
      apart = std::min(apart, Real(Real(time_apart(flight, until, searches)) / fastest));
    }
  }
  return apart;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                        \
  template bool move_as_one(const System<Dim, Real>&);                           \
  template Real fastest_beside(const System<Dim, Real>&, const Vec<Dim, Real>&); \
  template bool never_meet(const System<Dim, Real>&);                            \
  template bool stay_apart_sheared(const System<Dim, Real>&, double);            \
  template Real certainly_apart(const System<Dim, Real>&, const Real&, const Real&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
