#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>

#include "engine/simulation.hpp"

namespace zenosphere::support {

using Vector = Vec<3, double>;
using Box = ShearBox<3, double>;
using State = Configuration<3, double>;
using Gas = Simulation<3, double>;
using Record = Collision<3, double>;

/// A periodic cube without shear.
inline Box cube(double side) { return Box({side, side, side}, 0); }

/// Random numbers for tests, apart from those of the engine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  int below(int count) { return static_cast<int>(between(0, count)); }

 private:
  std::mt19937_64 generator_;
};

/// Distance of two places in a plain periodic box, diameters.
inline double nearest_distance(const Vector& a, const Vector& b, const Vector& sides) {
  Vector dr = b - a;
  for (int axis = 0; axis < 3; ++axis) {
    dr[axis] -= sides[axis] * std::round(dr[axis] / sides[axis]);
  }
  return std::sqrt(dot(dr, dr));
}

/// Spheres placed one by one where they find room, with velocities of zero mean.
///
/// Good up to a solids volume fraction of about 0.3 (sequential addition jams at 0.38).
///
/// \param speed  each component lies in (-speed, speed), diameters/time
inline State random_gas(int spheres, const Vector& sides, double speed, std::uint64_t seed) {
  Dice dice(seed);
  State state;
  for (int trial = 0; static_cast<int>(state.positions.size()) < spheres; ++trial) {
    if (trial > 10000000) throw std::runtime_error("no room for another sphere");
    Vector place;
    for (int axis = 0; axis < 3; ++axis) place[axis] = dice.between(0, sides[axis]);
    bool is_free = true;
    for (const Vector& other : state.positions) {
      if (nearest_distance(place, other, sides) < 1) is_free = false;
    }
    if (is_free) state.positions.push_back(place);
  }
  Vector mean;
  for (int i = 0; i < spheres; ++i) {
    Vector velocity;
    for (int axis = 0; axis < 3; ++axis) velocity[axis] = dice.between(-speed, speed);
    state.velocities.push_back(velocity);
    mean += velocity * (1.0 / spheres);
  }
  for (Vector& velocity : state.velocities) velocity -= mean;
  return state;
}

/// The next collision of a gas that is known to have one.
inline Record next(Gas& gas) {
  for (int call = 0; call < 10000; ++call) {
    if (auto collision = gas.next_collision(1e6)) return *collision;
  }
  throw std::runtime_error("no collision");
}

/// Expects the next collisions of two gases to be of the same spheres, one after the other, at
/// times that differ by `tolerance` at most.
inline void expect_like_collisions(Gas& one, Gas& other, int collisions, double tolerance) {
  for (int n = 0; n < collisions; ++n) {
    const Record a = next(one);
    const Record b = next(other);
    ASSERT_EQ(a.i, b.i) << "collision " << a.number;
    ASSERT_EQ(a.j, b.j) << "collision " << a.number;
    ASSERT_NEAR(one.time(), other.time(), tolerance) << "collision " << a.number;
  }
}

/// Expects the next collisions of two gases to be the same bit for bit.
inline void expect_same_collisions(Gas& one, Gas& other, int collisions) {
  for (int n = 0; n < collisions; ++n) {
    const Record a = next(one);
    const Record b = next(other);
    ASSERT_EQ(a.i, b.i) << "collision " << a.number;
    ASSERT_EQ(a.j, b.j) << "collision " << a.number;
    ASSERT_EQ(a.time.remainder, b.time.remainder) << "collision " << a.number;
    ASSERT_EQ(a.gap_before, b.gap_before) << "collision " << a.number;
    ASSERT_EQ(a.change, b.change) << "collision " << a.number;
  }
}

/// Twice the kinetic energy of the peculiar motion, mass (diameter/time)^2.
inline double twice_energy(const Gas& gas) {
  double sum = 0;
  for (int i = 0; i < gas.spheres(); ++i) {
    sum += dot(gas.peculiar_velocity(i), gas.peculiar_velocity(i));
  }
  return sum;
}

/// Sum of the peculiar velocities, mass diameter/time.
inline Vector momentum(const Gas& gas) {
  Vector sum;
  for (int i = 0; i < gas.spheres(); ++i) sum += gas.peculiar_velocity(i);
  return sum;
}

}  // namespace zenosphere::support
