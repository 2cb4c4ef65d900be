#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "engine/simulation.hpp"
#include "support/run_text.hpp"

namespace zenosphere {
namespace {

/// A ball that leaves the floor with `speed` along the last axis of `dimension`.
std::string thrown(int dimension, double speed, double gravity, double restitution,
                   double height = 0) {
  const char* const axes[] = {"x", "y", "z"};
  std::string zeros, tens, fives;
  for (int axis = 1; axis < dimension; ++axis) {
    zeros += "0, ";
    tens += "10, ";
    fives += "5, ";
  }
  return fmt::format(R"(
[system]
dimension = {0}
spheres = 1
restitution = 1
sides = [{7}100]
[start]
arrangement = "given"
positions = [[{8}{1}]]
velocities = [[{6}{2}]]
[drive]
kind = "none"
[walls]
axis = "{3}"
restitution = {4}
[gravity]
acceleration = [{6}{5}]
[collapse]
window = 1000
[run]
time = 1e4
collisions = 100000
)",
                     dimension, 0.5 + height, speed, axes[dimension - 1], restitution, -gravity,
                     zeros, tens, fives);
}

struct Throw {
  double speed, gravity, restitution;

  friend void PrintTo(const Throw& thrown, std::ostream* out) {
    *out << "v0 = " << thrown.speed << ", G = " << thrown.gravity << ", e = " << thrown.restitution;
  }
};

class BouncingBall : public testing::TestWithParam<Throw> {};

// Between bounces n - 1 and n passes 2 v0 e^(n-1)/G: in all (2 v0/G)/(1 - e). The clock is good to
// 1e-16 in each of at most 700 bounces (1e-17 = 0.95^700); arrest comes when a flight is below
// 1e-16, at most 1e-16/(1 - e) before the end.
TEST_P(BouncingBall, IsArrestedWhenTheSeriesOfItsBouncesEnds) {
  const auto& [speed, gravity, restitution] = GetParam();
  const Summary run = test::run_text(thrown(1, speed, gravity, restitution));
  const double end = 2 * speed / gravity / (1 - restitution);
  EXPECT_EQ(run.verdict, Verdict::arrested);
  EXPECT_EQ(run.ended_by, EndedBy::arrest);
  ASSERT_TRUE(run.arrest.met);
  EXPECT_NEAR(*run.arrest.time, end, 1e-12 * end);
  ASSERT_TRUE(run.arrest.extrapolated_time);
  EXPECT_NEAR(*run.arrest.extrapolated_time, end, 1e-12 * end);
  EXPECT_NEAR(*run.arrest.flight_ratio, restitution, 1e-3 * restitution);  // as alike as it asks
  ASSERT_EQ(run.arrest.pairs.size(), 1U);
  EXPECT_EQ(run.arrest.pairs[0], (std::pair<std::int64_t, std::int64_t>(0, 1)));
  EXPECT_LT(run.ledger_error, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Throws, BouncingBall,
                         testing::Values(Throw{1, 1, 0.5}, Throw{1, 1, 0.1}, Throw{1, 1, 0.9},
                                         Throw{3, 9.81, 0.7}, Throw{0.01, 2, 0.3},
                                         Throw{8, 0.5, 0.95}));

TEST(BouncingBallFromRest, IsArrestedAfterItsFallAndItsBounces) {
  // Falls 2 diameters at G = 1: reaches the floor after 2 at speed 2, leaves it with 1.2, and
  // bounces for 2 x 1.2/(1 - 0.6) = 6.
  const Summary run = test::run_text(thrown(1, 0, 1, 0.6, 2));
  ASSERT_TRUE(run.arrest.met);
  EXPECT_NEAR(*run.arrest.time, 8, 1e-12);
  EXPECT_NEAR(*run.arrest.extrapolated_time, 8, 1e-12);
}

TEST(BouncingBallElsewhere, IsArrestedAtTheSameTimeAlongYAndZ) {
  for (const int dimension : {2, 3}) {
    const Summary run = test::run_text(thrown(dimension, 1, 1, 0.5));
    ASSERT_TRUE(run.arrest.met) << dimension;
    EXPECT_NEAR(*run.arrest.time, 4, 4e-12) << dimension;
    EXPECT_NEAR(*run.arrest.extrapolated_time, 4, 4e-12) << dimension;
  }
}

TEST(BouncingBallUnderEveryRule, EndsNearTheEndOfTheSeries) {
  // A ball is put on the floor by each bounce, so that it never overlaps the floor and the rules
  // agree.
  for (const std::string rule : {"rewind", "immediate", "guarded", "stop"}) {
    const Summary run = test::run_text(thrown(1, 1, 1, 0.5), {"collision.overlap=" + rule});
    EXPECT_EQ(run.verdict, Verdict::arrested) << rule;
    ASSERT_TRUE(run.arrest.time) << rule;
    EXPECT_NEAR(*run.arrest.time, 4, 4e-12) << rule;
    EXPECT_EQ(run.overlap_collisions, 0) << rule;
    EXPECT_EQ(run.overlaps_ignored, 0) << rule;
  }
}

TEST(BouncingBallOfWax, IsArrestedAtItsFirstContact) {
  // Restitution 0: the ball has no speed after the first contact, at time 2.
  for (const std::string rule : {"rewind", "immediate"}) {
    const Summary run = test::run_text(thrown(1, 0, 1, 0, 2), {"collision.overlap=" + rule});
    EXPECT_EQ(run.ended_by, EndedBy::arrest) << rule;
    EXPECT_NEAR(run.time, 2, 1e-15) << rule;
  }
}

TEST(BouncingBallOfWax, StaysOnTheFloorWhileAnotherOneFalls) {
  // The lower rod comes to rest on the floor at time 1; the upper one would meet it at time 3, and
  // nothing else happens until then. Either the clock stands (arrest) or the rod must lie still.
  for (const auto rule : {OverlapRule::rewind, OverlapRule::immediate, OverlapRule::guarded}) {
    const ShearBox<1, double> box({100}, 0, 1.5, 0);
    Simulation<1, double> rods(box, {{{1.0}, {6.0}}, {{0.0}, {0.0}}}, {.overlap = rule},
                               {{-1.0}, Walls<double>{.axis = 0, .restitution = 0}});
    while (!rods.has_reached(2) && rods.collisions() < 1000) rods.next_collision(2);
    EXPECT_NEAR(rods.configuration().positions[0][0], 0.5, 1e-15) << static_cast<int>(rule);
  }
}

TEST(BouncingBallOfTheTcModel, NeverMeetsTheSeparationCriterion) {
  // Its bounces become elastic once they last less than 1e-3: at a height of 1.25e-7 at the most,
  // and above e^2 of that.
  const Summary run = test::run_text(thrown(1, 1, 1, 0.75),
                                     {"collision.contact_duration=1e-3", "run.collisions=20000"});
  EXPECT_EQ(run.verdict, Verdict::none);
  EXPECT_EQ(run.collisions, 20000);
}

TEST(BouncingBall, MeetsTheSeparationCriterionOnlyWhereItsBouncesAreThatLow) {
  // v^2/2 = 1e-16 at v = 1.4e-8: after ln(1.4e-8)/ln(0.5) = 26.07 bounces at v0 = 1, e = 1/2.
  // Bounce 27 is the first that is not left as high, with 2^-27, and bounce 28 follows it.
  const Summary run = test::run_text(thrown(1, 1, 1, 0.5));
  EXPECT_EQ(run.separation.first_collision, 27);
}

TEST(ABallThatHasSettled, StandsBesideAnotherOneThatStillFalls) {
  // The first lands at time 1 and bounces until 1 + 2 x 0.5 / 0.5 = 3; the second, let go 8
  // diameters up, would land at 4.
  const Summary run = test::run_text(thrown(2, 0, 1, 0.5, 0.5),
                                     {"system.spheres=2", "start.positions=[[2, 1], [7, 8.5]]",
                                      "start.velocities=[[0, 0], [0, 0]]"});
  EXPECT_EQ(run.verdict, Verdict::arrested);
  EXPECT_NEAR(run.time, 3, 1e-12);
  EXPECT_EQ(run.arrest.others_moving, 1);
}

TEST(BouncingBallStepByStep, LosesTheSameFractionOfItsSpeedAtEachBounce) {
  const double restitution = 0.7;
  const ShearBox<1, double> box({100}, 0, 1.5, 0);
  Simulation<1, double> ball(box, {{{0.5}}, {{2.0}}}, {},
                             {{-1.0}, Walls<double>{.axis = 0, .restitution = restitution}});
  double speed = 2;
  double end = 0;
  for (int bounce = 1; bounce <= 60; ++bounce) {
    const auto collision = ball.next_collision(100).value();
    end += 2 * speed;
    EXPECT_EQ(collision.i, 0);
    EXPECT_EQ(collision.j, 1);  // the lower wall
    EXPECT_EQ(ball.wall(collision.j), 0);
    // The clock is good to 1e-16, and so are speeds at G = 1.
    EXPECT_NEAR(collision.impact.normal_speed, speed, 1e-14) << bounce;
    EXPECT_NEAR(ball.time(), end, 1e-14) << bounce;
    // From contact to contact: the apex of the flight, v^2 / (2 G), to four ulps of each.
    EXPECT_NEAR(collision.gap_before, speed * speed / 2, 1e-14) << bounce;
    speed *= restitution;
    EXPECT_NEAR(ball.peculiar_velocity(0)[0], speed, 1e-14) << bounce;
  }
}

// Rods under gravity on a floor, given some speed each.
const char* const bouncing_column_case = R"(
[system]
dimension = 1
spheres = 4
restitution = 0.1
sides = [100]
[start]
arrangement = "given"
positions = [1, 2.25, 3.5, 5]
velocities = [0, 0.125, -0.0625, 0]
[drive]
kind = "none"
[walls]
axis = "x"
restitution = 0.1
[gravity]
acceleration = [-1]
[collapse]
window = 1000
[run]
time = 100
collisions = 1000000
)";

TEST(BouncingColumn, OfInelasticRodsIsArrestedOnTheFloor) {
  for (const std::string rule : {"rewind", "immediate", "guarded"}) {
    const Summary run = test::run_text(bouncing_column_case, {"collision.overlap=" + rule});
    EXPECT_EQ(run.verdict, Verdict::arrested) << rule;
    EXPECT_LT(run.ledger_error, 1e-10) << rule;
  }
}

}  // namespace
}  // namespace zenosphere
