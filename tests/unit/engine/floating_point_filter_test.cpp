#include "engine/floating_point_filter.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "model/real.hpp"
#include "support/gas.hpp"
#include "support/sight.hpp"

namespace zenosphere {
namespace {

/// A pair, seen by the first of the two: with all digits, and roughly.
template <int Dim>
struct Pair {
  Viewpoint<Dim, Quad> here;
  Sphere<Dim, Quad> other;
  Image<Dim, Quad> image;

  bool may_touch() const { return contact(support::motion_seen(here, other, image)).has_value(); }
  bool misses_roughly() const { return FloatingPointFilter<Dim>(here).misses(other, image); }
};

/// More digits than a double has.
Quad some_number(support::Dice& dice, double largest) {
  return Quad(dice.between(-largest, largest)) + Quad(dice.between(-largest, largest)) * 1e-17;
}
template <int Dim>
Vec<Dim, Quad> some_vector(support::Dice& dice, double largest) {
  Vec<Dim, Quad> vector;
  for (int axis = 0; axis < Dim; ++axis) vector[axis] = some_number(dice, largest);
  return vector;
}

template <int Dim>
Pair<Dim> some_pair(support::Dice& dice) {
  Pair<Dim> pair{};
  pair.here = {some_vector<Dim>(dice, 2), some_vector<Dim>(dice, 1), some_number(dice, 1)};
  pair.other.position = some_vector<Dim>(dice, 2);
  pair.other.velocity = some_vector<Dim>(dice, 1);
  pair.other.time = some_number(dice, 1);
  if (dice.below(2) == 0) pair.image = {some_vector<Dim>(dice, 1), some_number(dice, 1)};
  return pair;
}

/// Turns a pair into one that meets the sphere at a distance of 1 + `miss` when it is nearest, some
/// time from now; all but together, at first, where `closing_speed` is small.
void graze(Pair<2>& pair, double miss, double closing_speed, support::Dice& dice) {
  pair.image = {};
  const Quad flight = Quad(dice.between(0.1, 1));
  const Vec<2, Quad> nearest{{0, 1 + Quad(miss)}};
  const Vec<2, Quad> closing{{Quad(closing_speed), 0}};
  pair.other.time = pair.here.when;
  pair.other.velocity = pair.here.velocity + closing;
  pair.other.position = pair.here.position + nearest - closing * flight;
}

TEST(FloatingPointFilter, LosesNoPairThatTouches) {
  support::Dice dice{5};
  int touching = 0;
  int missed = 0;
  constexpr int pairs = 100000;
  for (int n = 0; n < pairs; ++n) {
    const Pair<3> pair = some_pair<3>(dice);
    const bool may_touch = pair.may_touch();
    ASSERT_FALSE(may_touch && pair.misses_roughly());
    touching += may_touch ? 1 : 0;
    missed += pair.misses_roughly() ? 1 : 0;
  }
  EXPECT_GT(touching, 5000);
  EXPECT_EQ(missed + touching, pairs);  // chance does not come near the bounds
}

TEST(FloatingPointFilter, LeavesOpenWhatTakesMoreDigits) {
  support::Dice dice{6};
  for (const double speed : {1.0, 1e-6, 1e-10, 1e-14, 1e-20}) {
    for (const double miss : {1e-16, 1e-20, 1e-30, -1e-30, -1e-20, -1e-16}) {
      Pair<2> pair = some_pair<2>(dice);
      graze(pair, miss, speed, dice);
      EXPECT_EQ(pair.may_touch(), miss < 0) << miss << " at " << speed;
      EXPECT_FALSE(pair.misses_roughly()) << miss << " at " << speed;
    }
  }
}

TEST(FloatingPointFilter, KnowsTheLessTheSlowerTwoApproachEachOther) {
  support::Dice dice{7};
  const auto misses = [&](double miss, double speed) {
    Pair<2> pair = some_pair<2>(dice);
    graze(pair, miss, speed, dice);
    return pair.misses_roughly();
  };
  EXPECT_TRUE(misses(1e-6, 1));
  EXPECT_TRUE(misses(1e-2, 1e-8));
  EXPECT_FALSE(misses(1e-6, 1e-15));
  EXPECT_FALSE(misses(1e-2, 1e-15));
}

TEST(FloatingPointFilter, LeavesOpenWhatADoubleCannotHold) {
  support::Dice dice{8};
  Pair<2> slow = some_pair<2>(dice);
  slow.here.velocity = {};
  graze(slow, 0.5, 1e-320, dice);
  EXPECT_FALSE(slow.misses_roughly());
  Pair<2> nowhere = some_pair<2>(dice);
  nowhere.here.position[0] = std::numeric_limits<Quad>::quiet_NaN();
  EXPECT_FALSE(nowhere.misses_roughly());
}

}  // namespace
}  // namespace zenosphere
