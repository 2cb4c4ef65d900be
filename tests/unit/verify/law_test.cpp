#include "verify/law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zenosphere::verify {
namespace {

/// Two spheres between walls of restitution 3/4, restitution 1/2.
Case between_walls() {
  Case values;
  values.system = {.dimension = 2, .spheres = 2, .restitution = 0.5, .sides = {10, 8}};
  values.walls = {.axis = Axis::y, .restitution = 0.75};
  return values;
}

constexpr CollisionRow pair{1, 1, 0, 1, 0, 2, 0};
constexpr CollisionRow bounce{1, 1, 0, 3, 0, 2, 0};
constexpr CollisionRow lasting_pair{1, 1, 0, 1, 0, 2, collision_flag::made_elastic};
constexpr CollisionRow lasting_bounce{1, 1, 0, 3, 0, 2, collision_flag::made_elastic};

TEST(Law, ContactsThatLastAreElasticWithSpheresAndWalls) {
  const Law law(between_walls(), 2);
  EXPECT_EQ(law.restitution(pair), 0.5L);
  EXPECT_EQ(law.restitution(bounce), 0.75L);
  EXPECT_EQ(law.restitution(lasting_pair), 1);
  EXPECT_EQ(law.restitution(lasting_bounce), 1);
  EXPECT_EQ(law.impulse(lasting_pair), 2);  // the relative velocity is reversed
  EXPECT_EQ(law.loss(lasting_pair), 0);
  EXPECT_EQ(law.loss(bounce), 0.875);  // (1 - 9/16) x 4 / 2
}

TEST(Law, ViscoelasticRestitutionIsThatOfTheLoggedSpeed) {
  Case values = between_walls();
  values.collision.restitution_law = RestitutionLaw::viscoelastic;
  values.collision.viscoelastic_constant = 1e-4;
  const Law law(values, 2);
  // 1 - C1 A v^(1/5) with C1 = 1.1534488...; the next term is (3/5) (1.3e-4)^2 = 1e-8.
  const long double first_order = 1 - 1.1534488580952884L * 1e-4L * std::pow(2.0L, 0.2L);
  EXPECT_NEAR(static_cast<double>(law.restitution(pair) - first_order), 0, 2e-8);
  EXPECT_LT(law.restitution(pair), 1);
  EXPECT_EQ(law.restitution(bounce), 0.75L);
  EXPECT_EQ(law.restitution(lasting_pair), 1);
}

TEST(Law, TwoValuesOfTheLoggedSpeedAreOfSpheresOnly) {
  Case values = between_walls();
  values.collision.restitution_law = RestitutionLaw::two_valued;
  values.collision.slow_restitution = 0.5;
  values.collision.fast_restitution = 0.25;
  values.collision.threshold_speed = 2;
  EXPECT_EQ(Law(values, 2).restitution(pair), 0.25L);  // at the threshold itself, 2
  EXPECT_EQ(Law(values, 2).restitution(bounce), 0.75L);
  EXPECT_EQ(Law(values, 2).impulse(pair), 1.25L);
  values.collision.precision = Precision::quad;
  EXPECT_FALSE(Law(values, 2).impulse(pair));  // the logged speed is rounded
  values.collision.threshold_speed = 3;
  EXPECT_EQ(Law(values, 2).restitution(pair), 0.5L);
  EXPECT_EQ(Law(values, 2).loss(pair), 0.75L);  // (1 - 1/4) x 4 / 4
}

Case with_fixed_loss(double loss) {
  Case values = between_walls();
  values.collision.restitution_law = RestitutionLaw::fixed_loss;
  values.collision.energy_loss = loss;
  return values;
}

TEST(Law, AFixedLossIsTakenOfEnergeticCollisionsOfSpheresOnly) {
  const Law law(with_fixed_loss(0.36), 2);                              // of 2^2/4 = 1 in each row
  EXPECT_NEAR(static_cast<double>(law.restitution(pair)), 0.8, 1e-16);  // sqrt(1 - 0.36)
  EXPECT_NEAR(static_cast<double>(*law.impulse(pair)), 1.8, 1e-15);
  EXPECT_EQ(law.loss(pair), 0.36);
  EXPECT_EQ(law.restitution(bounce), 0.75L);
  EXPECT_EQ(law.loss(bounce), 0.875);
  EXPECT_EQ(law.restitution(lasting_pair), 1);
  EXPECT_EQ(law.loss(lasting_pair), 0);
  EXPECT_EQ(law.impulse_error(lasting_pair), 0);
}

/// Two kinds of one sphere each.
Case of_two_kinds(Case values, double mass, double other_mass, double diameter = 1) {
  values.species = {{.name = "a", .diameter = diameter, .mass = mass, .spheres = 1},
                    {.name = "b", .diameter = diameter, .mass = other_mass, .spheres = 1}};
  return values;
}

TEST(Law, AFixedLossIsComparedWithTheEnergyOfTheReducedMass) {
  const Case values = of_two_kinds(with_fixed_loss(0.54), 1, 3);  // 3/4 of a mass at 2: 1.5
  const Law law(values, 2, grains_of(values));
  EXPECT_DOUBLE_EQ(static_cast<double>(law.restitution(pair)), 0.8);  // sqrt(1 - 0.36)
  EXPECT_DOUBLE_EQ(static_cast<double>(*law.impulse(pair)), 2.7);     // 1.8 x 2 x 3/4
  EXPECT_EQ(law.loss(pair), 0.54);
  const Case light = of_two_kinds(with_fixed_loss(0.54), 0.25, 0.25);  // an eighth: 0.25
  EXPECT_EQ(Law(light, 2, grains_of(light)).restitution(pair), 1);
}

TEST(Law, ViscoelasticSpheresAreSofterByTheirRadiusAndHarderByTheirMass) {
  Case values = between_walls();
  values.collision.restitution_law = RestitutionLaw::viscoelastic;
  values.collision.viscoelastic_constant = 0.4;
  const Law unit(values, 2);
  // Diameter 4: sqrt(R) is twice that of unit spheres. Masses 1/16: 2 x 16 = 32, and 32^(2/5) = 4.
  values.collision.viscoelastic_constant = 0.1;
  values = of_two_kinds(values, 1.0 / 16, 1.0 / 16, 4);
  const Law law(values, 2, grains_of(values));
  EXPECT_NEAR(static_cast<double>(law.restitution(pair) - unit.restitution(pair)), 0, 1e-16);
}

TEST(Law, KindsWithARestitutionOfTheirOwnLoseNoFixedEnergy) {
  Case values = of_two_kinds(with_fixed_loss(0.5), 1, 1);
  values.contacts = {{.between = {"a", "b"}, .restitution = 0.5}};
  const Law law(values, 2, grains_of(values));
  EXPECT_EQ(law.restitution(pair), 0.5L);
  EXPECT_EQ(law.loss(pair), 0.75L);  // (1 - 1/4) x 4 / 4
}

TEST(Law, AWeakerCollisionThanTheFixedLossIsElastic) {
  for (const double loss : {1.0, 1.5}) {
    const Law law(with_fixed_loss(loss), 2);
    EXPECT_EQ(law.restitution(pair), 1);
    EXPECT_EQ(law.impulse(pair), 2);
    EXPECT_EQ(law.loss(pair), 0);
  }
}

// At a speed v = c (1 + d) above the threshold c the spheres part at c sqrt(2 d): the rounding of
// v, 2^-52 v, becomes 2^-52 v / sqrt(2 d).
TEST(Law, JustAboveAFixedLossTheRoundingOfTheSpeedGrows) {
  const Law law(with_fixed_loss(1 - 1e-8), 2);  // d = 5e-9
  EXPECT_NEAR(static_cast<double>(law.impulse_error(pair)), 0x1p-52 * 2 / 1e-4, 1e-17);
}

TEST(Law, ASpeedOnTheThresholdOfAFixedLossTellsNoImpulse) {
  EXPECT_FALSE(Law(with_fixed_loss(std::nextafter(1.0, 0.0)), 2).impulse(pair));
  EXPECT_FALSE(Law(with_fixed_loss(std::nextafter(1.0, 2.0)), 2).impulse(pair));
  EXPECT_TRUE(Law(with_fixed_loss(1 - 1e-14), 2).impulse(pair));
  EXPECT_TRUE(Law(with_fixed_loss(1), 2).impulse(lasting_pair));
}

TEST(Law, ARotationHidesTheDirectionOfTheImpulseButNotTheLoss) {
  Case values = between_walls();
  values.collision.rotation_angle = 0.5;
  const Law law(values, 2);
  EXPECT_FALSE(law.tells_velocities());
  EXPECT_FALSE(law.impulse(pair));
  EXPECT_EQ(law.loss(pair), 0.75);  // (1 - 1/4) x 4 / 4
}

}  // namespace
}  // namespace zenosphere::verify
