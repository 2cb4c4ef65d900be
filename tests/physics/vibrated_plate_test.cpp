#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation.hpp"
#include "model/real.hpp"
#include "support/run_text.hpp"

namespace zenosphere {
namespace {

constexpr double pi_ = std::numbers::pi;

/// A ball on a plate that oscillates as a sine with the angular frequency 1, under gravity 1.
struct Plate {
  double restitution;
  double peak;  ///< acceleration of the plate / gravity: its amplitude too
  double resting_flight = 1e-5;

  Walls<double> walls(OscillationShape shape = OscillationShape::sinusoidal) const {
    Walls<double> walls{.axis = 0, .restitution = restitution};
    walls.oscillation.emplace(shape, peak, 2 * pi_);
    walls.resting_flight = resting_flight * 2 * pi_;
    return walls;
  }
  double height(double time) const { return peak * (1 - std::cos(time)); }
  double speed(double time) const { return peak * std::sin(time); }

  friend void PrintTo(const Plate& plate, std::ostream* out) {
    *out << "e = " << plate.restitution << ", peak acceleration = " << plate.peak;
  }
};

Simulation<1, double> ball_on(const Walls<double>& walls, double place, double velocity) {
  const ShearBox<1, double> box({100}, 0, 1.5, 0);
  Configuration<1, double> start{{{place}}, {{velocity}}};
  const Surroundings<1, double> surroundings{{-1.0}, walls};
  return Simulation<1, double>(box, start, {}, surroundings);
}

TEST(BallOfWax, NeverLeavesAPlateThatIsAcceleratedByLessThanGravity) {
  const Plate plate{0, 0.9, 1e-4};
  auto ball = ball_on(plate.walls(), 0.5 + 1e-3, 0);
  double highest = 0;
  double from = 0;
  while (!ball.has_reached(40 * pi_)) {
    const auto collision = ball.next_collision(40 * pi_);
    if (!collision) continue;
    if (from > 0) highest = std::max(highest, static_cast<double>(collision->gap_before));
    from = ball.time();
  }
  // Its flights last 1e-4 periods: pull x (2 pi 1e-4)^2 / 8 with a pull of 1.9 at most.
  EXPECT_LT(highest, 1.9 * std::pow(2 * pi_ * 1e-4, 2) / 8 * 1.001);
  EXPECT_GT(highest, 0);
  EXPECT_NEAR(ball.configuration().positions[0][0], 0.5 + plate.height(40 * pi_), 2e-7);
}

/// The first root of a function after `from` where it changes sign, by steps and bisection.
template <class Function>
double root_after(double from, Function function) {
  double low = from;
  while (function(low + 1e-3) > 0) low += 1e-3;
  double high = low + 1e-3;
  for (int n = 0; n < 60; ++n) {
    const double middle = (low + high) / 2;
    (function(middle) > 0 ? low : high) = middle;
  }
  return high;
}

class Takeoff : public testing::TestWithParam<double> {};

// The plate lets it go where its acceleration is -g: peak cos t = -1. In the convention of a height
// A sin(phase), where the phase is t - pi/2, at sin(phase) = g/(A w^2).
TEST_P(Takeoff, OfABallOfWaxComesWhereThePlateFallsAsFastAsTheBall) {
  const Plate plate{0, GetParam()};
  const double takeoff = std::acos(-1 / plate.peak);
  const double landing = root_after(takeoff + 0.1, [&](double time) {
    const double flight = time - takeoff;
    return plate.height(takeoff) + plate.speed(takeoff) * flight - flight * flight / 2 -
           plate.height(time);
  });
  auto ball = ball_on(plate.walls(), 0.5 + 1e-3, 0);
  double last = 0;
  double left = 0;
  double back = 0;
  while (back == 0) {
    const auto collision = ball.next_collision(1e3);
    if (!collision) continue;
    if (ball.time() > 1.5 && ball.time() - last > 0.1) {
      left = last;
      back = ball.time();
    }
    last = ball.time();
  }
  // It leaves within one of its flights, 6e-5 long; what that changes of the landing is smaller.
  EXPECT_NEAR(left, takeoff, 1e-4);
  EXPECT_NEAR(back, landing, 1e-4);
}
INSTANTIATE_TEST_SUITE_P(Peaks, Takeoff, testing::Values(1.2, 1.7, 2.5, 3.0));

TEST(BallOfWax, LeavesAPlateOfParabolasAtTheEndOfAQuarterOfAPeriod) {
  // Accelerated by 1.5, then by -1.5, against gravity 1: the gap opens with 0.5 for half a period
  // and closes with 2.5 from there on.
  constexpr double period = 2 * pi_;
  constexpr double peak = 1.5;
  Walls<double> walls{.axis = 0, .restitution = 0};
  walls.oscillation.emplace(OscillationShape::parabolic, peak * period * period / 32, period);
  walls.resting_flight = 1e-5 * period;
  auto ball = ball_on(walls, 0.5 + 1e-3, 0);
  const double gap = 0.25 * std::pow(period / 2, 2);
  const double rate = 0.5 * period / 2;
  const double landing = 0.75 * period + (rate + std::sqrt(rate * rate + 5 * gap)) / 2.5;
  double last = 0;
  double left = 0;
  while (left == 0) {
    const auto collision = ball.next_collision(1e3);
    if (!collision) continue;
    if (last > 1 && ball.time() - last > 0.1) left = last;
    last = ball.time();
  }
  EXPECT_NEAR(left, period / 4, 1e-4);
  EXPECT_NEAR(last, landing, 2e-4);
}

class OnePeriod : public testing::TestWithParam<Plate> {};

// Thrown up as high each time, the ball flies for a period: v = g T/2, so that the plate has the
// speed (g T/2)(1 - e)/(1 + e) at each contact. Holmes, J. Sound Vib. 84 (1982) 173; Luck & Mehta,
// Phys. Rev. E 48 (1993) 3988. In the second quarter of the phase it is stable for peaks between
// pi (1 - e)/(1 + e) and the root of the squares of that and of 2 (1 + e^2)/(1 + e)^2.
TEST_P(OnePeriod, BouncesComeAtTheirKnownPhase) {
  const Plate& plate = GetParam();
  const double e = plate.restitution;
  const double phase = pi_ - std::asin(pi_ * (1 - e) / (1 + e) / plate.peak);
  const double since = 2 * pi_ - phase;  // time 0, after the take-off before the first contact
  const double place = 0.5 + plate.height(phase) + pi_ * since - since * since / 2;
  auto ball = ball_on(plate.walls(), place + 1e-3, pi_ - since);
  for (int bounce = 0; bounce < 400; ++bounce) {
    const auto collision = ball.next_collision(1e9).value();
    if (bounce < 300) continue;
    EXPECT_NEAR(std::fmod(ball.time(), 2 * pi_), phase, 1e-9) << bounce;
    EXPECT_NEAR(collision.impact.normal_speed, 2 * pi_ / (1 + e), 1e-9) << bounce;
  }
}
INSTANTIATE_TEST_SUITE_P(Plates, OnePeriod,
                         testing::Values(Plate{0.5, 1.3}, Plate{0.8, 0.8}, Plate{0.3, 2.0},
                                         Plate{0.8, 0.5}));

TEST(BouncingBallAbovePeriodDoubling, ComesBackToItsPhaseEverySecondTime) {
  // e = 0.5: the state of one period is stable up to a peak of sqrt((pi/3)^2 + (10/9)^2) = 1.527.
  for (const double peak : {1.5, 1.56}) {
    const Plate plate{0.5, peak};
    const double phase = pi_ - std::asin(pi_ / 3 / peak);
    const double since = 2 * pi_ - phase;
    const double place = 0.5 + plate.height(phase) + pi_ * since - since * since / 2;
    auto ball = ball_on(plate.walls(), place + 1e-3, pi_ - since);
    std::vector<double> phases;
    for (int bounce = 0; bounce < 3000; ++bounce) {
      ball.next_collision(1e9).value();
      phases.push_back(std::fmod(ball.time(), 2 * pi_));
    }
    EXPECT_NEAR(phases[2999], phases[2997], 1e-8) << peak;
    EXPECT_EQ(std::abs(phases[2999] - phases[2998]) > 0.1, peak > 1.527) << peak;
  }
}

/// Balls above a plate.
std::string column(int dimension, const std::string& more) {
  const char* const axes[] = {"x", "y", "z"};
  const std::string sides[] = {"40", "6, 30", "5, 5, 30"};
  const std::string gravity[] = {"-1", "0, -1", "0, 0, -1"};
  return fmt::format(R"(
[system]
dimension = {}
spheres = {}
restitution = 0.95
sides = [{}]
[start]
arrangement = "random"
granular_temperature = 1
[drive]
kind = "none"
[gravity]
acceleration = [{}]
[run]
time = 100
collisions = 20000
[walls]
axis = "{}"
restitution = 0.95
amplitude = 0.4
frequency = 0.5
{}
)",
                     dimension, dimension == 1 ? 8 : 30, sides[dimension - 1],
                     gravity[dimension - 1], axes[dimension - 1], more);
}

TEST(VibratedColumn, ClosesItsLedgerInEveryDimensionAndShape) {
  for (const int dimension : {1, 2, 3}) {
    for (const std::string shape : {"sinusoidal", "parabolic"}) {
      const Summary run = test::run_text(column(dimension, "motion = \"" + shape + '"'));
      EXPECT_LT(run.ledger_error, 1e-11) << dimension << shape;
      EXPECT_EQ(run.verdict, Verdict::none) << dimension << shape;
      ASSERT_TRUE(run.averages);
      ASSERT_EQ(run.averages->wall_work.size(), 2U);
      EXPECT_GT(run.averages->wall_work[0], 0) << dimension << shape;
      EXPECT_EQ(run.averages->wall_work[1], 0) << dimension << shape;
      EXPECT_FALSE(run.self_check) << dimension << shape;
    }
  }
}

const char* const settling_ball_case = R"(
[system]
dimension = 1
spheres = 1
restitution = 1
sides = [10]
[start]
arrangement = "given"
positions = [1]
velocities = [0]
[drive]
kind = "none"
[walls]
axis = "x"
restitution = 0.5
motion = "sinusoidal"
amplitude = 0.5
frequency = 0.1
[gravity]
acceleration = [-1]
[collapse]
window = 100
[run]
time = 100
)";

