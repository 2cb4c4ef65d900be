#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "run/random_driving.hpp"

namespace zenosphere {
namespace {

// A particle under white noise leaves a wall at speed 1 and comes back at speed w. If the mean of
// log(e w) is negative, its bounces shrink and it collapses onto the wall: below a restitution of
// exp(-mean log w) = exp(-pi/sqrt(3)) = 0.16303 (Cornell, Swift & Bray, Phys. Rev. Lett. 81 (1998)
// 1142). The law of w has the tail w^(-3/2), and flights of duration w^2: a simulation would need
// 10^12 kicks a flight to see the mean to a per cent. So the mean is taken from the exact density,
// and the engine is held against the density of the returns within a finite time, which is exact
// too (McKean, J. Math. Kyoto Univ. 2 (1963) 227).

/// Density of the return speed, with x = exp(s) and the Jacobian of s.
double density_of_log(double s) {
  return 3 / (2 * std::numbers::pi) * std::exp(2.5 * s) / (1 + std::exp(3 * s));
}

/// Density of a return at time t with speed w, per time and logarithm of the speed, for noise of
/// strength 1. McKean's integral over e^(-3 theta/2)/sqrt(pi theta) from 0 to 4 w/t is the error
/// function here.
double joint_density(double t, double w) {
  const double integral = std::sqrt(2.0 / 3) * std::erf(std::sqrt(6 * w / t));
  return w * 3 * w / (std::numbers::pi * std::numbers::sqrt2 * t * t) *
         std::exp(-2 * (1 - w + w * w) / t) * integral;
}

struct Returns {
  double share = 0;     ///< of the flights
  double mean_log = 0;  ///< mean over all flights of log w, those not counted taken as 0
};

/// Trapezoidal sums in log t and log w: exponentially accurate for such integrands.
Returns exact_returns_within(double time) {
  const double step = 0.02;
  Returns returns;
  for (double log_t = std::log(time); log_t > -5; log_t -= step) {
    const double t = std::exp(log_t);
    const double weight = (log_t == std::log(time) ? 0.5 : 1) * step * step * t;
    for (double log_w = -20; log_w < 8; log_w += step) {
      const double density = weight * joint_density(t, std::exp(log_w));
      returns.share += density;
      returns.mean_log += density * log_w;
    }
  }
  return returns;
}

TEST(RandomlyForcedParticle, CollapsesBelowTheKnownRestitution) {
  double total = 0;
  double mean = 0;
  const double step = 0.05;
  for (double s = -40; s < 160; s += step) {  // tails exp(2.5 s) and exp(-s/2): below 1e-34
    total += step * density_of_log(s);
    mean += step * s * density_of_log(s);
  }
  EXPECT_NEAR(total, 1, 1e-12);
  EXPECT_NEAR(mean, std::numbers::pi / std::sqrt(3.0), 1e-10);
  EXPECT_NEAR(std::exp(-mean), 0.16303, 5e-6);
}

TEST(RandomlyForcedParticle, HasTheReturnSpeedsOfTheJointDensityAtAnyTime) {
  // Summed over all times the joint density is that of the speeds: what links the two tests.
  for (const double w : {0.3, 1.0, 4.0}) {
    double sum = 0;
    const double step = 0.01;
    for (double log_t = -6; log_t < 40; log_t += step) {
      sum += step * std::exp(log_t) * joint_density(std::exp(log_t), w);
    }
    EXPECT_NEAR(sum, density_of_log(std::log(w)), 1e-10) << w;
  }
}

/// A mean over flights, with its standard error.
struct Sampled {
  Returns mean;
  Returns error;
};

/// Speed of a sphere as it comes back to the wall that it has left at speed 1, if it does so before
/// the last of the kicks; the other wall is far away.
std::optional<double> return_speed(RandomDriving<1, double>& driving, double interval, int kicks) {
  const ShearBox<1, double> box({1e6}, 0, 1e6, 0);
  Simulation<1, double> particle(box, {{{0.5}}, {{1.0}}}, {}, {{}, Walls<double>{.axis = 0}});
  Measurements<1, double> measurements(particle, 0);
  for (int kick = 1; kick <= kicks; ++kick) {
    if (const auto hit = particle.next_collision(kick * interval)) return hit->impact.normal_speed;
    driving.kick(particle, measurements);
  }
  return std::nullopt;
}

/// \param kicks_per_time  each has the standard deviation kicks_per_time^(-1/2)
Sampled sampled_returns_within(int time, int kicks_per_time, int flights) {
  const double interval = 1.0 / kicks_per_time;
  Case values;
  values.system.dimension = 1;
  values.drive = {.kind = DriveKind::random, .noise_strength = 1, .kick_interval = interval};
  values.walls.axis = Axis::x;  // momentum is not removed
  RandomDriving<1, double> driving(values);
  double count = 0;
  double sum = 0;
  double squares = 0;
  for (int flight = 0; flight < flights; ++flight) {
    const auto speed = return_speed(driving, interval, time * kicks_per_time);
    if (!speed) continue;
    ++count;
    sum += std::log(*speed);
    squares += std::pow(std::log(*speed), 2);
  }
  const Returns mean{count / flights, sum / flights};
  return {mean,
          {std::sqrt(mean.share * (1 - mean.share) / flights),
           std::sqrt((squares / flights - mean.mean_log * mean.mean_log) / flights)}};
}

// The kicks are an eighth and a quarter of the launch speed. What they get wrong is of the order of
// the interval (of the share of returns 0.007, 0.002, 0.0005 at 16, 64 and 256 kicks), so that
// (4 fine - coarse)/3 is the limit of no interval.
TEST(RandomlyForcedParticle, ReturnsToTheWallAsTheExactDensitySays) {
  const int time = 20;
  const Returns exact = exact_returns_within(time);
  const Sampled coarse = sampled_returns_within(time, 16, 20000);
  const Sampled fine = sampled_returns_within(time, 64, 20000);
  const auto limit = [](double b, double a) { return (4 * b - a) / 3; };
  const auto error = [](double b, double a) { return std::hypot(4 * b, a) / 3; };
  EXPECT_NEAR(limit(fine.mean.share, coarse.mean.share), exact.share,
              5 * error(fine.error.share, coarse.error.share));
  EXPECT_NEAR(limit(fine.mean.mean_log, coarse.mean.mean_log), exact.mean_log,
              5 * error(fine.error.mean_log, coarse.error.mean_log));
}

}  // namespace
}  // namespace zenosphere
