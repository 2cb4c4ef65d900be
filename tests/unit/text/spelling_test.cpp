#include "text/spelling.hpp"

#include <gtest/gtest.h>

#include <array>

namespace zenosphere {
namespace {

TEST(EditDistance, CountsInsertedDeletedAndReplacedLetters) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("restituton", "restitution"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);  // Wagner & Fischer's measure, textbook pair
}

TEST(Nearest, IsTheFirstOfTheClosestCandidates) {
  constexpr std::array<std::string_view, 3> candidates{"spheres", "cubes", "cones"};
  EXPECT_EQ(nearest("sphere", candidates), "spheres");
  EXPECT_EQ(nearest("cunes", candidates), "cubes");  // one letter from both, cubes stands first
}

TEST(Nearest, IsNothingBeyondOneEditForThreeLetters) {
  constexpr std::array<std::string_view, 2> candidates{"kind", "restitution"};
  EXPECT_EQ(nearest("kand", candidates), "kind");
  EXPECT_EQ(nearest("kant", candidates), std::nullopt);
  EXPECT_EQ(nearest("rextotuxion", candidates), "restitution");  // 3 of 11 letters
  EXPECT_EQ(nearest("rextotuxiox", candidates), std::nullopt);   // 4 of 11 letters
}

}  // namespace
}  // namespace zenosphere