// Peak acceleration 0.5 (0.2 pi)^2 = 0.197: once its bounces have ended it stays on the plate.
TEST(ABallThatHasSettledOnThePlate, IsNoArrestAndMeetsNoSeparation) {
  const Summary run = test::run_text(settling_ball_case);
  EXPECT_EQ(run.verdict, Verdict::none);
  EXPECT_EQ(run.separation.hits, 0);
  EXPECT_FALSE(run.arrest.met);
  EXPECT_EQ(run.ended_by, EndedBy::time);
  EXPECT_GT(run.collisions, 50000);  // 1e-4 of a period each
  EXPECT_LT(run.ledger_error, 1e-10);
}

// A plate that hardly moves is a floor: the ball falls by 1.5, bounces for 2 sqrt(3) / (1 - 0.5) =
// 7 time units, and stays. Its hops start with less than pi 1e-4 sqrt(2) sqrt(A).
TEST(ABallThatHasSettledOnAPlate, GetsNoEnergyHoweverSlowThePlate) {
  for (const auto& [amplitude, frequency] :
       std::vector<std::pair<double, double>>{{0.01, 1e-5}, {0.5, 1e-7}, {0.5, 1e-30}}) {
    const Summary run = test::run_text(
        settling_ball_case,
        {"start.positions=[2]", fmt::format("walls.amplitude={}", amplitude),
         fmt::format("walls.frequency={}", frequency), "run.time=20", "measure.after_time=12"});
    EXPECT_LT(run.averages.value().granular_temperature, 2e-7 * amplitude) << frequency;
    EXPECT_NEAR(run.averages->wall_work[0], 0, 1e-7) << frequency;
    EXPECT_EQ(run.verdict, Verdict::none) << frequency;
  }
}

