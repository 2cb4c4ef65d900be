#include "engine/wide_contacts.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/next_meetings.hpp"
#include "engine/wide_lanes.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

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
    for (int i = 0; i < 40; ++i) {
      Sphere<3, double> sphere{};
      for (int axis = 0; axis < 3; ++axis) {
        sphere.position[axis] = dice.between(-1.5, 1.5);
        sphere.velocity[axis] = dice.between(-1, 1);
      }
      sphere.time = dice.between(0, 1);
      spheres.push_back(sphere);
    }
    for (int i = 0; i < 20; ++i) spheres.push_back(spheres[static_cast<std::size_t>(3 + i)]);
  }

  /// Of any spheres, some of which have the very same motion; with three to spare.
  std::vector<Neighbour> some_neighbours(int count) {
    const int ways = dice.below(2) == 0 ? 1 : Way::count;
    std::vector<Neighbour> neighbours;
    for (int k = 0; k < count + 3; ++k) {
      neighbours.emplace_back(dice.below(60), Way::from_code(dice.below(ways)));
    }
    return neighbours;
  }

  std::optional<FirstContacts<double>> found(const std::vector<Neighbour>& neighbours) const {
    FetchQueue nothing;
    return first_contacts_wide(spheres.data(), std::span(neighbours).first(neighbours.size() - 3),
                               images.data(), here, nothing);
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
  int answers = 0;
  int overlaps = 0;
  int left_open = 0;
  for (int n = 0; n < 20000; ++n) {
    const std::vector<Neighbour> neighbours = some_neighbours(dice.below(23));
    NextMeetings<double> expected;
    int meetings = 0;
    bool overlapping = false;
    for (const Neighbour neighbour : std::span(neighbours).first(neighbours.size() - 3)) {
      const auto contact = contact_with(neighbour);
      if (!contact) continue;
      ++meetings;
      overlapping |= contact->overlapping;
      expected.add({here.when + contact->time, neighbour.sphere(), 0, false});
    }
    const auto two = found(neighbours);
    overlaps += overlapping ? 1 : 0;
    ASSERT_FALSE(overlapping && two);
    left_open += !overlapping && !two ? 1 : 0;
    if (!two) continue;
    ++answers;
    ASSERT_EQ(two->meetings, meetings);
    ASSERT_EQ(two->first, expected.first().partner());
    ASSERT_EQ(two->second, expected.second().partner());
    ASSERT_TRUE(meetings < 1 || are_same(two->first_time, expected.first().time));
    ASSERT_TRUE(meetings < 2 || are_same(two->second_time, expected.second().time));
  }
  EXPECT_GT(answers, 5000);
  EXPECT_GT(overlaps, 1000);
  EXPECT_GT(left_open, 50);  // by equal times
}

TEST_F(WideContacts, LeaveLongListsAlone) {
  for (auto& sphere : spheres) sphere.position += Vec<3, double>{{5, 5, 5}};  // nobody overlaps
  EXPECT_TRUE(found(some_neighbours(60)));
  EXPECT_FALSE(found(some_neighbours(61)));
}

TEST_F(WideContacts, OfNobodyAreNone) {
  const auto two = found(some_neighbours(0));
  ASSERT_TRUE(two);
  EXPECT_EQ(two->meetings, 0);
  EXPECT_EQ(two->first, -1);
  EXPECT_EQ(two->second, -1);
}

TEST_F(WideContacts, LeaveAloneWhatIsNoNumber) {
  const auto neighbours = some_neighbours(20);
  here.position[0] = std::numeric_limits<double>::quiet_NaN();
  const auto nowhere = found(neighbours);
  EXPECT_TRUE(!nowhere || nowhere->meetings == 0);
}

}  // namespace
}  // namespace zenosphere
