#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/contact_law.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Dice;

constexpr int random_pairs = 1000;
constexpr double energy_lost = 0.5;
constexpr double constant = 0.2;
constexpr double slow = 0.9, fast = 0.3, border = 1.5;

/// Two smooth spheres of any size and mass that approach along any normal.
template <class Real>
struct UnequalPair {
  Grains<Real> grains;
  RelativeMotion<3, Real> motion;
  Vec<3, Real> normal;
};

template <class Real>
Vec<3, Real> any_vector(Dice& dice) {
  Vec<3, Real> vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = Real(dice.between(-2, 2));
  return vector;
}

template <class Real>
UnequalPair<Real> unequal_pair(Dice& dice) {
  using std::sqrt;
  UnequalPair<Real> pair;
  for (int n = 0; n < 2; ++n) {
    pair.grains.diameters.push_back(Real(dice.between(0.2, 3)));
    pair.grains.masses.push_back(Real(dice.between(0.1, 10)));
  }
  pair.normal = any_vector<Real>(dice);
  pair.normal *= Real(1) / sqrt(dot(pair.normal, pair.normal));
  pair.motion = {pair.normal * Real(pair.grains.radius(0) + pair.grains.radius(1)),
                 any_vector<Real>(dice)};
  if (dot(pair.normal, pair.motion.dv) > 0) pair.motion.dv *= Real(-1);
  return pair;
}

template <class Real>
Collision<3, Real> after_law(const ContactModels<Real>& models, const UnequalPair<Real>& pair) {
  ContactLaw<3, Real> law({.restitution = 0, .models = models}, 2, Real(1));
  Collision<3, Real> collision;
  collision.i = 0;
  collision.j = 1;
  law.collide(collision, pair.motion, {pair.grains});
  return collision;
}

/// Restitution along the normal and energy taken, from the velocities before and after: those of
/// the centre of mass at rest.
template <class Real>
struct Outcome {
  Real restitution;
  Real loss;
  Real across;  ///< change of the relative velocity across the normal, squared
};

template <class Real>
Outcome<Real> outcome(const UnequalPair<Real>& pair, const Collision<3, Real>& collision) {
  const Real inverse_masses = pair.grains.inverse_mass(0) + pair.grains.inverse_mass(1);
  const auto after = pair.motion.dv - collision.change * inverse_masses;
  const Real before_n = dot(pair.motion.dv, pair.normal);
  const Real after_n = dot(after, pair.normal);
  const auto side = (after - pair.normal * after_n) - (pair.motion.dv - pair.normal * before_n);
  return {-after_n / before_n,
          (dot(pair.motion.dv, pair.motion.dv) - dot(after, after)) / (2 * inverse_masses),
          dot(side, side)};
}

template <class Real>
class UnequalContact : public testing::Test {};
using Numbers = testing::Types<double, Extended, Quad, Digits>;
TYPED_TEST_SUITE(UnequalContact, Numbers);

/// Of energies up to a hundred, a few operations.
template <class Real>
Real rounding_of_energy() {
  return Real(1e4) * std::numeric_limits<Real>::epsilon();
}

TYPED_TEST(UnequalContact, LosesTheFixedEnergyWhereItHasMoreAndNothingElsewhere) {
  using Real = TypeParam;
  using std::abs;
  const WorkingPrecision digits(200);
  ContactModels<Real> models;
  models.law = FixedLossRestitution<Real>(Real(energy_lost));
  Dice dice(11);
  int energetic = 0;
  for (int n = 0; n < random_pairs; ++n) {
    const auto pair = unequal_pair<Real>(dice);
    const auto [restitution, loss, across] = outcome(pair, after_law(models, pair));
    const Real v = dot(pair.motion.dv, pair.normal);
    const Real mass = 1 / (1 / pair.grains.mass(0) + 1 / pair.grains.mass(1));
    const bool loses = mass * v * v / 2 > Real(energy_lost);
    EXPECT_LE(abs(Real(loss - (loses ? Real(energy_lost) : Real(0)))), rounding_of_energy<Real>());
    EXPECT_GT(restitution, 0);
    EXPECT_LE(across, rounding_of_energy<Real>() * std::numeric_limits<Real>::epsilon());
    energetic += loses;
  }
  EXPECT_GT(energetic, random_pairs / 10);
  EXPECT_LT(energetic, random_pairs * 9 / 10);
}

