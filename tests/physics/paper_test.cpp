#include <gtest/gtest.h>

#include <filesystem>

#include "case/case_file.hpp"
#include "run/run.hpp"

namespace zenosphere {
namespace {

Summary run_example(const std::string& name, const std::vector<std::string>& overrides) {
  const auto file = std::filesystem::path(ZENOSPHERE_SOURCE_DIR) / "examples" / name;
  return run_case(read_case(file, overrides), RunOptions{});
}

class Paper : public testing::TestWithParam<int> {
 protected:
  std::string seed() const { return "start.seed=" + std::to_string(GetParam()); }
};

// Figures 1 to 3: met before ten collisions per sphere, left again, then time per collision is
// constant: 5.06 collisions per sphere and strain (within 2 % for the window from strain 20 on).
TEST_P(Paper, SeparationCriterionIsMetAndLeftAgainAtRestitution06) {
  const Summary run =
      run_example("shear-e06.toml", {seed(), "run.collisions=700000", "measure.after_time=20"});
  EXPECT_EQ(run.verdict, Verdict::temporary);
  EXPECT_LT(*run.separation.first_collision, 10 * 4000 / 2);
  EXPECT_LT(*run.separation.last_collision, 600000);
  EXPECT_FALSE(run.arrest.met);
  EXPECT_NEAR(run.averages->collision_rate, 5.06, 0.02 * 5.06);
}

// With a loose threshold the gaps no longer tell, and a short window is five rounds of a row of 20
// spheres: it is the clock that stands, for 13 rounds at most.
TEST_P(Paper, ArrestCriterionIsNotMetAtRestitution06WhateverTheWindowAndTheThreshold) {
  const Summary run = run_example(
      "shear-e06.toml",
      {seed(), "run.collisions=200000", "collapse.window=100", "collapse.gap_threshold=1e-12"});
  EXPECT_GT(run.separation.hits, 1000);
  EXPECT_FALSE(run.arrest.met);
}

TEST_P(Paper, ArrestCriterionIsMetAtRestitution02WhateverTheWindowAndTheThreshold) {
  const Summary run = run_example("shear-e02.toml",
                                  {seed(), "collapse.window=100", "collapse.gap_threshold=1e-12"});
  EXPECT_EQ(run.verdict, Verdict::arrested);
}

// Figures 4 to 6: the gap falls to the limit, time stops, a few pairs repeat.
TEST_P(Paper, ArrestCriterionIsMetAtRestitution02) {
  const Summary run = run_example("shear-e02.toml", {seed()});
  EXPECT_EQ(run.verdict, Verdict::arrested);
  EXPECT_EQ(run.outcome, Outcome::collapsed);
  EXPECT_LT(*run.arrest.collision, 2000000);
  EXPECT_GE(run.arrest.pairs.size(), 1U);
  EXPECT_LE(run.arrest.pairs.size(), 20U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Paper, testing::Values(1, 2, 3));

}  // namespace
}  // namespace zenosphere
