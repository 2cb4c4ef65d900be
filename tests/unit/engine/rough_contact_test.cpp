#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "engine/contact_law.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Dice;

constexpr int random_pairs = 1000;

/// Two spheres of any size, mass and spin that touch, in the laboratory; sphere 0 in the middle.
template <int Dim, class Real>
struct RoughPair {
  Grains<Real> grains;
  Vec<Dim, Real> normal;
  std::vector<Vec<Dim, Real>> velocities;
  std::vector<Spin<Dim, Real>> spins;
  ContactRules<Real> rules;
};

template <int Size, class Real>
Vec<Size, Real> random_vector(Dice& dice, double most) {
  Vec<Size, Real> vector;
  for (int axis = 0; axis < Size; ++axis) vector[axis] = Real(dice.between(-most, most));
  return vector;
}

template <int Dim, class Real>
RoughPair<Dim, Real> random_pair(Dice& dice, const Real& friction) {
  using std::sqrt;
  RoughPair<Dim, Real> pair;
  for (int n = 0; n < 2; ++n) {
    pair.grains.diameters.push_back(Real(dice.between(0.2, 3)));
    pair.grains.masses.push_back(Real(dice.between(0.1, 10)));
    pair.velocities.push_back(random_vector<Dim, Real>(dice, 2));
    pair.spins.push_back(random_vector<spin_axes<Dim>, Real>(dice, 3));
  }
  auto& normal = pair.normal = random_vector<Dim, Real>(dice, 1);
  normal *= Real(1) / sqrt(dot(normal, normal));
  // They approach.
  if (dot(normal, pair.velocities[1] - pair.velocities[0]) > 0) {
    std::swap(pair.velocities[0], pair.velocities[1]);
  }
  pair.rules.table.emplace(
      1, ContactConstants<Real>{Real(dice.between(0, 1)), Real(dice.between(-1, 1)), friction});
  if (dice.below(2) == 0) pair.rules.inertia = Real(dice.between(0.1, 1));  // half are solid
  return pair;
}

template <int Dim, class Real>
RelativeMotion<Dim, Real> motion_of(const RoughPair<Dim, Real>& pair) {
  const Real sigma = pair.grains.radius(0) + pair.grains.radius(1);
  return {pair.normal * sigma, pair.velocities[1] - pair.velocities[0]};
}

template <int Dim, class Real>
Real inertia_of(const RoughPair<Dim, Real>& pair, std::int32_t i) {
  const Real radius = pair.grains.radius(i);
  return pair.rules.inertia.value_or(Real(solid_inertia<Dim>)) * pair.grains.mass(i) * radius *
         radius;
}

template <int Dim, class Real>
Real energy_of(const RoughPair<Dim, Real>& pair) {
  Real twice = 0;
  for (std::int32_t i = 0; i < 2; ++i) {
    const auto& spin = pair.spins[static_cast<std::size_t>(i)];
    const auto& velocity = pair.velocities[static_cast<std::size_t>(i)];
    twice +=
        pair.grains.mass(i) * dot(velocity, velocity) + inertia_of<Dim>(pair, i) * dot(spin, spin);
  }
  return twice / 2;
}

/// About the centre of sphere 0.
template <int Dim, class Real>
Spin<Dim, Real> angular_momentum_of(const RoughPair<Dim, Real>& pair) {
  Spin<Dim, Real> sum =
      angular_impulse<Dim, Real>(motion_of(pair).dr, pair.velocities[1] * pair.grains.mass(1));
  for (std::int32_t i = 0; i < 2; ++i) {
    sum += pair.spins[static_cast<std::size_t>(i)] * inertia_of<Dim>(pair, i);
  }
  return sum;
}

/// Velocity of the surface of sphere 1 relative to that of sphere 0 where they touch.
template <int Dim, class Real>
Vec<Dim, Real> surface_velocity(const RoughPair<Dim, Real>& pair) {
  return pair.velocities[1] +
         turning_velocity<Dim, Real>(pair.spins[1], pair.normal * Real(-pair.grains.radius(1))) -
         pair.velocities[0] -
         turning_velocity<Dim, Real>(pair.spins[0], pair.normal * pair.grains.radius(0));
}

