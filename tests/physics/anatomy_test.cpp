#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/few_balls.hpp"
#include "support/run_text.hpp"

namespace zenosphere {
namespace {

using Chain = std::vector<std::int64_t>;

TEST(AnatomyOfThreeRods, FindsTheExactFactorsAndTheCollapseTime) {
  const auto hit = test::run_text(test::three_rods_case).anatomy.hit.value();
  EXPECT_EQ(hit.spheres, 3);
  EXPECT_EQ(hit.contacts, 2);
  EXPECT_EQ(hit.chain, (Chain{0, 1, 2}));
  EXPECT_EQ(hit.straightness, 1);
  EXPECT_EQ(hit.cycle, 2);
  // Gaps down to 2e-11 of coordinates good to 2e-15; the median takes ratios from the middle.
  EXPECT_NEAR(hit.gap_ratio.value(), 0.125, 1e-9);
  EXPECT_NEAR(hit.speed_ratio.value(), 0.4, 1e-9);
  EXPECT_NEAR(hit.flight_ratio.value(), 0.3125, 1e-9);
  EXPECT_NEAR(hit.exact_gap_ratio.value(), 0.125, 1e-15);
  const double error = hit.collapse_time_error.value();
  EXPECT_LT(error, 1e-6);
  EXPECT_NEAR(hit.collapse_time.value(), 40.0 / 11, 2 * error);
}

TEST(AnatomyOfThreeRods, IsTheSameInEveryPrecision) {
  for (const std::string precision : {"extended", "quad", "digits100"}) {
    const auto hit = test::run_text(test::three_rods_case, {"collision.precision=" + precision})
                         .anatomy.hit.value();
    EXPECT_EQ(hit.chain, (Chain{0, 1, 2})) << precision;
    EXPECT_NEAR(hit.gap_ratio.value(), 0.125, 1e-10) << precision;
    // A double: more digits cannot show in the summary.
    EXPECT_NEAR(hit.collapse_time.value(), 40.0 / 11, 1e-8) << precision;
  }
}

// A second triple, 30 diameters on and 1.001 times as fast, first meets at 0.003, with the last gap
// 1 as well, and collapses at 0.003 + (40/11)/1.001 = 3.6357, a little before the first one.
TEST(AnatomyOfTwoTriples, TellsThemApart) {
  const auto hit = test::run_text(test::three_rods_case,
                                  {"system.spheres=6",
                                   "start.positions=[10, 11, 13, 43, 44.003003, 46.002627625]",
                                   "start.velocities=[1, 0, 0.125, 1.001, 0, 0.125125]"})
                       .anatomy.hit.value();
  EXPECT_EQ(hit.clusters, 2);
  EXPECT_EQ(hit.chain, (Chain{3, 4, 5}));
  EXPECT_NEAR(hit.gap_ratio.value(), 0.125, 1e-6);
  // Coordinates near 45 have ulps of 7e-15, and the estimates end at a closing speed of 1e-2.
  EXPECT_NEAR(hit.collapse_time.value(), 0.003 + 40 / (11 * 1.001), 1e-12);
}

TEST(AnatomyOfAnElasticTriple, IsAChanceHitOfThreeDisks) {
  const std::string triple = R"(
[system]
dimension = 2
spheres = 3
restitution = 1
sides = [20, 20]
[start]
arrangement = "given"
positions = [[11.5, 10], [9.25, 11.299038105676658], [9.25, 8.700961894323342]]
velocities = [[-1, 0], [0.5, -0.8660254037844386], [0.5, 0.8660254037844386]]
[drive]
kind = "none"
[collapse]
window = 10
gap_threshold = 1e-14
[run]
time = 10
)";
  const Summary run = test::run_text(triple);
  const auto hit = run.anatomy.hit.value();
  EXPECT_EQ(hit.spheres, 3);
  EXPECT_NEAR(hit.straightness, 0.5, 1e-12);  // 60 degrees between its two bonds
  EXPECT_FALSE(hit.gap_ratio);
  EXPECT_FALSE(hit.exact_gap_ratio);
  EXPECT_FALSE(hit.collapse_time);
  EXPECT_FALSE(run.anatomy.arrest);
}

// N balls on a line collapse for e < tan^2[(pi/4)(1 - 2/N)]: at e = 0.2 it takes five.
TEST(AnatomyOfASparseCollapse, FindsAsManyBallsAsTheTheoryOfChainsNeeds) {
  const std::string sheared = R"(
[system]
dimension = 3
spheres = 500
restitution = 0.2
solids_volume_fraction = 0.3
[start]
arrangement = "fcc"
granular_temperature = 6e-3
[drive]
kind = "shear"
shear_rate = 1
[collapse]
stop_when_collapsed = true
[run]
collisions = 100000
)";
  for (const std::string seed : {"1", "2", "3"}) {
    const auto hit = test::run_text(sheared, {"start.seed=" + seed}).anatomy.hit.value();
    EXPECT_GE(hit.chain.size(), 5u) << seed;
    EXPECT_GT(hit.straightness, 0.95) << seed;
    EXPECT_LT(hit.gap_ratio.value(), 1) << seed;
    // The hit comes when the gaps are down to 1e-16, within some of the last flights of 1e-5.
    EXPECT_NEAR(hit.collapse_time.value(), hit.time, 1e-4) << seed;
  }
}

TEST(AnatomyOfABouncingBall, FindsTheRestitutionInItsArrest) {
  const auto arrest = test::run_text(test::ball_on_a_floor_case).anatomy.arrest.value();
  EXPECT_EQ(arrest.spheres, 1);
  EXPECT_EQ(arrest.chain, Chain{0});
  EXPECT_NEAR(arrest.speed_ratio.value(), 0.5, 1e-9);
  EXPECT_NEAR(arrest.flight_ratio.value(), 0.5, 1e-6);
  EXPECT_NEAR(arrest.collapse_time.value(), 3, 1e-9);  // 1 + (2 v0/G)/(1 - e) with v0 = 1/2
}

TEST(AnatomyOfARunWithoutHits, IsEmpty) {
  const Summary run = test::run_text(test::three_rods_case, {"system.restitution=0.9"});
  EXPECT_EQ(run.separation.hits, 0);
  EXPECT_FALSE(run.anatomy.hit);
  EXPECT_FALSE(run.anatomy.arrest);
}

}  // namespace
}  // namespace zenosphere
