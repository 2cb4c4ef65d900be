#include "run/checkpoint_cadence.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

Case::Output every(double seconds, std::optional<std::int64_t> collisions = std::nullopt) {
  Case::Output output;
  output.checkpoint_seconds = seconds;
  output.checkpoint_collisions = collisions;
  return output;
}

TEST(CheckpointCadence, FirstOneComesAfterTheInterval) {
  const CheckpointCadence cadence(every(60), 0);
  EXPECT_FALSE(cadence.is_due_at(59.9));
  EXPECT_TRUE(cadence.is_due_at(60));
  EXPECT_FALSE(cadence.is_due_after(1'000'000'000'000));
}

TEST(CheckpointCadence, CheapCheckpointsComeAtTheInterval) {
  CheckpointCadence cadence(every(60), 0);
  cadence.note(60, 61, 1000);  // 50 s are less than the interval
  EXPECT_FALSE(cadence.is_due_at(120.9));
  EXPECT_TRUE(cadence.is_due_at(121));
}

TEST(CheckpointCadence, DearCheckpointsTakeAtMostAFiftiethOfTheTime) {
  CheckpointCadence cadence(every(60), 0);
  cadence.note(60, 63, 1000);
  EXPECT_FALSE(cadence.is_due_at(63 + 149.9));
  EXPECT_TRUE(cadence.is_due_at(63 + 150));
}

TEST(CheckpointCadence, CollisionsCountFromTheBeginningOfTheRun) {
  CheckpointCadence cadence(every(60, 100), 250);  // resumed at collision 250
  EXPECT_FALSE(cadence.is_due_after(299));
  EXPECT_TRUE(cadence.is_due_after(300));
  cadence.note(0, 1000, 300);  // whatever it took
  EXPECT_FALSE(cadence.is_due_after(399));
  EXPECT_TRUE(cadence.is_due_after(400));
}

}  // namespace
}  // namespace zenosphere
