#include "report/samples_json.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "case/case_file.hpp"

namespace zenosphere {
namespace {

/// Two disks in a box of 10 x 5.
Case disks_with(const std::string& rest) {
  return parse_case(
      "[system]\ndimension = 2\nspheres = 2\nrestitution = 1\nsides = [10, 5]\n"
      "[start]\narrangement = \"given\"\npositions = [[1, 1], [5, 3]]\n"
      "velocities = [[1, 0], [0, 1]]\n[run]\ntime = 2\n" +
          rest,
      "test.toml", {});
}

/// Four samples over the last unit of time up to 2.
RecordedSamples four_samples() {
  RecordedSamples samples{.sums = {.step = {7}, .time = {2}}};
  samples.sums.columns = {{"samples", {}, {4}}, {"span", {}, {1}}};
  return samples;
}

TEST(SamplesJson, RadialDistributionCountsOnlyWhereCentresCanBe) {
  RecordedSamples samples = four_samples();
  samples.sums.columns.push_back({"pair_counts", {2}, {8, 4}});
  samples.sums.columns.push_back({"share_inside", {2}, {2, 4}});
  samples.edges = {{"distance", {}, {1, 2, 3}}};
  const auto walls = "[drive]\nkind = \"none\"\n[walls]\naxis = \"y\"\nrestitution = 1\n";
  const Json json = samples_json(samples, disks_with(walls));
  EXPECT_EQ(json["from_time"], 1);
  const Json& g = json["radial_distribution"]["g"];
  // Volume 10 x (5 - 1), two ordered pairs, rings of 3 pi and 5 pi, of which half and all are
  // inside.
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(g[0].get<double>(), 8 * 40 / (2 * 3 * pi * 2), 1e-12);
  EXPECT_NEAR(g[1].get<double>(), 4 * 40 / (2 * 5 * pi * 4), 1e-12);
}

TEST(SamplesJson, ProfilesAreOfTheMeanFlowAndOfTheMotionAboutIt) {
  RecordedSamples samples = four_samples();
  auto& columns = samples.sums.columns;
  columns.push_back({"layer_spheres", {2}, {4, 4}});
  columns.push_back({"layer_mass", {2}, {4, 4}});
  columns.push_back({"layer_momentum", {2, 2}, {2, 0, 4, 0}});
  columns.push_back({"layer_kinetic", {2, 2, 2}, {3, 0, 0, 1, 6, 0, 0, 2}});
  columns.push_back({"layer_diameters", {2, 1}, {4, 4}});
  samples.edges = {{"layer", {}, {0, 2.5, 5}}};
  const auto shear = "[drive]\nkind = \"shear\"\nshear_rate = 0.2\n";
  const Json profiles = samples_json(samples, disks_with(shear))["profiles"];
  EXPECT_EQ(profiles["axis"], "y");
  // 2/4 and 4/4, and the profile at 1.25 below and above the middle.
  EXPECT_NEAR(profiles["velocity"][0].get<double>(), 0.5 - 0.25, 1e-12);
  EXPECT_NEAR(profiles["velocity"][1].get<double>(), 1 + 0.25, 1e-12);
  // (4 - 2^2/4) / (2 x 4) and (8 - 4^2/4) / (2 x 4)
  EXPECT_NEAR(profiles["granular_temperature"][0].get<double>(), 0.375, 1e-12);
  EXPECT_NEAR(profiles["granular_temperature"][1].get<double>(), 0.5, 1e-12);
}

}  // namespace
}  // namespace zenosphere
