#include "engine/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Dice;

/// Spheres i and j about to touch.
template <int Dim>
Collision<Dim, double> contact_of(std::int32_t i, std::int32_t j, double time = 0) {
  Collision<Dim, double> collision;
  collision.i = i;
  collision.j = j;
  collision.time = {0, time};
  return collision;
}

/// Unit spheres, the normal along x.
template <int Dim>
RelativeMotion<Dim, double> motion_of(const Vec<Dim, double>& dv) {
  Vec<Dim, double> dr;
  dr[0] = 1;
  return {dr, dv};
}

const Grains<double> alike;

/// Impulse over closing speed, doubled, less one: the restitution that was used.
double restitution_of(const Collision<1, double>& collision) {
  return 2 * collision.impact.impulse / collision.impact.normal_speed - 1;
}

class ContactDuration : public testing::Test {
 protected:
  /// The restitution of a collision of i and j at a time; without the TC model it is 0.2.
  double meet(std::int32_t i, std::int32_t j, double time) {
    auto collision = contact_of<1>(i, j, time);
    law.collide(collision, motion_of<1>({{-1.0}}), {alike});
    made_elastic = collision.made_elastic;
    return restitution_of(collision);
  }

  ContactLaw<1, double> law{{.restitution = 0.2, .models = {.contact_duration = 0.125}}, 4, 1.0};
  bool made_elastic = false;
};

TEST_F(ContactDuration, MakesACollisionElasticIfEitherPartnerHasJustCollided) {
  EXPECT_DOUBLE_EQ(meet(1, 2, 0.25), 0.2);
  EXPECT_DOUBLE_EQ(meet(0, 2, 0.3), 1);  // 2 met at 0.25, 0 never
  EXPECT_TRUE(made_elastic);
  EXPECT_DOUBLE_EQ(meet(1, 3, 0.31), 1);  // 1 met at 0.25, 3 never
  EXPECT_EQ(law.counts().made_elastic, 2);
  EXPECT_EQ(law.counts().collisions, 3);
  EXPECT_DOUBLE_EQ(law.counts().mean_restitution, 2.2 / 3);
}

TEST_F(ContactDuration, IsOverAfterExactlyItsTime) {
  EXPECT_DOUBLE_EQ(meet(0, 1, 0.25), 0.2);
  EXPECT_DOUBLE_EQ(meet(0, 2, 0.375), 0.2);
  EXPECT_FALSE(made_elastic);
  EXPECT_DOUBLE_EQ(meet(0, 3, std::nextafter(0.5, 0.0)), 1);
}

TEST_F(ContactDuration, HoldsForAClockThatStandsOrGoesBack) {
  EXPECT_DOUBLE_EQ(meet(0, 1, 0.25), 0.2);
  EXPECT_DOUBLE_EQ(meet(0, 1, 0.25), 1);
  EXPECT_DOUBLE_EQ(meet(0, 1, std::nextafter(0.25, 0.0)), 1);
}

TEST_F(ContactDuration, CountsABounceOffAWallAsACollision) {
  auto bounce = contact_of<1>(0, 4, 0.25);
  const Walls<double> walls{.restitution = 0.5};
  law.bounce(bounce, walls, 1, {{1.0}}, {alike});
  EXPECT_EQ(bounce.change[0], -1.5);
  EXPECT_FALSE(bounce.made_elastic);
  EXPECT_DOUBLE_EQ(meet(0, 1, 0.26), 1);
  bounce.time.remainder = 0.27;
  law.bounce(bounce, walls, 1, {{1.0}}, {alike});
  EXPECT_EQ(bounce.change[0], -2);
  EXPECT_TRUE(bounce.made_elastic);
}

TEST(ContactLaw, LeavesAPairThatRecedesByRoundingAlone) {
  ContactLaw<2, double> law({.restitution = 0.2, .models = {.rotation_angle = 0.1}}, 2, 1.0);
  auto collision = contact_of<2>(0, 1);
  law.collide(collision, motion_of<2>({{1e-17, 1.0}}), {alike});
  EXPECT_EQ(collision.impact.impulse, 0);
  EXPECT_EQ(law.counts().collisions, 0);
}

