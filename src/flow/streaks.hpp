#pragma once

#include <array>
#include <vector>

#include "engine/simulation.hpp"
#include "flow/averages.hpp"

namespace zenosphere {

/// A streak: a wave of the velocity along the flow whose crests lie along it too.
struct StreakMode {
  int gradient;   ///< periods along y
  int vorticity;  ///< periods along z
};

/// The longest waves that fit into a box: along y, along z and along both diagonals.
inline constexpr std::array<StreakMode, 4> streak_modes{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

/// How many of them there are in D dimensions: in two only the first.
template <int Dim>
constexpr std::size_t count_of_streak_modes() {
  return Dim == 3 ? streak_modes.size() : Dim == 2 ? 1 : 0;
}

/// The spheres that move.
struct Inertia {
  double spheres;
  double mean_mass;
};

/// Amplitudes of the streaks, |2/M sum of m u_x exp(-i k.r)| with the peculiar velocity u and the
/// total mass M, of the mobile spheres.
///
/// \return  one for each mode, diameters/time
template <int Dim, class Real>
std::vector<double> streak_amplitudes(const Simulation<Dim, Real>& simulation);

/// What streaks add to the temperature along the flow: the sum of their m A^2/2, with the mean mass
/// m, less 2 T_xx / N, the share of each mode in a gas without any.
///
/// \param averages  with the amplitudes A as the root of their mean square
/// \return          mass (diameter/time)^2; 0 where there is no shear
double streak_temperature(const Observables& averages, const Inertia& inertia);

}  // namespace zenosphere
