#include "flow/displacement_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zenosphere {
namespace {

constexpr std::size_t lags = DisplacementSums<3>::lags;
using Places = std::vector<Vec<3, double>>;

/// What a DisplacementSums has added up, column by column.
struct Found {
  DisplacementSums<3> sums;
  std::vector<std::vector<double>> columns{};

  explicit Found(const SampledSystem<3>& system) : sums(system) {}

  void add(const SampledMoment<3>& moment, const Places& peculiar, std::int64_t multiple,
           double interval) {
    std::vector<double> row;
    for (const SampledColumn& column : sums.columns()) row.resize(row.size() + column.size());
    SumsOfColumns room(row.data());
    sums.add(moment, peculiar, multiple, interval, room);
    const double* next = row.data();
    columns.resize(sums.columns().size());
    for (std::size_t n = 0; n < columns.size(); ++n) {
      columns[n].resize(sums.columns()[n].size());
      for (double& number : columns[n]) number += *next++;
    }
  }

  double stretches(std::size_t level) const { return columns[0][level]; }
  double square(std::size_t level, std::size_t lag, std::size_t axis) const {
    return columns[2][(level * lags + lag - 1) * 3 + axis] / stretches(level);
  }
  double correlation(std::size_t level, std::size_t lag) const {
    return columns[3][level * lags + lag - 1] / columns[1][level];
  }
  double uncertain(std::size_t axis) const { return columns[4][axis]; }
};

double wrapped(double place, double side) { return place - side * std::floor(place / side); }

SampledMoment<3> moment_of(Places places, const Vec<3, double>& sides, double offset = 0) {
  for (auto& place : places) {
    const double turns = std::floor(place[1] / sides[1]);
    place[0] -= turns * offset;
    for (int axis = 0; axis < 3; ++axis) place[axis] = wrapped(place[axis], sides[axis]);
  }
  return {places, {}, offset};
}

// Two spheres that part at (0.3, -0.2, 0.1): after a time t each has come (0.3 t)^2 and so on, also
// through faces. 41 samples are four stretches of ten, two of every second sample, one of each
// fourth. Turned back after the fifth sample of each ten, v(0) v(t) is -1 from then on.
TEST(DisplacementSums, FreeFlightGoesThroughFaces) {
  const Vec<3, double> sides{{2, 3, 4}};
  const Vec<3, double> speed{{0.3, -0.2, 0.1}};
  Found found({2, sides, std::nullopt, 0, {}});
  for (int n = 0; n <= 40; ++n) {
    const Places places{speed * n, speed * -n};
    found.add(moment_of(places, sides), {speed, speed * -1}, n, 1.0);
  }
  EXPECT_EQ(found.stretches(0), 4);
  EXPECT_EQ(found.stretches(1), 2);
  EXPECT_EQ(found.stretches(2), 1);
  EXPECT_EQ(found.stretches(3), 0);
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    for (const std::size_t level : {0, 1, 2}) {
      const double time = static_cast<double>(lag << level);
      EXPECT_NEAR(found.square(level, lag, 0), 0.09 * time * time, 1e-12 * time * time);
      EXPECT_NEAR(found.square(level, lag, 2), 0.01 * time * time, 1e-12 * time * time);
      EXPECT_NEAR(found.correlation(level, lag), 1, 1e-12);
    }
  }
  EXPECT_EQ(found.uncertain(0) + found.uncertain(1) + found.uncertain(2), 0);
}

// Nothing moves but the flow, 0.2 of strain from sample to sample: nothing is displaced, though
// spheres go through the faces across the flow.
TEST(DisplacementSums, FlowIsNoDisplacement) {
  const Vec<3, double> sides{{4, 4, 4}};
  Found found({5, sides, std::nullopt, 1.0, {}});
  for (int n = 0; n <= 10; ++n) {
    const double strain = 0.2 * n;
    Places places;
    for (const double height : {0.1, 1.0, 2.0, 3.0, 3.9}) {
      places.push_back({{0.5 + strain * (height - 2), height, 1.0}});
    }
    const double offset = strain * 4 - 4 * std::round(strain * 4 / 4);
    found.add(moment_of(places, sides, offset), Places(5), n, 0.2);
  }
  ASSERT_EQ(found.stretches(0), 1);
  for (std::size_t lag = 1; lag <= lags; ++lag) EXPECT_NEAR(found.square(0, lag, 0), 0, 1e-24);
  EXPECT_EQ(found.uncertain(0), 0);
}