TEST(ContactLaw, CountsTheRestitutionThatWasUsed) {
  const ViscoelasticRestitution<double> restitution(0.3);
  ContactLaw<1, double> law({.restitution = 0, .models = {.law = restitution}}, 2, 1.0);
  auto collision = contact_of<1>(0, 1);
  law.collide(collision, motion_of<1>({{-0.5}}), {alike});
  EXPECT_DOUBLE_EQ(restitution_of(collision), restitution(0.5));
  EXPECT_DOUBLE_EQ(law.counts().mean_restitution, restitution(0.5));
}

/// Kinetic energy of the relative motion of two unit masses.
double energy(const Vec<3, double>& dv) { return dot(dv, dv) / 4; }

TEST(FixedLoss, IsTakenFromTheNormalMotionAlone) {
  const FixedLossRestitution<double> restitution(0.25);
  ContactLaw<3, double> law({.restitution = 0, .models = {.law = restitution}}, 2, 1.0);
  Dice dice(5);
  int energetic = 0;
  for (int n = 0; n < 2000; ++n) {
    const Vec<3, double> dv{
        {-dice.between(0, 3), dice.between(-9, 9), dice.between(-9, 9)}};  // the normal is along x
    auto collision = contact_of<3>(0, 1);
    law.collide(collision, motion_of<3>(dv), {alike});
    const auto after = dv - collision.change * 2.0;  // each sphere takes half of it
    const bool loses = dv[0] < -1;                   // dv^2/4 > 0.25
    EXPECT_NEAR(energy(dv) - energy(after), loses ? 0.25 : 0, 2e-14) << dv[0];
    EXPECT_EQ(after[1], dv[1]);
    EXPECT_EQ(after[2], dv[2]);
    EXPECT_GT(after[0], 0);
    energetic += loses;
  }
  EXPECT_GT(energetic, 1000);
}

TEST(FixedLoss, IsNotTakenFromAContactThatLasts) {
  const FixedLossRestitution<double> restitution(0.0625);
  ContactLaw<1, double> law(
      {.restitution = 0, .models = {.law = restitution, .contact_duration = 1}}, 3, 1.0);
  auto first = contact_of<1>(0, 1, 5);
  law.collide(first, motion_of<1>({{-1.0}}), {alike});
  EXPECT_DOUBLE_EQ(restitution_of(first), std::sqrt(0.75));
  auto second = contact_of<1>(1, 2, 5.5);
  law.collide(second, motion_of<1>({{-1.0}}), {alike});
  EXPECT_DOUBLE_EQ(restitution_of(second), 1);
  EXPECT_DOUBLE_EQ(law.counts().mean_restitution, (1 + std::sqrt(0.75)) / 2);
}

TEST(TwoValues, ApplyToTheNormalSpeedAlone) {
  const TwoValuedRestitution<double> restitution{0.25, 0.75, 1};
  ContactLaw<3, double> law({.restitution = 0, .models = {.law = restitution}}, 2, 1.0);
  for (const double speed : {0.5, 0.999, 1.0, 4.0}) {
    auto collision = contact_of<3>(0, 1);
    law.collide(collision, motion_of<3>({{-speed, 10, -10}}), {alike});
    EXPECT_DOUBLE_EQ(2 * collision.impact.impulse / speed, speed < 1 ? 1.25 : 1.75) << speed;
  }
}

/// Relative velocities after collisions at random directions, without and with the rotation.
template <int Dim>
struct Turned {
  Vec<Dim, double> before, after;
};
template <int Dim>
std::vector<Turned<Dim>> turned_velocities(double most, double restitution, int count) {
  ContactLaw<Dim, double> law(
      {.restitution = restitution, .models = {.rotation_angle = most, .seed = 3}}, 2, 1.0);
  Dice dice(7);
  std::vector<Turned<Dim>> turned;
  for (int n = 0; n < count; ++n) {
    Vec<Dim, double> dv;
    for (int axis = 0; axis < Dim; ++axis) dv[axis] = dice.between(-1, 1);
    dv[0] = -std::abs(dv[0]);
    auto collision = contact_of<Dim>(0, 1);
    const auto smooth = impact(motion_of<Dim>(dv), restitution);
    const auto plain = dv + smooth.normal * (2 * smooth.impulse);
    law.collide(collision, motion_of<Dim>(dv), {alike});
    turned.push_back({plain, dv - collision.change * 2.0});
  }
  EXPECT_EQ(law.counts().rotated, count);
  return turned;
}

