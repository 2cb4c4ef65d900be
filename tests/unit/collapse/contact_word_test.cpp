#include "collapse/contact_word.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

using Contacts = std::vector<std::pair<std::int32_t, std::int32_t>>;

Contacts repeated(const Contacts& round, int times) {
  Contacts all;
  for (int k = 0; k < times; ++k) all.insert(all.end(), round.begin(), round.end());
  return all;
}

TEST(ContactWord, ThreeRodsAlternate) {
  const auto word = contact_word(repeated({{0, 1}, {1, 2}}, 10));
  EXPECT_TRUE(word.is_periodic);
  EXPECT_EQ(word.letters, "ab");
}

TEST(ContactWord, LettersFollowTheRowOfSpheresNotTheOrderOfContacts) {
  // b = 1-2 is the middle of the row 0-1-2-3; the alphabetically first rotation counts.
  const auto word = contact_word(repeated({{2, 3}, {1, 2}, {0, 1}, {1, 2}}, 6));
  EXPECT_TRUE(word.is_periodic);
  EXPECT_EQ(word.letters, "abcb");
}

TEST(ContactWord, IsNotPeriodicBeforeFourPeriods) {
  const auto word = contact_word(repeated({{0, 1}, {1, 2}, {2, 3}, {1, 2}}, 3));
  EXPECT_FALSE(word.is_periodic);
}

TEST(ContactWord, OfNothingIsEmpty) { EXPECT_EQ(contact_word({}).letters, ""); }

}  // namespace
}  // namespace zenosphere
