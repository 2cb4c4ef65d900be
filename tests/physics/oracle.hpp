#pragma once

#include <array>
#include <vector>

#include "engine/contact_rules.hpp"
#include "engine/simulation.hpp"

namespace zenosphere {

/// Hard spheres under Lees-Edwards shear, the slow and obvious way: what the engine must agree
/// with.
///
/// Laboratory frame, unfolded positions, every pair in every image after every event, long double,
/// its own contact time and its own collision: of spheres of any size and mass, smooth or rough. It
/// shares no code with the engine, only the plain data of a configuration and of the rules.
class Oracle {
 public:
  struct Event {
    double time = 0;  ///< since the oracle's start
    int i = 0;        ///< < j
    int j = 0;
    double normal_speed = 0;  ///< closing speed, diameters/time
    double gap_before = 0;    ///< of the pair at the event before, in the image that meets
    bool sliding = false;     ///< friction was at its limit
  };

  /// \param rules   restitution, or the table of constants
  /// \param offset  displacement of the upper image of the box along x at the start, diameters
  Oracle(const Vec<3, double>& sides, double shear_rate, const ContactRules<double>& rules,
         const Configuration<3, double>& start, double offset);

  /// Goes to the next collision and does it. Throws std::runtime_error if there is none for long.
  Event next_collision();

  /// Laboratory velocity and spin of a sphere now, in the image of the unfolded place.
  std::array<long double, 3> spin(std::size_t i) const { return spins_[i]; }

 private:
  using Real = long double;
  using Triple = std::array<Real, 3>;
  struct Seen {  ///< sphere j in one image as seen from sphere i
    Triple dr;
    Triple dv;
  };
  struct Contact {
    Real wait;
    std::size_t i;
    std::size_t j;
    Seen seen;
  };

  std::vector<Seen> images(std::size_t i, std::size_t j) const;
  Contact earliest(Real& horizon) const;
  void fly(Real duration);
  void collide(const Contact& contact, Event& event);
  Real sigma(std::size_t i, std::size_t j) const { return radii_[i] + radii_[j]; }

  Triple sides_;
  Real shear_rate_;
  ContactRules<double> rules_;
  Real offset_;
  Real time_ = 0;
  std::vector<Triple> positions_;   ///< unfolded, laboratory frame
  std::vector<Triple> velocities_;  ///< laboratory frame; the middle of the box is at rest
  std::vector<Triple> spins_;
  std::vector<Real> radii_, masses_;
  std::vector<int> kinds_;
};

/// Starts the oracle from where a gas is now and compares `collisions` of them, one by one.
///
/// \param tolerance  of the time; a hundred times that of speeds and gaps, a thousand times of
/// spins
void expect_collisions_of_oracle(Simulation<3, double>& gas, int collisions, double tolerance);

}  // namespace zenosphere
