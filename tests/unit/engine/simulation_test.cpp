#include "engine/simulation.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/start.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using Line = Simulation<1, double>;
using Plane = Simulation<2, double>;

// Centres at 4 and 5 - 1e-15 (9 half ulps of 2^-52 x 4) that close with speed 1, and a third sphere
// that meets the second at time 2.
Line overlapping(OverlapRule rule, double guard = 1e-15, double speed = 1) {
  return Line(ShearBox<1, double>({20}, 0), {{{4}, {5 - 1e-15}, {10}}, {{speed}, {0}, {0}}},
              {.restitution = 1, .overlap = rule, .guard = guard});
}

TEST(OverlapRules, RewindCollidesWhereTheFormulaSays) {
  Line line = overlapping(OverlapRule::rewind);
  const auto collision = line.next_collision(10).value();
  EXPECT_TRUE(collision.overlapping);
  EXPECT_NEAR(line.time(), -1e-15, 4.5e-16);  // half an ulp of 5
  EXPECT_LT(line.time(), 0);
  EXPECT_EQ(line.peculiar_velocity(1)[0], 1);
}

TEST(OverlapRules, ImmediateCollidesNow) {
  Line line = overlapping(OverlapRule::immediate);
  const auto collision = line.next_collision(10).value();
  EXPECT_TRUE(collision.overlapping);
  EXPECT_EQ(line.time(), 0);
  EXPECT_EQ(collision.flight, 0);
  EXPECT_EQ(line.peculiar_velocity(1)[0], 1);
}

TEST(OverlapRules, GuardedLetsASlowPairPassAndCountsIt) {
  // dr.dv = -(1 - 1e-15): collides now with a small guard; is left alone with a large one.
  Line collides = overlapping(OverlapRule::guarded);
  EXPECT_EQ(collides.next_collision(10).value().i, 0);
  EXPECT_EQ(collides.time(), 0);
  EXPECT_EQ(collides.overlaps_ignored(), 0);
  Line passes = overlapping(OverlapRule::guarded, 1.5);
  const auto collision = passes.next_collision(10).value();
  EXPECT_EQ(collision.i, 0);  // through the second to the third, 5 away, at speed 1
  EXPECT_EQ(collision.j, 2);
  EXPECT_NEAR(passes.time(), 5, 1e-14);
  EXPECT_GE(passes.overlaps_ignored(), 1);
}

TEST(OverlapRules, StopEndsTheRunBeforeTheCollision) {
  Line line = overlapping(OverlapRule::stop, 1e-15, 0);
  line.wait_until(1);
  line.kick({{1}, {0}, {0}});
  EXPECT_EQ(line.next_collision(10).error(), NoCollision::overlap);
  ASSERT_TRUE(line.stopped_before());
  EXPECT_EQ(line.stopped_before()->i, 0);
  EXPECT_EQ(line.stopped_before()->j, 1);
  EXPECT_NEAR(line.stopped_before()->gap, -1e-15, 4.5e-16);
  EXPECT_EQ(line.next_collision(10).error(), NoCollision::overlap);
  EXPECT_EQ(line.collisions(), 0);
  EXPECT_EQ(line.peculiar_velocity(0)[0], 1);
}

TEST(OverlapRules, StopLetsSpheresCollideThatStartInContact) {
  Line line = overlapping(OverlapRule::stop);
  EXPECT_EQ(line.next_collision(10).value().i, 0);
  EXPECT_FALSE(line.stopped_before());
  EXPECT_EQ(line.peculiar_velocity(1)[0], 1);
}

TEST(OverlapRules, DoNotTouchSpheresThatSeparate) {
  for (const auto rule :
       {OverlapRule::rewind, OverlapRule::immediate, OverlapRule::guarded, OverlapRule::stop}) {
    Line line = overlapping(rule, 1e-15, -0.001);
    EXPECT_EQ(line.next_collision(1).error(), NoCollision::up_to_time);
    EXPECT_FALSE(line.stopped_before());
    EXPECT_TRUE(line.has_reached(1));
  }
}

TEST(Simulation, IsAtRestWhereNothingMovesAndNoLongerAfterAKick) {
  Line line(ShearBox<1, double>({20}, 0, 4), {{{4}, {8}}, {{0}, {0}}}, {0.5});
  EXPECT_FALSE(line.is_at_rest());  // not looked at yet
  EXPECT_EQ(line.next_collision(5).error(), NoCollision::at_rest);
  EXPECT_TRUE(line.is_at_rest());
  line.kick({{1}, {-1}});
  ASSERT_TRUE(line.next_collision(5));
  EXPECT_FALSE(line.is_at_rest());
  EXPECT_NEAR(line.time(), 1.5, 1e-15);  // a gap of 3 at speed 2
}

