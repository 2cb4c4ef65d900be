#pragma once

#include <cstdint>
#include <vector>

#include "engine/arrangement.hpp"
#include "engine/box_side.hpp"
#include "engine/configuration.hpp"
#include "model/grains.hpp"
#include "model/random.hpp"
#include "model/shear_box.hpp"

namespace zenosphere {

/// What a start is made from; the arrangement is one that this program makes: fcc or random.
struct StartRequest {
  Arrangement arrangement = Arrangement::fcc;
  std::int32_t spheres = 0;
  double granular_temperature = 0;  ///< (diameter/time)^2
  std::uint64_t seed = 1;
  Grains<double> grains{};  ///< what the spheres are
};

/// Gaussian velocities with exactly zero momentum and exactly the wanted granular temperature
/// <m v^2> / D, up to rounding: lighter spheres are faster, and immobile ones rest and do not
/// count. A single sphere keeps its velocity's direction, and a momentum.
template <int Dim>
std::vector<Vec<Dim, double>> thermal_velocities(std::int32_t spheres, double temperature,
                                                 Random& random, const Grains<double>& grains = {});

/// Spheres placed in a box, with Gaussian peculiar velocities (see thermal_velocities).
///
/// The same request gives the same bits on every machine. Starts are made in `double`, so that runs
/// of every precision can begin from the same state.
///
/// \param box  at strain 0; the spheres keep clear of its walls
/// Random places are loose_packing()'s as far as it goes for unit spheres, else grown_places()'s.
/// On a lattice spheres of different diameters come in random order.
///
/// Throws std::invalid_argument where the arrangement cannot be made: fcc with a number of spheres
/// that is not 4 n^3 or not in a periodic cube, or spheres that overlap on it; Jammed where random
/// places are too dense.
template <int Dim>
Configuration<Dim, double> make_start(const StartRequest& request,
                                      const ShearBox<Dim, double>& box);

}  // namespace zenosphere
