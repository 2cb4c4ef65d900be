#include "flow/wave_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace zenosphere {
namespace {

/// The columns of a WaveSums after one sample.
template <int Dim>
std::vector<std::vector<double>> found(const SampledSystem<Dim>& system,
                                       const SampledMoment<Dim>& moment) {
  const WaveSums<Dim> sums(system);
  std::vector<std::vector<double>> columns;
  std::size_t size = 0;
  for (const SampledColumn& column : sums.columns()) size += column.size();
  std::vector<double> row(size);
  SumsOfColumns room(row.data());
  sums.add(moment, room);
  const double* next = row.data();
  for (const SampledColumn& column : sums.columns()) {
    columns.emplace_back(next, next + column.size());
    next += column.size();
  }
  return columns;
}

template <int Dim>
SampledMoment<Dim> random_places(const SampledSystem<Dim>& system, double offset) {
  std::mt19937_64 random(3);
  SampledMoment<Dim> moment{{}, {}, offset};
  for (std::int32_t i = 0; i < system.spheres; ++i) {
    Vec<Dim, double> place;
    for (int axis = 0; axis < Dim; ++axis) {
      place[axis] = std::uniform_real_distribution<double>(0, system.sides[axis])(random);
    }
    moment.positions.push_back(place);
  }
  return moment;
}

/// Number of waves and sum of their powers in each bin, with complex exponentials one by one.
///
/// \param most  wavelengths along each side that are tried
std::vector<std::array<double, 2>> by_brute_force(const SampledSystem<3>& system,
                                                  const SampledMoment<3>& moment,
                                                  const std::vector<double>& edges, int most) {
  std::vector<std::array<double, 2>> bins(edges.size() - 1);
  for (int code = 0; code < std::pow(2 * most + 1, 3); ++code) {
    const int side = 2 * most + 1;
    const std::array numbers{code % side - most, code / side % side - most,
                             code / side / side - most};
    Vec<3, double> k;
    for (int axis = 0; axis < 3; ++axis) {
      k[axis] = 2 * std::numbers::pi * numbers[static_cast<std::size_t>(axis)] / system.sides[axis];
    }
    k[1] -= k[0] * moment.offset / system.sides[1];
    const double length = std::sqrt(dot(k, k));
    const auto bin = std::upper_bound(edges.begin(), edges.end(), length) - edges.begin() - 1;
    if (bin < 0 || bin >= static_cast<std::ptrdiff_t>(bins.size())) continue;
    std::complex<double> sum = 0;
    for (const auto& place : moment.positions) sum += std::polar(1.0, dot(k, place));
    bins[static_cast<std::size_t>(bin)][0] += 1;
    bins[static_cast<std::size_t>(bin)][1] += std::norm(sum) / system.spheres;
  }
  return bins;
}

void expect_all_waves(const SampledSystem<3>& system, const SampledMoment<3>& moment, int most) {
  const auto columns = found(system, moment);
  const auto edges = WaveSums<3>(system).edges().front().values;
  const auto expected = by_brute_force(system, moment, edges, most);
  ASSERT_GE(expected.size(), 3U);
  for (std::size_t bin = 0; bin < expected.size(); ++bin) {
    EXPECT_EQ(columns[0][bin], expected[bin][0]) << bin;
    EXPECT_NEAR(columns[2][bin], expected[bin][1], 1e-9 * expected[bin][1]) << bin;
  }
}

TEST(WaveSums, AreThoseOfAllWavesOfABin) {
  const SampledSystem<3> system{60, {{9, 11, 13}}, std::nullopt, 0, {}};
  expect_all_waves(system, random_places(system, 0), 5);
}

// Slanted by a tenth of the side: every wave up to the last bin is there.
TEST(WaveSums, OfASlantedBoxAreThoseOfItsWaves) {
  const SampledSystem<3> system{60, {{12, 12, 12}}, std::nullopt, 1, {}};
  const auto moment = random_places(system, 1.2);
  const auto columns = found(system, moment);
  const auto edges = WaveSums<3>(system).edges().front().values;
  const auto expected = by_brute_force(system, moment, edges, 5);
  for (std::size_t bin = 0; bin + 1 < expected.size(); ++bin) {
    EXPECT_EQ(columns[0][bin], expected[bin][0]) << bin;
    EXPECT_NEAR(columns[2][bin], expected[bin][1], 1e-9 * expected[bin][1]) << bin;
  }
}

// 100 rods at equal distances: no long wave has any power, so that S(0) = 0.
TEST(WaveSums, OfEqualDistancesAreZero) {
  const SampledSystem<1> system{100, {{150}}, std::nullopt, 0, {}};
  SampledMoment<1> moment;
  for (int i = 0; i < 100; ++i) moment.positions.push_back({{1.5 * i}});
  const auto columns = found(system, moment);
  EXPECT_NEAR(columns[3][0], 0, 1e-20);
  EXPECT_EQ(columns[4][0], 1);
}

// Independent places: S = 1 at every k, and each of M waves scatters by 1. 2000 samples of 20
// spheres have 18 waves k, -k along each of two sides and some 500 in all; 5 errors.
TEST(WaveSums, OfIndependentPlacesAreOne) {
  const SampledSystem<2> system{20, {{20, 20}}, std::nullopt, 0, {}};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0, 20);
  double power = 0, waves = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    SampledMoment<2> moment;
    for (int i = 0; i < 20; ++i) moment.positions.push_back({{place(random), place(random)}});
    const auto columns = found(system, moment);
    for (std::size_t bin = 0; bin < columns[0].size(); ++bin) {
      waves += columns[0][bin];
      power += columns[2][bin];
    }
  }
  EXPECT_NEAR(power / waves, 1, 5 / std::sqrt(waves / 2));
}

TEST(WaveSums, OfALargeSystemAreLimited) {
  const SampledSystem<3> system{1000000, {{120, 120, 120}}, std::nullopt, 0, {}};
  const auto edges = WaveSums<3>(system).edges().front().values;
  const double reached = edges.back();
  EXPECT_LT(reached, 0.4);
  EXPECT_GT(edges.size(), 4U);
}

TEST(WaveSums, BetweenWallsInOneDimensionThereAreNone) {
  EXPECT_TRUE(WaveSums<1>({10, {{20}}, 0, 0, {}}).columns().empty());
}

}  // namespace
}  // namespace zenosphere