// Straight flights up and down at 0.3 through the faces that slide, u_x = 0 at first: relative to
// the flow, which grows with the height, spheres come to x = -0.3 t^2 / 2 and 0.3 t^2 / 2.
TEST(DisplacementSums, FlightThroughASlidingFaceIsThatInTheFlow) {
  const Vec<3, double> sides{{4, 4, 4}};
  Found found({2, sides, std::nullopt, 1.0, {}});
  for (int n = 0; n <= 10; ++n) {
    const double time = 0.2 * n;
    const Places places{{{1 + 1.7 * time, 3.7 + 0.3 * time, 1}},
                        {{1 - 1.7 * time, 0.3 - 0.3 * time, 1}}};
    const double offset = time * 4 - 4 * std::round(time);
    const Vec<3, double> own{{-0.3 * time, 0.3, 0}};
    found.add(moment_of(places, sides, offset), {own, own * -1}, n, 0.2);
  }
  ASSERT_EQ(found.stretches(0), 1);
  for (std::size_t lag = 1; lag <= lags; ++lag) {
    const double time = 0.2 * static_cast<double>(lag), come = 0.15 * time * time;
    EXPECT_NEAR(found.square(0, lag, 0), come * come, 1e-12) << lag;
    EXPECT_NEAR(found.square(0, lag, 1), 0.09 * time * time, 1e-12) << lag;
  }
}

// The common motion, by mass, is left out: of masses 1 and 3 at (4, 0) it is 1.
TEST(DisplacementSums, CommonMotionIsLeftOut) {
  const Vec<3, double> sides{{50, 50, 50}};
  Found found({2, sides, std::nullopt, 0, {{1, 1}, {1, 3}, {}, {}}});
  for (int n = 0; n <= 10; ++n) {
    const Places places{{{1.0 + 4.0 * n, 1, 1}}, {{20, 1, 1}}};
    found.add(moment_of(places, sides), {{{3, 0, 0}}, {{-1, 0, 0}}}, n, 1.0);
  }
  EXPECT_NEAR(found.square(0, 1, 0), (9 + 1) / 2.0, 1e-12);
}

// Half a side is 1: at speed 1.5 a step of a unit of time could have been one of -0.5.
TEST(DisplacementSums, AnImageThatIsNotCertainIsCounted) {
  const Vec<3, double> sides{{2, 2, 2}};
  Found found({2, sides, std::nullopt, 0, {}});
  for (int n = 0; n <= 10; ++n) {
    const Vec<3, double> speed{{1.5, 0.5, 0}};
    found.add(moment_of({speed * n, speed * -n}, sides), {speed, speed * -1}, n, 1.0);
  }
  EXPECT_EQ(found.uncertain(0), 10);
  EXPECT_EQ(found.uncertain(1), 0);
}

// Samples 0 to 6 and then every second one: the first level begins anew at each, the second has its
// ten at 20.
TEST(DisplacementSums, LongerIntervalsEndAStretch) {
  const Vec<3, double> sides{{50, 50, 50}};
  Found found({2, sides, std::nullopt, 0, {}});
  const Vec<3, double> speed{{0.1, 0, 0}};
  for (int n = 0; n <= 20; n += n < 6 ? 1 : 2) {
    found.add(moment_of({speed * n, speed * -n}, sides), {speed, speed * -1}, n, 1.0);
  }
  EXPECT_EQ(found.stretches(0), 0);
  ASSERT_EQ(found.stretches(1), 1);
  EXPECT_NEAR(found.square(1, lags, 0), 4, 1e-12);
}

}  // namespace
}  // namespace zenosphere
