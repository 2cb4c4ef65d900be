#include "engine/wide_contacts.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

#include "engine/wide_lanes.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using Ahead = ContactsAhead<double>;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Same bits: -0 differs from 0.
bool are_same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

class WideContacts : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_wide_lanes()) GTEST_SKIP() << "no AVX2 here";
    for (auto& image : images) {
      image = {{{dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)}},
               dice.between(-1, 1)};
    }
    for (int i = 0; i < 60; ++i) {
      Sphere<3, double> sphere{};
      for (int axis = 0; axis < 3; ++axis) {
        sphere.position[axis] = dice.between(-1.5, 1.5);
        sphere.velocity[axis] = dice.between(-1, 1);
      }
      sphere.time = dice.between(0, 1);
      spheres.push_back(sphere);
    }
  }

  /// What contact() says of a neighbour.
  std::optional<Contact<double>> contact_with(Neighbour neighbour) const {
    const auto& sphere = spheres[static_cast<std::size_t>(neighbour.sphere())];
    Image<3, double> image = images[static_cast<std::size_t>(neighbour.way().code())];
    image.position[0] += image.velocity * here.when;
    const auto place = sphere.position + sphere.velocity * (here.when - sphere.time);
    RelativeMotion<3, double> motion{(place - here.position) + image.position,
                                     sphere.velocity - here.velocity};
    motion.dv[0] += image.velocity;
    return contact(approach(motion));
  }

  support::Dice dice{11};
  std::vector<Image<3, double>> images = std::vector<Image<3, double>>(Way::count);
  std::vector<Sphere<3, double>> spheres;
  Viewpoint<3, double> here{{{0.1, 0.2, -0.3}}, {{0.4, -0.1, 0.2}}, 1.25};
};

TEST_F(WideContacts, AreThoseOfOneByOneBitForBit) {
  int contacts = 0;
  for (int n = 0; n < 2000; ++n) {
    std::vector<Neighbour> neighbours;
    const int count = dice.below(23);
    for (int k = 0; k < count + 3; ++k) {
      neighbours.emplace_back(dice.below(60), Way::from_code(dice.below(Way::count)));
    }
    Ahead ahead;
    find_contacts_wide(spheres.data(), std::span(neighbours).first(static_cast<std::size_t>(count)),
                       images.data(), here, ahead);
    std::size_t at = 0;
    bool overlaps = false;
    for (int k = 0; k < count; ++k) {
      const Neighbour neighbour = neighbours[static_cast<std::size_t>(k)];
      const auto contact = contact_with(neighbour);
      // One that the first test lets pass and the second does not is there, and never comes.
      while (at < ahead.count && ahead.time[at] == kNever) ++at;
      if (!contact) continue;
      ++contacts;
      overlaps |= contact->overlapping;
      ASSERT_LT(at, ahead.count);
      ASSERT_EQ(ahead.partner[at], neighbour.sphere());
      ASSERT_TRUE(are_same(ahead.time[at], contact->time));
      ASSERT_TRUE(are_same(ahead.approach[at], contact->approach));
      ASSERT_EQ(ahead.time[at] <= 0, contact->overlapping);
      ++at;
    }
    while (at < ahead.count && ahead.time[at] == kNever) ++at;
    ASSERT_EQ(at, ahead.count);
    ASSERT_EQ(ahead.has_overlaps, overlaps);
  }
  EXPECT_GT(contacts, 1000);
}

TEST_F(WideContacts, FirstTwoAreThoseOfOneByOneAlsoAtEqualTimes) {
  for (int n = 0; n < 5000; ++n) {
    Ahead ahead;
    const int count = dice.below(14);
    for (int k = 0; k < count; ++k) {
      const double time = dice.below(6) == 0 ? kNever : 0.25 * dice.below(8) - 0.25;
      ahead.add(100 * dice.below(5) + k, {time, time <= 0, -1});
    }
    const double now = dice.between(0, 1);
    for (std::size_t k = 0; n % 3 == 0 && k < ahead.count; ++k) {
      // As where speeds are beyond all numbers.
      if (dice.below(4) == 0) ahead.time[k] = std::numeric_limits<double>::quiet_NaN();
    }
    const FirstTwo expected = first_two(ahead, now);
    const FirstTwo found = first_two_wide(ahead, now);
    ASSERT_EQ(found.first, expected.first);
    ASSERT_EQ(found.second, expected.second);
    ASSERT_EQ(found.meetings, expected.meetings);
  }
}

TEST(FirstTwo, OfEqualTimesTheLowerPartnersComesFirst) {
  Ahead ahead;
  for (const int partner : {7, 3, 9, 5}) ahead.add(partner, {1, false, -1});
  ahead.add(1, {kNever, false, -1});
  const FirstTwo two = first_two(ahead, 0.5);
  EXPECT_EQ(two.first, 1);
  EXPECT_EQ(two.second, 3);
  EXPECT_EQ(two.meetings, 4);
}

TEST(FirstTwo, OfNobodyAreNone) {
  const FirstTwo two = first_two(Ahead{}, 0.0);
  EXPECT_EQ(two.first, -1);
  EXPECT_EQ(two.second, -1);
  EXPECT_EQ(two.meetings, 0);
}

}  // namespace
}  // namespace zenosphere