TEST(Simulation, ComesBackWithoutACollisionFromSpheresThatAreOnlyFollowed) {
  // Two disks on parallel lines 4 apart never meet: that is seen once they have met none for long.
  Plane disks(ShearBox<2, double>({20, 20}, 0), {{{4, 4}, {8, 8}}, {{1, 0}, {-1, 0}}}, {1.0});
  EXPECT_EQ(disks.collision_until(1e5).error(), NoCollision::for_a_while);
  EXPECT_GT(disks.time(), 1);
  EXPECT_LT(disks.time(), 1e5);
  auto reason = NoCollision::for_a_while;
  while (reason == NoCollision::for_a_while) reason = disks.collision_until(1e5).error();
  EXPECT_EQ(reason, NoCollision::at_rest);
}

TEST(Simulation, ClockStaysAtTheLastEventWhereNothingHappensUpToATime) {
  Line line(ShearBox<1, double>({40}, 0, 8), {{{4}, {11}}, {{1}, {-1}}}, {1.0});
  const auto none = line.collision_until(1e-3);
  EXPECT_EQ(none.error(), NoCollision::up_to_time);
  EXPECT_THROW(none.value(), std::bad_optional_access);
  EXPECT_EQ(line.time(), 0);
}

TEST(Simulation, KickChangesTheVelocitiesNowAndWhatComesNext) {
  // Two rods that would meet at time 3 stop each other's approach half-way; then the other way
  // round.
  Line line(ShearBox<1, double>({40}, 0, 8), {{{4}, {11}}, {{1}, {-1}}}, {1.0});
  EXPECT_FALSE(line.next_collision(1.5));
  EXPECT_EQ(line.time(), 1.5);
  line.kick({{-2}, {3}});
  EXPECT_EQ(line.peculiar_velocity(0)[0], -1);
  EXPECT_EQ(line.peculiar_velocity(1)[0], 2);
  // Now 5.5 and 9.5 and apart at 3; around the ring of 40 the gap is 36 - 1.
  ASSERT_TRUE(line.next_collision(100));
  EXPECT_NEAR(line.time(), 1.5 + 35.0 / 3, 1e-14);
}

TEST(Simulation, TakesTheGapOfTheNextPairAtAKickThatCameSinceTheLastCollision) {
  // Elastic rods meet at time 1 and part with speed 2: at time 1.5 their gap is 1. The kick turns
  // them round, so that they meet again at time 2; a gap of 3 would be the way back past the kick.
  Line line(ShearBox<1, double>({20}, 0), {{{4}, {7}}, {{1}, {-1}}}, {1.0});
  ASSERT_TRUE(line.next_collision(1.5));
  ASSERT_FALSE(line.next_collision(1.5));
  line.kick({{2}, {-2}});
  const auto collision = line.next_collision(3).value();
  EXPECT_NEAR(collision.gap_before, 1, 1e-14);
  EXPECT_NEAR(collision.flight, 1, 1e-14);
}

TEST(Simulation, TakesTheGapToTheImageOfTheNextPairThatWillTouch) {
  // Elastic rods meet at time 1 and part; they meet again round the ring of 20. There are 18 to
  // close, though right after the collision they touch in another image.
  Line line(ShearBox<1, double>({20}, 0), {{{4}, {7}}, {{1}, {-1}}}, {1.0});
  ASSERT_TRUE(line.next_collision(30));
  const auto collision = line.next_collision(30).value();
  EXPECT_NEAR(collision.flight, 9, 1e-14);
  EXPECT_NEAR(collision.gap_before, 18, 1e-13);
}

TEST(Simulation, TakesTheGapAcrossASlidingFaceInTheImageThatWillTouch) {
  // Shear rate 1, both at rest in the mean flow. The lower image of the second disk, at (7, -0.25),
  // is 0.75 below the first and 6 ahead of it, and comes back at 0.75: contact at a distance along
  // x of sqrt(1 - 0.75^2).
  Plane disks(ShearBox<2, double>({10, 4}, 1, 2), {{{1, 0.5}, {7, 3.75}}, {{0, 0}, {0, 0}}}, {1.0});
  const auto collision = disks.next_collision(30).value();
  const double dx = std::sqrt(1 - 0.75 * 0.75);
  EXPECT_NEAR(disks.time(), (6 - dx) / 0.75, 1e-13);
  EXPECT_NEAR(collision.gap_before, std::sqrt(36 + 0.75 * 0.75) - 1, 1e-13);
}

TEST(Simulation, TakesTheHeightOfTheApexAsTheGapOfABallThatRises) {
  // Thrown from the floor at 2 with G = 1: 2 to fall. Then with e = 1/2 at 1: 1/2.
  Line ball(ShearBox<1, double>({100}, 0, 1.5, 0), {{{0.5}}, {{2}}}, {},
            {{-1}, Walls<double>{.axis = 0, .restitution = 0.5}});
  EXPECT_EQ(ball.next_collision(100)->gap_before, 2);
  EXPECT_NEAR(ball.next_collision(100)->gap_before, 0.5, 1e-15);
}

