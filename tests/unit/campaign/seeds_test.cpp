#include "campaign/seeds.hpp"

#include <gtest/gtest.h>

#include <set>

namespace zenosphere {
namespace {

// The first five outputs of SplitMix64 for the seed 1234567, as Rosetta Code publishes them.
TEST(RunSeed, IsThePublishedSequenceWithoutItsLastElevenBits) {
  EXPECT_EQ(run_seed(1234567, 0), 6457827717110365317U >> 11);
  EXPECT_EQ(run_seed(1234567, 1), 3203168211198807973U >> 11);
  EXPECT_EQ(run_seed(1234567, 2), 9817491932198370423U >> 11);
  EXPECT_EQ(run_seed(1234567, 3), 4593380528125082431U >> 11);
  EXPECT_EQ(run_seed(1234567, 4), 16408922859458223821U >> 11);
}

TEST(RunSeed, IsHeldExactlyByADouble) {
  for (std::uint64_t run = 0; run < 1000; ++run)
    EXPECT_LT(run_seed(1, run), std::uint64_t{1} << 53);
}

TEST(RunSeed, DiffersBetweenRunsAndBetweenMasterSeeds) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t master : {0, 1, 2}) {
    for (std::uint64_t run = 0; run < 1000; ++run) seeds.insert(run_seed(master, run));
  }
  EXPECT_EQ(seeds.size(), 3000U);
}

}  // namespace
}  // namespace zenosphere