template <int Dim, class Real>
Collision<Dim, Real> collide(RoughPair<Dim, Real>& pair) {
  ContactLaw<Dim, Real> law(pair.rules, 2, Real(1));
  Collision<Dim, Real> collision;
  collision.i = 0;
  collision.j = 1;
  law.collide(collision, motion_of(pair), {pair.grains, pair.spins});
  pair.velocities[0] += collision.change * pair.grains.inverse_mass(0);
  pair.velocities[1] -= collision.change * pair.grains.inverse_mass(1);
  for (const std::int32_t i : {0, 1}) {
    pair.spins[static_cast<std::size_t>(i)] += law.change_of_spin(collision, i, pair.grains);
  }
  return collision;
}

template <class Kind>
class RoughContact : public testing::Test {};

template <int D, class R>
struct In {
  static constexpr int dim = D;
  using Real = R;
};
using Kinds = testing::Types<In<2, double>, In<3, double>, In<3, Extended>, In<3, Quad>,
                             In<2, Digits>, In<3, Digits>>;
TYPED_TEST_SUITE(RoughContact, Kinds);

/// Of numbers up to some tens, in which a mass of 0.1 multiplies roundings: 1e5 units in the last
/// place.
template <class Real>
Real rounding() {
  return Real(1e5) * std::numeric_limits<Real>::epsilon();
}

TYPED_TEST(RoughContact, KeepsLinearAndAngularMomentum) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  using std::abs;
  const WorkingPrecision digits(200);
  Dice dice(3);
  for (int n = 0; n < random_pairs; ++n) {
    auto pair = random_pair<Dim, Real>(dice, Real(dice.between(0, 2)));
    const auto momentum = [&] {
      return pair.velocities[0] * pair.grains.mass(0) + pair.velocities[1] * pair.grains.mass(1);
    };
    const auto before = momentum();
    const auto turning = angular_momentum_of(pair);
    collide(pair);
    const auto change = momentum() - before;
    const auto twist = angular_momentum_of(pair) - turning;
    for (int axis = 0; axis < Dim; ++axis) EXPECT_LE(abs(change[axis]), rounding<Real>());
    for (int axis = 0; axis < spin_axes<Dim>; ++axis) EXPECT_LE(abs(twist[axis]), rounding<Real>());
  }
}

TYPED_TEST(RoughContact, TakesTheEnergyOfWaltonsLawAndReversesTheSurfacesByBeta) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  using std::abs;
  using std::sqrt;
  const WorkingPrecision digits(200);
  Dice dice(4);
  int slides = 0;
  for (int n = 0; n < random_pairs; ++n) {
    const Real friction = Real(dice.between(0, 1));
    auto pair = random_pair<Dim, Real>(dice, friction);
    const auto constants = pair.rules.constants(0, 0);
    const Real energy = energy_of(pair);
    const auto before = surface_velocity(pair);
    const auto collision = collide(pair);
    const auto after = surface_velocity(pair);
    // 1/m_n, and 1/m_t = 1/m_n + s_i^2/(4 I_i) + s_j^2/(4 I_j), written out.
    const Real normal_mass = 1 / (1 / pair.grains.mass(0) + 1 / pair.grains.mass(1));
    Real tangential = 1 / normal_mass;
    for (const std::int32_t i : {0, 1}) {
      tangential += pair.grains.radius(i) * pair.grains.radius(i) / inertia_of<Dim>(pair, i);
    }
    const Real tangential_mass = 1 / tangential;
    const Real g_n = -dot(pair.normal, before);
    const auto g_t = before + pair.normal * g_n;
    const Real slip = sqrt(dot(g_t, g_t));
    const Real push = (1 + constants.restitution) * normal_mass * g_n;
    const Real sticking = (1 + constants.tangential_restitution) * tangential_mass * slip;
    EXPECT_EQ(collision.sliding, sticking > friction * push);
    EXPECT_LE(abs(Real(collision.impact.impulse - push)), rounding<Real>());
    const Real e = constants.restitution;
    const Real beta = constants.tangential_restitution;
    Real loss = normal_mass * (1 - e * e) * g_n * g_n / 2;
    if (collision.sliding) {
      ++slides;
      const Real rub = friction * push;
      loss += rub * slip - rub * rub / (2 * tangential_mass);
    } else {
      loss += tangential_mass * (1 - beta * beta) * slip * slip / 2;
      for (int axis = 0; axis < Dim; ++axis) {
        const Real left = after[axis] - dot(pair.normal, after) * pair.normal[axis];
        EXPECT_LE(abs(Real(left + beta * g_t[axis])), rounding<Real>());
      }
    }
    EXPECT_LE(abs(Real(dot(pair.normal, after) - e * g_n)), rounding<Real>());
    EXPECT_LE(abs(Real(energy_of(pair) - energy + loss)), rounding<Real>());
  }
  EXPECT_GT(slides, random_pairs / 10);
  EXPECT_LT(slides, random_pairs * 9 / 10);
}

