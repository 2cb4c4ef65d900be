#include "export/selection.hpp"

#include <gtest/gtest.h>

#include "model/errors.hpp"

namespace zenosphere {
namespace {

std::vector<std::int64_t> selected(const Selection& selection, std::int64_t snapshots) {
  const Numbers numbers = selected_snapshots(selection, snapshots, "out.h5");
  std::vector<std::int64_t> result;
  for (std::int64_t n = 0; n < snapshots; ++n) {
    if (numbers.contain(n)) result.push_back(n);
  }
  return result;
}

using Result = std::vector<std::int64_t>;

TEST(Selection, SnapshotsAreCountedFromBothEnds) {
  EXPECT_EQ(selected({}, 3), (Result{0, 1, 2}));
  EXPECT_EQ(selected({.from = 1}, 3), (Result{1, 2}));
  EXPECT_EQ(selected({.from = -2}, 3), (Result{1, 2}));
  EXPECT_EQ(selected({.from = 0, .to = -2}, 3), (Result{0, 1}));
  EXPECT_EQ(selected({.from = 1, .to = 99}, 3), (Result{1, 2}));
  EXPECT_EQ(selected({.from = 1, .to = 1}, 3), (Result{1}));
}

TEST(Selection, EveryBeginsWithTheFirst) {
  EXPECT_EQ(selected({.from = 1, .to = {}, .every = 3}, 9), (Result{1, 4, 7}));
  EXPECT_EQ(selected({.from = -1, .to = {}, .every = 1000}, 9), (Result{8}));
}

TEST(Selection, OfNothingIsAnErrorThatTellsWhatThereIs) {
  EXPECT_THROW(selected({.from = -4}, 3), InputError);
  EXPECT_THROW(selected({.from = 2, .to = 1}, 3), InputError);
  EXPECT_THROW(selected({.from = 0, .to = -4}, 3), InputError);
  EXPECT_THROW(selected({}, 0), InputError);
  try {
    selected({.from = 3}, 3);
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "out.h5: --from 3 selects no snapshot (there are 3, 0 to 2); choose others");
  }
}

TEST(Selection, CollisionsAreCountedFromTheBeginningOnly) {
  const Numbers numbers = selected_collisions({.from = 5, .to = 11, .every = 3}, "out.h5");
  EXPECT_TRUE(numbers.contain(5) && numbers.contain(8) && numbers.contain(11));
  EXPECT_FALSE(numbers.contain(2) || numbers.contain(6) || numbers.contain(14));
  EXPECT_THROW(selected_collisions({.from = -1}, "out.h5"), InputError);
  EXPECT_THROW(selected_collisions({.from = 5, .to = 4}, "out.h5"), InputError);
}

}  // namespace
}  // namespace zenosphere
