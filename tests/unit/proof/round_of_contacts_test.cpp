#include "proof/round_of_contacts.hpp"

#include <gtest/gtest.h>

#include "proof/exact_rods.hpp"

namespace zenosphere {
namespace {

/// Four rods in the middle of their collapse, and the round that has just ended.
struct FourRods {
  ExactRods rods{{.positions = {"0", "1.4", "2.9", "4.1"},
                  .velocities = {"1", "0.2", "-0.3", "-1.1"},
                  .restitution = "0.15"}};
  std::vector<int> word;
  RowState state;

  FourRods() {
    for (int k = 0; k < 80; ++k) {
      rods.next_event();
      if (k >= 72) word.push_back(rods.letter());
    }
    state = {{rods.constants().begin(), rods.constants().end()},
             {rods.slopes().begin(), rods.slopes().end()}};
  }

  bool holds(const std::vector<int>& round, const RationalVector& pairs) const {
    const RoundOfContacts map(round, 3, rods.restitution());
    const auto slopes = InvariantCone::around(state.u, map.map());
    const auto minors = InvariantCone::around(pairs, map.map_of_pairs());
    return slopes && minors && map.holds_in(*slopes, *minors);
  }
};

TEST(RoundOfContacts, HoldsForTheWordThatTheRodsFollow) {
  const FourRods four;
  EXPECT_TRUE(four.holds(four.word, four.state.pairs()));
}

TEST(RoundOfContacts, NeedsEveryOtherGapOpenAtEachContact) {
  const FourRods four;
  // With all minors reversed the velocities are as before, but every gap would be negative.
  RationalVector reversed = four.state.pairs();
  for (Rational& value : reversed) value = -value;
  EXPECT_FALSE(four.holds(four.word, reversed));
}

TEST(RoundOfContacts, NeedsTheRodsOfTheContactBeforeToPart) {
  FourRods four;
  // The rods that have met last still approach: all later contacts take place as they did.
  Rational& speed = four.state.u.at(static_cast<std::size_t>(four.word.back()));
  ASSERT_GT(speed, 0);
  speed = -speed;
  EXPECT_FALSE(four.holds(four.word, four.state.pairs()));
}

TEST(RoundOfContacts, DoesNotHoldForAnotherWord) {
  const FourRods four;
  std::vector<int> shorter{0, 1, 2, 1};
  EXPECT_FALSE(four.holds(shorter, four.state.pairs()));
  std::vector<int> twice = four.word;
  twice.push_back(twice.back());
  EXPECT_FALSE(four.holds(twice, four.state.pairs()));
}

TEST(RoundOfContacts, BoundsTheTimeOfTheNextRoundClosely) {
  FourRods four;
  const RoundOfContacts map(four.word, 3, four.rods.restitution());
  const auto slopes = InvariantCone::around(four.state.u, map.map());
  const auto pairs = InvariantCone::around(four.state.pairs(), map.map_of_pairs());
  ASSERT_TRUE(slopes && pairs);
  const Rational height = slopes->height(four.state.u);
  const Rational bound =
      map.longest_duration(*slopes, *pairs) * pairs->height(four.state.pairs()) / (height * height);
  const Rational before = four.rods.now();
  for (int k = 0; k < 8; ++k) four.rods.next_event();
  // c and u have a common scale, which a time does not see.
  const Rational duration = four.rods.now() - before;
  EXPECT_LE(duration, bound);
  EXPECT_GE(duration, bound * Rational(9, 10));
}

}  // namespace
}  // namespace zenosphere
