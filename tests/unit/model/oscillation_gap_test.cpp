#include "model/oscillation_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/random.hpp"
#include "model/real.hpp"

namespace zenosphere {
namespace {

using Wide = long double;

/// A sphere above an oscillating wall, at the phase 0 of the clock of the case.
struct Flight {
  OscillationShape shape;
  double amplitude, period, phase;
  double gap, rate;  ///< now
  double pull;       ///< acceleration of the sphere

  /// Height of the wall by the library's cosine, or from the lowest or the highest place of its
  /// parabola.
  Wide wall(Wide time) const {
    Wide turns = (phase + time) / static_cast<Wide>(period);
    turns -= std::floor(turns);
    if (shape == OscillationShape::sinusoidal) {
      return amplitude * (1 - std::cos(2 * std::numbers::pi_v<Wide> * turns));
    }
    const Wide from_lowest = std::min(turns, 1 - turns);
    const Wide from_highest = std::abs(turns - 0.5L);
    return turns < 0.25L || turns > 0.75L
               ? 16 * amplitude * from_lowest * from_lowest
               : 2 * amplitude - 16 * amplitude * from_highest * from_highest;
  }
  Wide wall_speed() const {
    const Wide turns = phase / static_cast<Wide>(period);
    if (shape == OscillationShape::sinusoidal) {
      const Wide turning = 2 * std::numbers::pi_v<Wide>;
      return amplitude * turning / period * std::sin(turning * turns);
    }
    const Wide from_turn = turns < 0.25L ? turns : turns > 0.75L ? turns - 1 : 0.5L - turns;
    return 32 * amplitude / static_cast<Wide>(period) * from_turn;
  }
  Wide gap_at(Wide time) const {
    return gap + (rate + wall_speed()) * time + pull * time * time / 2 - (wall(time) - wall(0));
  }
  template <class Real>
  Oscillation<Real> oscillation() const {
    return {shape, Real(amplitude), Real(period)};
  }
};

double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

Flight any_flight(Random& random) {
  Flight flight{};
  flight.shape =
      random.uniform() < 0.5 ? OscillationShape::sinusoidal : OscillationShape::parabolic;
  flight.amplitude = std::pow(10, between(random, -2, 0));
  flight.period = std::pow(10, between(random, -1, 1));
  flight.phase = flight.period * random.uniform();
  const double speed = 8 * flight.amplitude / flight.period;
  const double acceleration = 32 * flight.amplitude / (flight.period * flight.period);
  const double kind = random.uniform();
  flight.gap = kind < 0.3 ? 0 : flight.amplitude * std::pow(10, between(random, -6, 0.5));
  flight.rate = speed * between(random, -1, 1) * std::pow(10, between(random, -4, 0.5));
  if (flight.gap == 0) flight.rate = std::abs(flight.rate);
  // Below and above the peak acceleration, without any, and away from the wall.
  flight.pull = -acceleration * (kind < 0.5   ? std::pow(10, between(random, -2, 1))
                                 : kind < 0.8 ? between(random, 0.5, 1.5)
                                 : kind < 0.9 ? 0
                                              : -between(random, 0, 1));
  return flight;
}

/// What one finds is compared with the gap at two thousand moments of up to a period: it must
/// not have been closed at any of them.
void expect_none_missed(const Flight& flight) {
  const auto oscillation = flight.oscillation<double>();
  const OscillationGap<double> gap(oscillation, flight.phase, flight.gap, flight.rate, flight.pull);
  const auto due = gap.due(0);
  const double scale = flight.amplitude + std::abs(flight.rate) * flight.period;
  ASSERT_GE(due.span, 0);
  constexpr int steps = 2000;
  const Wide end = std::min<Wide>(due.span, flight.period);
  for (int step = 1; step < steps; ++step) {
    ASSERT_GT(flight.gap_at(end * step / steps), -1e-13L * scale)
        << "at " << static_cast<double>(end * step / steps) << " of " << due.span;
  }
  if (due.is_contact) {
    EXPECT_NEAR(static_cast<double>(flight.gap_at(due.span)), 0, 1e-11 * scale);
    EXPECT_LE(gap.at(due.span).rate,
              1e-7 * (std::abs(flight.rate) + 8 * flight.amplitude / flight.period));
  } else {
    EXPECT_TRUE(due.span >= flight.period * (1 - 1e-12) ||
                gap.clearance(due.span) > OscillationGap<double>::out_of_reach(oscillation));
  }
}

TEST(OscillationGap, MissesNoContactOfThousandsOfFlights) {
  Random random(7);
  for (int trial = 0; trial < 2500; ++trial) {
    const Flight flight = any_flight(random);
    SCOPED_TRACE(trial);
    expect_none_missed(flight);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(OscillationGap, MissesNoContactThatOnlyJustComes) {
  // A sphere that hovers a little below the highest place of the wall: it comes for a short time.
  Random random(11);
  for (int trial = 0; trial < 500; ++trial) {
    Flight flight = any_flight(random);
    flight.pull = 0;
    flight.rate = 0;
    const double depth = std::pow(10, between(random, -14, -1));
    flight.gap = static_cast<double>(2 * flight.amplitude * (1 - depth) - flight.wall(0));
    const auto oscillation = flight.oscillation<double>();
    const double speed = oscillation.at(flight.phase).speed;
    if (!(flight.gap > 0)) continue;
    const OscillationGap<double> gap(oscillation, flight.phase, flight.gap, -speed, 0);
    const auto due = gap.due(0);
    EXPECT_TRUE(due.is_contact) << trial << ": " << depth;
    const auto wall = static_cast<double>(flight.wall(due.span) - flight.wall(0));
    EXPECT_NEAR(wall, flight.gap, 1e-13 * flight.amplitude) << trial << ": " << depth;
  }
}

TEST(OscillationGap, IsTheSameInMoreDigits) {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Flight flight = any_flight(random);
    const auto plain = flight.oscillation<double>();
    const auto wide = flight.oscillation<Quad>();
    const auto due =
        OscillationGap<double>(plain, flight.phase, flight.gap, flight.rate, flight.pull).due(0);
    const auto exact = OscillationGap<Quad>(wide, Quad(flight.phase), Quad(flight.gap),
                                            Quad(flight.rate), Quad(flight.pull))
                           .due(0);
    if (!due.is_contact || !exact.is_contact) continue;
    // A contact that only just comes is uncertain by the root of the rounding.
    EXPECT_NEAR(due.span, static_cast<double>(exact.span), 1e-7 * flight.period) << trial;
    EXPECT_NEAR(static_cast<double>(OscillationGap<Quad>(wide, Quad(flight.phase), Quad(flight.gap),
                                                         Quad(flight.rate), Quad(flight.pull))
                                        .at(exact.span)
                                        .gap),
                0, 1e-28)
        << trial;
  }
}

TEST(OscillationGap, OfAShortHopIsThatOfAParabola) {
  // Let go at the speed u where the wall pushes upwards with a and the sphere falls with g: back
  // after 2 u / (a + g). However short that is.
  const Oscillation<double> wall(OscillationShape::sinusoidal, 1, 2 * std::numbers::pi);
  for (const double speed : {1e-4, 1e-8, 1e-12}) {
    const double phase = 0.7;
    const double pull = 1 + std::cos(phase);
    const OscillationGap<double> gap(wall, phase, 0, speed, -1);
    const auto due = gap.due(0);
    ASSERT_TRUE(due.is_contact);
    EXPECT_NEAR(due.span / (2 * speed / pull), 1, 2 * speed);
    EXPECT_NEAR(gap.at(due.span).rate / -speed, 1, 2 * speed);
  }
}

TEST(OscillationGap, OfASphereWithoutSpeedOnAWallThatIsDrawnAwayOpens) {
  // At the phase of sin = 1 of the paper's convention, here half a period: acceleration -A w^2.
  const Oscillation<double> wall(OscillationShape::sinusoidal, 2, 2 * std::numbers::pi);
  const OscillationGap<double> gap(wall, std::numbers::pi, 0, 0, -1);
  const auto due = gap.due(0);
  EXPECT_GT(due.span, 1);
  const OscillationGap<double> held(wall, 0, 0, 0, -1);
  EXPECT_EQ(held.due(0).span, 0);
  EXPECT_TRUE(held.due(0).is_contact);
}

}  // namespace
}  // namespace zenosphere