TYPED_TEST(UnequalContact, IsViscoelasticByItsReducedRadiusAndMass) {
  using Real = TypeParam;
  using std::abs;
  const WorkingPrecision digits(200);
  ContactModels<Real> models;
  models.law = ViscoelasticRestitution<Real>(Real(constant));
  Dice dice(12);
  for (int n = 0; n < random_pairs; ++n) {
    const auto pair = unequal_pair<Real>(dice);
    const auto [restitution, loss, across] = outcome(pair, after_law(models, pair));
    const auto number = [](const Real& real) { return static_cast<double>(real); };
    const double radius =
        1 / (1 / number(pair.grains.radius(0)) + 1 / number(pair.grains.radius(1)));
    const double mass = 1 / (1 / number(pair.grains.mass(0)) + 1 / number(pair.grains.mass(1)));
    // The constant goes as (sqrt(R)/m)^(2/5), and is the one of the case at R = 1/4, m = 1/2.
    const double of_pair = constant * std::pow(std::sqrt(radius / 0.25) / (mass / 0.5), 0.4);
    const Real v = -dot(pair.motion.dv, pair.normal);
    const double expected = ViscoelasticRestitution<double>(of_pair)(number(v));
    EXPECT_NEAR(number(restitution), expected, 1e-12);
    const Real energy = v * v / (2 * (1 / pair.grains.mass(0) + 1 / pair.grains.mass(1)));
    EXPECT_LE(abs(Real(loss - (1 - restitution * restitution) * energy)),
              rounding_of_energy<Real>());
    EXPECT_LE(across, rounding_of_energy<Real>() * std::numeric_limits<Real>::epsilon());
  }
}

TYPED_TEST(UnequalContact, HasTwoValuesByItsNormalSpeedWhateverTheMasses) {
  using Real = TypeParam;
  using std::abs;
  const WorkingPrecision digits(200);
  ContactModels<Real> models;
  models.law = TwoValuedRestitution<Real>{Real(slow), Real(fast), Real(border)};
  Dice dice(13);
  int fast_ones = 0;
  for (int n = 0; n < random_pairs; ++n) {
    const auto pair = unequal_pair<Real>(dice);
    const auto [restitution, loss, across] = outcome(pair, after_law(models, pair));
    const bool is_fast = -dot(pair.motion.dv, pair.normal) >= Real(border);
    EXPECT_LE(abs(Real(restitution - Real(is_fast ? fast : slow))), rounding_of_energy<Real>());
    EXPECT_GT(loss, 0);
    fast_ones += is_fast;
  }
  EXPECT_GT(fast_ones, random_pairs / 10);
}

TYPED_TEST(UnequalContact, OfEqualSpheresHasEveryBitOfUnitSpheres) {
  using Real = TypeParam;
  const WorkingPrecision digits(200);
  ContactModels<Real> viscoelastic, fixed_loss;
  viscoelastic.law = ViscoelasticRestitution<Real>(Real(constant));
  fixed_loss.law = FixedLossRestitution<Real>(Real(energy_lost));
  Dice dice(14);
  for (int n = 0; n < random_pairs; ++n) {
    auto pair = unequal_pair<Real>(dice);
    pair.grains = {{1, 1}, {1, 1}, {0, 0}, {0, 0}};
    pair.motion.dr = pair.normal;
    auto unit = pair;
    unit.grains = {};
    for (const auto& models : {viscoelastic, fixed_loss}) {
      const auto change = after_law(models, pair).change;
      EXPECT_EQ(change, after_law(models, unit).change);
      // And those of the restitution that unit spheres have had before there were others.
      const Real speed = -dot(touch(pair.motion).normal, pair.motion.dv);
      const auto* soft = std::get_if<ViscoelasticRestitution<Real>>(&*models.law);
      const Real e =
          soft ? (*soft)(speed) : std::get<FixedLossRestitution<Real>>(*models.law)(speed);
      EXPECT_EQ(change, impact(pair.motion, e).normal * Real(-impact(pair.motion, e).impulse));
    }
  }
}

TEST(ContactLaw, KindsWithARestitutionOfTheirOwnDoNotFollowTheLaw) {
  ContactRules<double> rules;
  rules.models.law = TwoValuedRestitution<double>{slow, fast, border};
  rules.table.emplace(2, ContactConstants<double>{});
  ContactConstants<double> own{.restitution = 0.5};
  own.is_own = true;
  rules.table->set(0, 1, own);
  Grains<double> grains{{}, {}, {0, 1, 0}, {}};
  ContactLaw<3, double> law(rules, 3, 1.0);
  const auto restitution = [&](std::int32_t other) {
    Collision<3, double> collision;
    collision.i = 0;
    collision.j = other;
    law.collide(collision, {{{1, 0, 0}}, {{-1, 0, 0}}}, {grains});
    return 2 * collision.impact.impulse - 1;
  };
  EXPECT_DOUBLE_EQ(restitution(1), 0.5);
  EXPECT_DOUBLE_EQ(restitution(2), slow);
}

}  // namespace
}  // namespace zenosphere
