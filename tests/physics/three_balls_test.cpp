#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/simulation.hpp"

namespace zenosphere {
namespace {

constexpr double wide_side = 100;

/// Three balls along x at 0, 1 and 3 with speeds 1, 0 and 1/8; the middle one moves along the last
/// axis with the speed `sideways`, the outer ones with half of that the other way.
template <int Dim>
Simulation<Dim, double> three_balls(double restitution, double sideways) {
  const double along[] = {40, 41, 43};
  const double speed[] = {1, 0, 0.125};
  const double across[] = {-0.5, 1, -0.5};
  Vec<Dim, double> sides;
  Configuration<Dim, double> start;
  for (int ball = 0; ball < 3; ++ball) {
    Vec<Dim, double> position;
    for (int axis = 0; axis < Dim; ++axis) {
      sides[axis] = wide_side;
      position[axis] = 50;
    }
    position[0] = along[ball];
    Vec<Dim, double> velocity;
    velocity[0] = speed[ball];
    if constexpr (Dim > 1) velocity[Dim - 1] = sideways * across[ball];
    start.positions.push_back(position);
    start.velocities.push_back(velocity);
  }
  return {ShearBox<Dim, double>(sides, 0), start, {restitution}};
}

/// Collisions up to and with the first after a gap of at most 1e-16 (but the very first), or until
/// the balls part: then `collapsed` is false.
struct End {
  std::int64_t collisions;
  bool collapsed;
};
template <int Dim>
End end_of(double restitution, double sideways) {
  auto balls = three_balls<Dim>(restitution, sideways);
  while (const auto collision = balls.next_collision(30)) {
    if (collision->number > 1 && collision->gap_before <= 1e-16) return {collision->number, true};
  }
  EXPECT_TRUE(balls.has_reached(30));
  return {balls.collisions(), false};
}

/// Growth per collision of kappa = (w t)^2/gap, twice the gap that the sideways motion opens in a
/// flight over the gap itself: w the speed across the line of centres of the pair that comes next,
/// t its flight. From and to must be both even or both odd: the same pair.
template <int Dim>
double growth_of_sideways_motion(double restitution, int from, int to) {
  auto balls = three_balls<Dim>(restitution, 1e-4);
  double first = 0;
  double kappa = 0;
  for (int n = 1; n <= to; ++n) {
    const auto collision = balls.next_collision(30).value();
    const auto relative =
        balls.peculiar_velocity(collision.j) - balls.peculiar_velocity(collision.i);
    const auto across = relative - collision.impact.normal * dot(relative, collision.impact.normal);
    const double distance = std::sqrt(dot(across, across)) * collision.flight;
    kappa = distance * distance / collision.gap_before;
    if (n == from) first = kappa;
  }
  return std::pow(kappa / first, 1.0 / (to - from));
}

// The same rational case as in three dimensions: with restitution 0.05 each collision scales the
// relative speed by 0.4, the gap by 0.125 and the flight by 0.3125.
template <int Dim>
void expect_rational_factors() {
  auto balls = three_balls<Dim>(0.05, 0);
  EXPECT_EQ(balls.next_collision(30).value().impact.normal_speed, 1);
  double speed = 1;
  double gap = 1;
  double flight = 2.5;
  for (int n = 2; n <= 12; ++n) {
    const auto collision = balls.next_collision(30).value();
    speed *= 0.4;
    // A coordinate near 42 is good to 7e-15; a flight is a gap over a speed.
    EXPECT_NEAR(collision.impact.normal_speed, speed, 1e-14) << n;
    EXPECT_NEAR(collision.gap_before, gap, 5e-14) << n;
    EXPECT_NEAR(collision.flight, flight, 5e-14 / speed + 1e-13) << n;
    gap *= 0.125;
    flight *= 0.3125;
  }
}

TEST(ThreeBallsInEachDimension, CollapseByTheSameFactorsInOneTwoAndThreeDimensions) {
  expect_rational_factors<1>();
  expect_rational_factors<2>();
  expect_rational_factors<3>();
}

// On a line the speeds shrink by a and the gaps by b, the roots of x^2 - (1 + e)/2 x + e, and so
// the flights by b/a. A speed w across the line stays, and opens w^2 t^2/2 in a flight t: relative
// to the gap that grows by (b/a)^2/b = e/a^3 a collision. It is 1 at e = 9 - 4 sqrt(5), the
// threshold of Zhou & Kadanoff, Phys. Rev. E 54 (1996) 623: below it the line is stable.
double exact_growth(double e) {
  const double sum = (1 + e) / 2;
  const double a = (sum + std::sqrt(sum * sum - 4 * e)) / 2;
  return e / (a * a * a);
}

template <int Dim>
void expect_threshold_of_zhou_and_kadanoff() {
  const double threshold = 9 - 4 * std::sqrt(5.0);
  EXPECT_NEAR(exact_growth(threshold), 1, 1e-13);  // ten roundings
  for (const double e : {0.05, 0.99 * threshold, 1.01 * threshold, 0.06}) {
    const double growth = growth_of_sideways_motion<Dim>(e, 8, 12);
    // Before the eighth collision the other root, b, has died out by (b/a)^8 < 1e-3; gaps of 1e-9
    // after the twelfth are good to 1e-5.
    EXPECT_NEAR(growth, exact_growth(e), 1e-3) << e;
    EXPECT_EQ(growth > 1, e > threshold) << e;
  }
}

TEST(ThreeBallsOnAPerturbedLine, CollapseStablyBelowTheThresholdOfZhouAndKadanoffOnly) {
  expect_threshold_of_zhou_and_kadanoff<2>();
  expect_threshold_of_zhou_and_kadanoff<3>();
}

// At e = 0.07 a gap scales by 0.23 and kappa by 2.4 a collision: from 1e-8 it reaches 1 after 20 of
// them, with the gap still above 1e-14. On the exact line the gap falls to 1e-16 after 25.
template <int Dim>
void expect_end_of_the_perturbed_line() {
  const End stable = end_of<Dim>(0.05, 1e-4);
  EXPECT_TRUE(stable.collapsed);
  // A coordinate near 50 is good to 7e-15: that is two collisions above 1e-16.
  EXPECT_NEAR(static_cast<double>(stable.collisions),
              static_cast<double>(end_of<Dim>(0.05, 0).collisions), 2);
  EXPECT_TRUE(end_of<Dim>(0.07, 0).collapsed);
  const End unstable = end_of<Dim>(0.07, 1e-4);
  EXPECT_FALSE(unstable.collapsed);
  EXPECT_LE(unstable.collisions, 20);
}

TEST(ThreeBallsOnAPerturbedLine, CollapseBelowBothThresholdsAndPartBetweenThem) {
  expect_end_of_the_perturbed_line<2>();
  expect_end_of_the_perturbed_line<3>();
}

}  // namespace
}  // namespace zenosphere