TYPED_TEST(RoughContact, SticksUpToTheBorderAndSlidesBeyondIt) {
  constexpr int Dim = TypeParam::dim;
  using Real = typename TypeParam::Real;
  using std::sqrt;
  const WorkingPrecision digits(200);
  // Unit spheres, closing at 1 with e = 1: J_n = 1. They slip at 1 with beta0 = 0: sticking takes
  // m_t = q/(1 + q)/2, 1/7 for spheres and 1/6 for disks.
  const Real border = Real(1) / (Dim == 3 ? 7 : 6);
  for (const bool beyond : {false, true}) {
    RoughPair<Dim, Real> pair;
    pair.normal[0] = 1;
    pair.velocities.resize(2);
    pair.velocities[1][0] = -1;
    pair.velocities[1][1] = 1;
    pair.spins.resize(2);
    const Real friction = border * Real(beyond ? 0.999999 : 1.000001);
    pair.rules.table.emplace(1, ContactConstants<Real>{Real(1), Real(0), friction});
    EXPECT_EQ(collide(pair).sliding, beyond);
  }
}

template <class Real>
void expect_smooth(const ContactConstants<Real>& constants) {
  Dice dice(5);
  for (int n = 0; n < random_pairs; ++n) {
    auto pair = random_pair<3, Real>(dice, constants.friction);
    pair.rules.table.emplace(1, constants);
    auto smooth = pair;
    smooth.rules = {.restitution = constants.restitution};
    smooth.spins.clear();
    const auto collision = collide(pair);
    ContactLaw<3, Real> law(smooth.rules, 2, Real(1));
    Collision<3, Real> expected;
    expected.i = 0;
    expected.j = 1;
    law.collide(expected, motion_of(smooth), {smooth.grains});
    EXPECT_EQ(collision.change, expected.change);
    EXPECT_EQ(collision.friction_loss, 0);
  }
}

TEST(RoughContact, WithoutFrictionOrWithBetaOfMinusOneGivesTheSmoothDigits) {
  expect_smooth<double>({0.8, -1, 0.5});
  expect_smooth<double>({0.8, 0.5, 0});
  expect_smooth<Quad>({Quad(0.8), Quad(-1), ContactConstants<Quad>::unbounded()});
}

TEST(RoughContact, OfAnImmobileSphereMovesTheOtherAlone) {
  Dice dice(6);
  auto pair = random_pair<3, double>(dice, 1);
  pair.grains.immobile = {1, 0};
  const auto velocity = pair.velocities[0];
  const auto spin = pair.spins[0];
  const auto collision = collide(pair);
  EXPECT_EQ(pair.velocities[0], velocity);
  EXPECT_EQ(pair.spins[0], spin);
  const double e = pair.rules.constants(0, 0).restitution;
  EXPECT_NEAR(collision.impact.impulse,
              (1 + e) * pair.grains.mass(1) * collision.impact.normal_speed, 1e-14);
}

TEST(RoughContact, WithAWallSetsASlidingSphereRolling) {
  // A unit sphere flies at (1, -1) onto the floor, e = 1, beta0 = 0, mu unbounded: the slip of 1 is
  // taken away by J_t = m_t = q/(1 + q) = 2/7, so that v_x = 5/7 and the spin about z is -10/7:
  // rolling, v_x + w r = 0.
  const Grains<double> unit;
  const Walls<double> walls{.axis = 1, .restitution = 1, .tangential_restitution = 0};
  ContactRules<double> rules;
  rules.table.emplace(1, ContactConstants<double>{1, 0, 1});
  ContactLaw<3, double> law(rules, 1, 1.0);
  const std::vector<Spin<3, double>> spins(1);
  Collision<3, double> collision;
  collision.i = 0;
  collision.j = 1;
  law.bounce(collision, walls, 0, {{1.0, -1.0, 0.0}}, {unit, spins});
  EXPECT_NEAR(collision.change[0], -2.0 / 7, 1e-15);
  EXPECT_NEAR(collision.change[1], 2, 1e-15);
  const auto turned = law.change_of_spin(collision, 0, unit);
  EXPECT_NEAR(turned[2], -10.0 / 7, 1e-15);
  EXPECT_NEAR(collision.friction_loss, 1.0 / 7, 1e-15);  // m_t v^2 / 2
}

}  // namespace
}  // namespace zenosphere
