#include "run/stepped_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "case/case_file.hpp"

namespace zenosphere {
namespace {

Case small_case() {
  return parse_case(
      "[system]\ndimension = 2\nspheres = 24\nrestitution = 0.9\nsolids_volume_fraction = 0.4\n"
      "[start]\narrangement = \"random\"\ngranular_temperature = 1\n"
      "[drive]\nkind = \"shear\"\nshear_rate = 1\n[run]\ncollisions = 300\n",
      "test.toml", {});
}

std::vector<std::int64_t> numbers(const std::vector<CollisionRow>& rows) {
  std::vector<std::int64_t> result;
  for (const CollisionRow& row : rows) result.push_back(row.k);
  return result;
}

TEST(SteppedRun, PieceEndsAfterItsCollisionsAndItsLastRowWaits) {
  const auto run = start_run(small_case(), {});
  std::vector<CollisionRow> rows;
  run->advance({.collisions = 3}, &rows);
  EXPECT_EQ(run->collisions(), 3);
  EXPECT_EQ(numbers(rows), (std::vector<std::int64_t>{1, 2}));
  run->advance({.collisions = 1}, &rows);
  EXPECT_EQ(numbers(rows), (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_FALSE(run->is_over());
}

TEST(SteppedRun, LastRowOfARunComesAtOnceWithoutAGap) {
  const auto run = start_run(small_case(), {});
  std::vector<CollisionRow> rows;
  run->advance({}, &rows);
  EXPECT_TRUE(run->is_over());
  ASSERT_EQ(rows.size(), 300);
  EXPECT_TRUE(std::isnan(rows.back().gap));
  EXPECT_FALSE(std::isnan(rows.front().gap));
}

TEST(SteppedRun, PieceEndsAtItsTimeWithTheClockThereAndNoCollisionAfterIt) {
  const auto run = start_run(small_case(), {});
  std::vector<CollisionRow> rows;
  run->advance({.time = 0.5}, &rows);
  EXPECT_EQ(run->time(), 0.5);
  EXPECT_EQ(run->state().snapshot.time, 0.5);
  EXPECT_EQ(run->summary().time, 0.5);
  EXPECT_EQ(run->summary().outcome, Outcome::unfinished);
  const std::int64_t before = run->collisions();
  run->advance({.collisions = 2}, &rows);
  for (const CollisionRow& row : rows) EXPECT_EQ(row.time > 0.5, row.k > before);
}

TEST(SteppedRun, PieceWithoutTimeLeftEndsAtOnce) {
  const auto run = start_run(small_case(), {});
  run->advance({.time = 0.5}, nullptr);
  const std::int64_t before = run->collisions();
  run->advance({.time = 0.25}, nullptr);
  EXPECT_EQ(run->collisions(), before);
  EXPECT_EQ(run->time(), 0.5);
}

TEST(SteppedRun, PieceEndsAfterItsSeconds) {
  Case values = small_case();
  values.run.collisions = 1'000'000'000'000;
  const auto run = start_run(values, {});
  run->advance({.seconds = 0}, nullptr);  // the clock is read every 4096 calls
  EXPECT_GT(run->collisions(), 0);
  EXPECT_LE(run->collisions(), 4096);
}

TEST(SteppedRun, RowsAreNotWantedInAPieceWithoutThem) {
  const auto run = start_run(small_case(), {});
  std::vector<CollisionRow> rows;
  run->advance({.collisions = 5}, &rows);
  run->advance({.collisions = 5}, nullptr);
  run->advance({.collisions = 2}, &rows);
  EXPECT_EQ(numbers(rows), (std::vector<std::int64_t>{1, 2, 3, 4, 11}));
}

TEST(SteppedRun, RunThatIsFinishedEarlyIsInterruptedWhereItsLastPieceEnded) {
  const auto run = start_run(small_case(), {});
  run->advance({.time = 0.5}, nullptr);
  const Summary summary = run->finish();
  EXPECT_EQ(summary.outcome, Outcome::interrupted);
  EXPECT_EQ(summary.time, 0.5);
}

}  // namespace
}  // namespace zenosphere
