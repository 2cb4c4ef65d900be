#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/configuration.hpp"

namespace zenosphere {

/// A small system drawn at random, with rules, drive and surroundings that no user would choose.
///
/// Its own speed s = sqrt(granular temperature) lies between 10^-12 and 10^137, and everything else
/// is measured by it: intervals in 1/s, accelerations in s^2.
struct RandomSystem {
  int dimension = 1;
  int spheres = 1;
  double speed = 1;
  std::optional<double> restitution = 1;  ///< none: another law
  double shear_rate = 0;
  std::vector<double> sides;                    ///< diameters
  std::vector<std::vector<double>> positions;   ///< N x D, diameters
  std::vector<std::vector<double>> velocities;  ///< N x D, diameters/time, relative to the profile
  bool is_bare = true;                          ///< nothing but spheres, a box and shear
  std::string more;                             ///< the tables of the case that tell the rest

  /// The same system for each seed.
  explicit RandomSystem(std::uint64_t seed);

  /// Its case file.
  std::string text() const;

  /// Its start as one in three dimensions: rods and discs are spheres on a line and in a plane.
  ///
  /// \param displacement  of each place along each of the system's axes, diameters, at random
  Configuration<3, double> start(double displacement = 0) const;

  /// The box of that start.
  Vec<3, double> box_sides() const;
};

}  // namespace zenosphere
