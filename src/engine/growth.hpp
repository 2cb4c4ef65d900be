#pragma once

#include <span>
#include <stdexcept>
#include <vector>

#include "model/random.hpp"
#include "model/shear_box.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// Spheres that got stuck while they grew.
class Jammed : public std::invalid_argument {
 public:
  /// \param reached  solids volume fraction at which they did
  explicit Jammed(double reached);
  double reached() const { return reached_; }

 private:
  double reached_;
};

/// Random places of spheres without overlaps in a box at strain 0, also of dense ones.
///
/// The spheres grow from random points, all in proportion, while they fly and collide elastically:
/// fast as long as there is much room, then slowly enough for collisions to make room and fast
/// enough for spheres of one size not to crystallise. When they have their size they fly on until
/// each has collided some twenty times. On a line the places are drawn from equilibrium at once:
/// the gaps between rods are those between random points, and the rods come in the order of a
/// shuffle.
///
/// Uses additions, products, quotients and square roots only: the same bits on every machine.
///
/// \param diameters  N, > 0, none above a side
/// \return           N places in [0, side) along each axis; surfaces and walls are clear of each
///                   other, by 1e-10 of a diameter where they grew into touch
/// Throws Jammed, with the fraction that was reached, where the spheres get stuck before that.
/// Source: Lubachevsky & Stillinger, J. Stat. Phys. 60 (1990) 561; on the line Tonks, Phys. Rev. 50
/// (1936) 955.
template <int Dim>
std::vector<Vec<Dim, double>> grown_places(std::span<const double> diameters,
                                           const ShearBox<Dim, double>& box, Random& random);

}  // namespace zenosphere
