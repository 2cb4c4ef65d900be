#include "collapse/arrest_criterion.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/records.hpp"

namespace zenosphere {
namespace {

using support::record;
using Criterion = ArrestCriterion<3, double>;
using Pair = Criterion::Pair;

constexpr double gap_threshold = 1e-16;
constexpr double contact_moment = 0.5;

/// Hands collisions to a criterion of window 8 that does not ask how often each pair has met,
/// numbered from 1; time and gap stand still.
class Arrest : public testing::Test {
 protected:
  void observe(Pair pair, double gap = 0, double remainder = contact_moment) {
    criterion.observe(record(++number, pair.first, pair.second, gap, remainder));
  }
  void repeat(Pair pair, int times) {
    for (int n = 0; n < times; ++n) observe(pair);
  }

  Criterion criterion{gap_threshold, 8, 1.0, 0};
  std::int64_t number = 0;
};

TEST_F(Arrest, OfASinglePairIsMetExactlyOneWindowAfterItsFirstCollision) {
  repeat({3, 4}, 8);
  EXPECT_FALSE(criterion.is_met());
  repeat({3, 4}, 1);  // collision 9 = 1 + 8
  EXPECT_TRUE(criterion.is_met());
  EXPECT_EQ(criterion.collision(), 9);
  EXPECT_EQ(criterion.time(), contact_moment);
  EXPECT_EQ(criterion.pairs(), (std::vector<Pair>{{3, 4}}));
}

TEST_F(Arrest, ReportsTheRepeatingPairsInOrder) {
  for (int n = 0; n < 3; ++n) {
    observe({5, 6});
    observe({0, 9});
    observe({0, 2});
  }
  EXPECT_EQ(criterion.collision(), 9);
  EXPECT_EQ(criterion.pairs(), (std::vector<Pair>{{0, 2}, {0, 9}, {5, 6}}));
}

TEST_F(Arrest, IsDelayedByANewPairUntilHalfAWindowLater) {
  repeat({0, 1}, 6);
  observe({1, 2});    // collision 7 brings a new pair
  repeat({0, 1}, 3);  // 8, 9, 10: the window is full at 9, but 7 + 4 = 11
  EXPECT_FALSE(criterion.is_met());
  repeat({0, 1}, 1);
  EXPECT_EQ(criterion.collision(), 11);
  // The new pair has not come again in the last half window, 8 ... 11.
  EXPECT_EQ(criterion.pairs(), (std::vector<Pair>{{0, 1}}));
}

TEST_F(Arrest, CountsAPairOfTheLastHalfWindowAsRepeating) {
  repeat({0, 1}, 4);
  observe({1, 2});    // 5: new
  repeat({0, 1}, 2);  // 6, 7
  observe({1, 2});    // 8: again
  repeat({0, 1}, 1);  // 9 = 1 + 8 = 5 + 4
  EXPECT_EQ(criterion.collision(), 9);
  EXPECT_EQ(criterion.pairs(), (std::vector<Pair>{{0, 1}, {1, 2}}));
}

TEST_F(Arrest, IsNotMetWhileNewPairsKeepComing) {
  for (std::int32_t n = 0; n < 100; ++n) observe({n, n + 1});
  EXPECT_FALSE(criterion.is_met());
}

TEST_F(Arrest, StartsAgainAfterAGapAboveTheThreshold) {
  repeat({0, 1}, 7);
  observe({0, 1}, 1.01e-16);  // collision 8 begins a new stretch
  repeat({0, 1}, 7);
  EXPECT_FALSE(criterion.is_met());
  repeat({0, 1}, 1);
  EXPECT_EQ(criterion.collision(), 16);
}

TEST_F(Arrest, HoldsAtTheThresholdAndInOverlap) {
  observe({0, 1}, 1);  // the gap of the first one lies before the stretch
  for (int n = 0; n < 4; ++n) observe({0, 1}, gap_threshold);
  for (int n = 0; n < 4; ++n) observe({0, 1}, -1e-12);
  EXPECT_EQ(criterion.collision(), 9);
}

TEST_F(Arrest, StartsAgainWhenTheClockMovesByItsLastBit) {
  repeat({0, 1}, 7);
  const double later = contact_moment + 0x1p-53;
  observe({0, 1}, 0, later);
  for (int n = 0; n < 7; ++n) observe({0, 1}, 0, later);
  EXPECT_FALSE(criterion.is_met());
  observe({0, 1}, 0, later);
  EXPECT_EQ(criterion.collision(), 16);
  EXPECT_EQ(criterion.time(), later);
}

TEST_F(Arrest, TakesAClockThatStepsBackAsStanding) {
  observe({0, 1}, 0, contact_moment);
  for (int n = 0; n < 4; ++n) {
    observe({0, 1}, 0, contact_moment - 0x1p-53);
    observe({0, 1}, 0, contact_moment);  // no later than the first one
  }
  EXPECT_EQ(criterion.collision(), 9);
}

TEST_F(Arrest, StartsAgainWhenTheClockGoesToTheNextUnit) {
  for (int n = 0; n < 20; ++n) {
    auto collision = record(++number, 0, 1, 0, contact_moment);
    collision.time.units = n / 5;
    criterion.observe(collision);
  }
  EXPECT_FALSE(criterion.is_met());
}

TEST_F(Arrest, ForgetsThePairsOfABrokenStretch) {
  observe({7, 8});
  observe({0, 1}, 1);  // collision 2 begins the stretch
  repeat({0, 1}, 3);
  observe({7, 8});    // 6: new to this stretch
  repeat({0, 1}, 3);  // 7, 8, 9
  EXPECT_FALSE(criterion.is_met());
  repeat({0, 1}, 1);  // 10 = 2 + 8 = 6 + 4
  EXPECT_EQ(criterion.collision(), 10);
  EXPECT_EQ(criterion.pairs(), (std::vector<Pair>{{0, 1}}));
}

TEST_F(Arrest, StaysAsItWasOnceMet) {
  repeat({0, 1}, 9);
  observe({2, 3}, 1, 0.75);
  for (int n = 0; n < 20; ++n) observe({2, 3}, 0, 0.75);
  EXPECT_EQ(criterion.collision(), 9);
  EXPECT_EQ(criterion.time(), contact_moment);
  EXPECT_EQ(criterion.pairs(), (std::vector<Pair>{{0, 1}}));
}

TEST(ArrestCriterion, AsksThatThePairsHaveMetAHundredTimesEach) {
  // Three pairs in turn: 300 collisions after the first one, however short the window.
  Criterion criterion(gap_threshold, 8, 1.0);
  for (std::int64_t number = 1; !criterion.is_met() && number < 1000; ++number) {
    const auto i = static_cast<std::int32_t>(number % 3);
    criterion.observe(record(number, i, i + 1, 0, contact_moment));
  }
  EXPECT_EQ(criterion.collision(), 301);
  EXPECT_EQ(criterion.pairs().size(), 3u);
}

TEST(ArrestCriterion, OfALongWindowDoesNotDependOnHowOftenEachPairHasMet) {
  Criterion criterion(gap_threshold, 1000, 1.0);
  for (std::int64_t number = 1; !criterion.is_met() && number < 2000; ++number) {
    const auto i = static_cast<std::int32_t>(number % 3);
    criterion.observe(record(number, i, i + 1, 0, contact_moment));
  }
  EXPECT_EQ(criterion.collision(), 1001);
}

TEST(ArrestCriterion, TellsTimeAndWindow) {
  // Unit 0.5: at 4 units + 0.125 = 2.125.
  Criterion criterion(gap_threshold, 2, 0.5, 0);
  EXPECT_EQ(criterion.window(), 2);
  for (std::int64_t number = 1; number <= 3; ++number) {
    auto collision = record(number, 0, 1, 0, 0.125);
    collision.time.units = 4;
    criterion.observe(collision);
  }
  EXPECT_EQ(criterion.collision(), 3);
  EXPECT_EQ(criterion.time(), 2.125);
}

TEST(ArrestCriterion, RefusesAnArrestInAnArchiveThatHasNoPairs) {
  const auto read = [](const std::vector<Pair>& pairs) {
    const std::vector<std::pair<Pair, std::int64_t>> seen{{{0, 1}, 9}};
    ArchiveWriter writer;
    writer(std::int64_t{1}, std::int64_t{1}, Instant<double>{}, seen);
    writer(std::optional(std::int64_t{9}), std::optional(contact_moment), pairs);
    Criterion criterion(gap_threshold, 8, 1.0);
    ArchiveReader(writer.bytes())(criterion);
  };
  EXPECT_NO_THROW(read({{0, 1}}));
  EXPECT_THROW(read({}), ArchiveError);
  EXPECT_THROW(read({{1, 1}}), ArchiveError);
}

}  // namespace
}  // namespace zenosphere