template <int Dim>
void expect_same_speed_and_receding() {
  for (const auto& [before, after] : turned_velocities<Dim>(1.0, 0.3, 2000)) {
    // The pair gives and takes the same change, so that momentum is safe; its energy is |dv|^2/4.
    EXPECT_NEAR(dot(after, after), dot(before, before), 4e-15);
    EXPECT_GT(after[0], 0);  // the normal is along x
  }
}

TEST(Rotation, KeepsTheRelativeSpeedAndThePairReceding) {
  expect_same_speed_and_receding<2>();
  expect_same_speed_and_receding<3>();
}

/// Angle between two vectors of one length, radians, from the chord: good to small angles.
template <int Dim>
double angle_between(const Turned<Dim>& turned) {
  const auto chord = turned.after - turned.before;
  return 2 * std::asin(std::sqrt(dot(chord, chord) / dot(turned.before, turned.before)) / 2);
}

template <int Dim>
void expect_uniform_angles() {
  const double most = 0.01;
  std::vector<int> bins(10);
  int inside = 0;
  for (const auto& turned : turned_velocities<Dim>(most, 0.9, 40000)) {
    if (turned.before[0] < 0.02) continue;  // nearly grazing: some rotations are refused
    const double angle = angle_between(turned);
    ASSERT_LE(angle, most * (1 + 1e-9));
    ++bins[static_cast<std::size_t>(std::min(9.0, 10 * angle / most))];
    ++inside;
  }
  for (const int bin : bins) {  // five standard errors of a binomial count
    EXPECT_NEAR(bin, inside / 10.0, 5 * std::sqrt(0.09 * inside));
  }
}

TEST(Rotation, AnglesAreUniformUpToTheLargest) {
  expect_uniform_angles<2>();
  expect_uniform_angles<3>();
}

TEST(Rotation, HasNoPreferredSenseAboutTheVelocity) {
  double sense = 0;
  int count = 0;
  for (const auto& [before, after] : turned_velocities<2>(0.01, 0.9, 20000)) {
    if (before[0] < 0.02) continue;
    sense += before[0] * after[1] - before[1] * after[0] > 0 ? 1 : -1;
    ++count;
  }
  EXPECT_NEAR(sense, 0, 5 * std::sqrt(count));
  Vec<3, double> mean;  // sideways displacement, in units of the largest
  for (const auto& [before, after] : turned_velocities<3>(0.01, 0.9, 20000)) {
    if (before[0] < 0.02) continue;
    mean += (after - before) * (100 / std::sqrt(dot(before, before)));
  }
  // Its components have a variance of 1/9; an axis along the velocity would not.
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(mean[axis], 0, 5 * std::sqrt(20000 / 9.0));
}

TEST(Rotation, IsTheSameForTheSameSeed) {
  const auto one = turned_velocities<3>(0.1, 0.5, 10);
  const auto other = turned_velocities<3>(0.1, 0.5, 10);
  for (std::size_t n = 0; n < one.size(); ++n) EXPECT_EQ(one[n].after, other[n].after);
}

TEST(Rotation, OfAPairWithoutRelativeVelocityDoesNothing) {
  ContactLaw<3, double> law({.restitution = 0, .models = {.rotation_angle = 0.1}}, 2, 1.0);
  auto collision = contact_of<3>(0, 1);  // perfectly inelastic, head on
  law.collide(collision, motion_of<3>({{-1.0, 0.0, 0.0}}), {alike});
  EXPECT_EQ(collision.change, (Vec<3, double>{{-0.5, 0.0, 0.0}}));
  EXPECT_EQ(law.counts().rotated, 0);
}

}  // namespace
}  // namespace zenosphere
