#include "engine/simd/first_contacts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/next_meetings.hpp"
#include "engine/simd/wide_lanes.hpp"
#include "support/bits.hpp"
#include "support/gas.hpp"
#include "support/sight.hpp"

namespace zenosphere {
namespace {

constexpr int some_images = 135;  // of PeriodicImage::count

template <class Dimension>
class FirstContactsFourAtATime : public ::testing::Test {
 protected:
  static constexpr int Dim = Dimension::value;

  void SetUp() override {
    if (!has_wide_lanes()) GTEST_SKIP() << "no AVX2 here";
    for (auto& image : images) image = {some_vector(1), dice.between(-1, 1)};
    constexpr std::array<double, 3> spread{20, 5, 1.5};  // so that some overlap, and most do not
    for (int i = 0; i < 40; ++i) {
      Sphere<Dim, double> sphere{};
      sphere.position = some_vector(spread[Dim - 1]);
      sphere.velocity = some_vector(1);
      sphere.time = dice.between(0, 1);
      spheres.push_back(sphere);
    }
    for (int i = 0; i < 20; ++i) spheres.push_back(spheres[static_cast<std::size_t>(3 + i)]);
  }

  Vec<Dim, double> some_vector(double largest) {
    Vec<Dim, double> vector;
    for (int axis = 0; axis < Dim; ++axis) vector[axis] = dice.between(-largest, largest);
    return vector;
  }

  /// Of any spheres, some of which have the very same motion; with three to spare.
  std::vector<Neighbour> some_neighbours(int count) {
    const int image_count = dice.below(2) == 0 ? 1 : some_images;
    std::vector<Neighbour> neighbours;
    for (int k = 0; k < count + 3; ++k) {
      neighbours.emplace_back(dice.below(60), PeriodicImage::from_code(dice.below(image_count)));
    }
    return neighbours;
  }

  std::optional<FirstContacts<double>> found(const std::vector<Neighbour>& neighbours) const {
    return first_contacts_wide(spheres.data(), std::span(neighbours).first(neighbours.size() - 3),
                               images.data(), here);
  }

  /// What contact() says of a neighbour.
  std::optional<Contact<double>> contact_with(Neighbour neighbour) const {
    const auto& sphere = spheres[static_cast<std::size_t>(neighbour.sphere())];
    const auto& image = images[static_cast<std::size_t>(neighbour.periodic_image().code())];
    return contact(support::motion_seen(here, sphere, image));
  }

  support::Dice dice{11};
  std::vector<Image<Dim, double>> images = std::vector<Image<Dim, double>>(some_images);
  std::vector<Sphere<Dim, double>> spheres;
  Viewpoint<Dim, double> here{some_vector(0.4), some_vector(0.4), 1.25};
};

using Dimensions = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(FirstContactsFourAtATime, Dimensions);

TYPED_TEST(FirstContactsFourAtATime, AreThoseOfOneByOneBitForBit) {
  int answers = 0;
  int overlaps = 0;
  int left_open = 0;
  for (int n = 0; n < 20000; ++n) {
    const std::vector<Neighbour> neighbours = this->some_neighbours(this->dice.below(23));
    NextMeetings<double> expected;
    int meetings = 0;
    bool overlapping = false;
    for (const Neighbour neighbour : std::span(neighbours).first(neighbours.size() - 3)) {
      const auto contact = this->contact_with(neighbour);
      if (!contact) continue;
      ++meetings;
      overlapping |= contact->overlapping;
      expected.add({this->here.when + contact->time, neighbour.sphere(), 0, false});
    }
    const auto two = this->found(neighbours);
    overlaps += overlapping ? 1 : 0;
    ASSERT_FALSE(overlapping && two);
    left_open += !overlapping && !two ? 1 : 0;
    if (!two) continue;
    ++answers;
    ASSERT_EQ(two->meetings, meetings);
    ASSERT_EQ(two->first, expected.first().partner());
    ASSERT_EQ(two->second, expected.second().partner());
    ASSERT_TRUE(meetings < 1 || support::are_same(two->first_time, expected.first().time));
    ASSERT_TRUE(meetings < 2 || support::are_same(two->second_time, expected.second().time));
  }
  EXPECT_GT(answers, 5000);
  EXPECT_GT(overlaps, 1000);
  EXPECT_GT(left_open, 50);  // by equal times
}

TYPED_TEST(FirstContactsFourAtATime, LeaveLongListsAlone) {
  for (auto& sphere : this->spheres) {  // all are far away, and part
    sphere.position[0] += 100;
    sphere.velocity[0] += 5;
  }
  EXPECT_TRUE(this->found(this->some_neighbours(60)));
  EXPECT_FALSE(this->found(this->some_neighbours(61)));
}

TYPED_TEST(FirstContactsFourAtATime, OfNoNeighboursAreNone) {
  const auto two = this->found(this->some_neighbours(0));
  ASSERT_TRUE(two);
  EXPECT_EQ(two->meetings, 0);
  EXPECT_EQ(two->first, -1);
  EXPECT_EQ(two->second, -1);
}

TYPED_TEST(FirstContactsFourAtATime, LeaveAloneWhatIsNoNumber) {
  const auto neighbours = this->some_neighbours(20);
  this->here.position[0] = std::numeric_limits<double>::quiet_NaN();
  const auto nowhere = this->found(neighbours);
  EXPECT_TRUE(!nowhere || nowhere->meetings == 0);
}

}  // namespace
}  // namespace zenosphere