TEST(Simulation, TakesTheGapOfABallThatFallsFromWhereItWasAtTheLastCollision) {
  // Two disks bounce far apart: at 1 lands what was let go half a diameter up, at 2 the other one
  // from 2 up. At time 1 that is 2 - 1/2 = 3/2 up and falls.
  Plane disks(ShearBox<2, double>({20, 10}, 0, 1.5, 1), {{{5, 1}, {15, 2.5}}, {{0, 0}, {0, 0}}}, {},
              {{0, -1}, Walls<double>{.axis = 1, .restitution = 1}});
  ASSERT_EQ(disks.next_collision(10)->i, 0);
  const auto collision = disks.next_collision(10).value();
  ASSERT_EQ(collision.i, 1);
  EXPECT_NEAR(disks.time(), 2, 1e-15);
  EXPECT_NEAR(collision.gap_before, 1.5, 1e-15);
}

TEST(Simulation, StopsOnTheWayChangeNoCollisionWithWallsAndGravity) {
  const ShearBox<2, double> box({12, 12}, 0, 1.5, 1);
  const auto start = make_start<2>({Arrangement::random, 60, 1, 7}, box);
  const Surroundings<2, double> surroundings{{0.1, -0.5},
                                             Walls<double>{.axis = 1, .restitution = 0.9}};
  Plane straight(box, start, {0.95}, surroundings);
  Plane halting(box, start, {0.95}, surroundings);
  double until = 0;
  for (int n = 0; n < 1000; ++n) {
    const auto expected = straight.next_collision(1e3).value();
    auto collision = halting.next_collision(until);
    for (; !collision; collision = halting.next_collision(until)) until += 0.003;
    ASSERT_EQ(collision->i, expected.i) << n;
    ASSERT_EQ(collision->j, expected.j) << n;
    ASSERT_EQ(std::bit_cast<std::int64_t>(collision->flight),
              std::bit_cast<std::int64_t>(expected.flight))
        << n;
    ASSERT_EQ(collision->change, expected.change) << n;
  }
}

TEST(Simulation, OfMoreSpheresThanACacheHoldsKeepsItsEnergyAndLetsNoSpherePass) {
  constexpr int discs_a_row = 160;
  constexpr double spacing = 1.5;
  support::Dice dice{5};
  Configuration<2, double> start;
  for (int k = 0; k < discs_a_row * discs_a_row; ++k) {
    start.positions.push_back(
        {{spacing * (k % discs_a_row + 0.5), spacing * (k / discs_a_row + 0.5)}});
    start.velocities.push_back({{dice.between(-1, 1), dice.between(-1, 1)}});
  }
  const double side = discs_a_row * spacing;
  Plane gas(ShearBox<2, double>({side, side}, 0, spacing, 1), start, {1.0},
            {{}, Walls<double>{.axis = 1}});
  const auto energy = [&] {
    double twice = 0;
    for (std::int32_t i = 0; i < gas.spheres(); ++i) {
      twice += dot(gas.peculiar_velocity(i), gas.peculiar_velocity(i));
    }
    return twice / 2;
  };
  const double before = energy();
  while (gas.collisions() < 3 * gas.spheres()) {
    const auto collision = gas.next_collision(1e3);
    ASSERT_TRUE(!collision || collision->gap_before > -1e-11);
  }
  EXPECT_NEAR(energy(), before, 1e-11 * before);
}

TEST(Simulation, CallsACollisionAbsorbedThatIsBelowTheLastBitOfTheVelocities) {
  // For e = 0 the impulse is half the closing speed: for one ulp that is a tie.
  const double ulp = 0x1p-52;
  Line tie(ShearBox<1, double>({20}, 0), {{{4}, {5}}, {{1 + 2 * ulp}, {1 + ulp}}}, {0.0});
  EXPECT_FALSE(tie.next_collision(1e3).value().absorbed);  // the second goes to the even 1 + 2 ulp
  EXPECT_EQ(tie.peculiar_velocity(1)[0], 1 + 2 * ulp);
  // On the normal (0.6, 0.8) a difference of one ulp along x closes with 0.6 ulp; the impulse of
  // 0.3 ulp has the parts 0.18 and 0.24 ulp, below half an ulp of speeds from 1 to 2.
  Plane oblique(ShearBox<2, double>({20, 20}, 0),
                {{{4, 4}, {4.6, 4.8}}, {{1 + 2 * ulp, 1.5}, {1 + ulp, 1.5}}}, {0.0});
  const auto tiny = oblique.next_collision(1e3);
  ASSERT_TRUE(tiny);
  EXPECT_TRUE(tiny->absorbed);
  EXPECT_EQ(oblique.peculiar_velocity(0), (Vec<2, double>{{1 + 2 * ulp, 1.5}}));
  EXPECT_EQ(oblique.peculiar_velocity(1), (Vec<2, double>{{1 + ulp, 1.5}}));
}

}  // namespace
}  // namespace zenosphere