TEST(ABallThatMayNotRest, IsArrestedWhereItsBouncesEnd) {
  const Summary run = test::run_text(settling_ball_case, {"walls.resting_flight=0"});
  EXPECT_EQ(run.verdict, Verdict::arrested);
  EXPECT_EQ(run.ended_by, EndedBy::arrest);
  ASSERT_EQ(run.arrest.pairs.size(), 1U);
  EXPECT_EQ(run.arrest.pairs[0], (std::pair<std::int64_t, std::int64_t>(0, 1)));
  EXPECT_LT(run.time, 10);
}

TEST(ABallOnThePlate, BouncesAtTheSameTimesInMoreDigits) {
  // Five bounces of a trajectory whose errors grow by less than ten at each.
  const Plate plate{0.8, 2.0};
  auto ball = ball_on(plate.walls(), 2, 0);
  const ShearBox<1, Quad> box({Quad(100)}, Quad(0), Quad(1.5), 0);
  Walls<Quad> walls{.axis = 0, .restitution = Quad(0.8)};
  walls.oscillation.emplace(OscillationShape::sinusoidal, Quad(2), Quad(2 * pi_));
  Configuration<1, Quad> start{{{Quad(2)}}, {{Quad(0)}}};
  const Surroundings<1, Quad> surroundings{{Quad(-1)}, walls};
  Simulation<1, Quad> exact(box, start, {}, surroundings);
  for (int bounce = 0; bounce < 5; ++bounce) {
    ball.next_collision(100).value();
    exact.next_collision(100).value();
    EXPECT_NEAR(ball.time(), exact.time(), 1e-11) << bounce;
  }
}

}  // namespace
}  // namespace zenosphere
