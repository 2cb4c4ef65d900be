#include "engine/sliding_box.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

using Box = SlidingBox<2, double>;

/// Four columns and four layers of cells, 2.5 diameters wide; under shear adjacent layers slide at
/// a speed of 1.25, in 2 time units by a cell.
Box box(double shear_rate) { return Box(ShearBox<2, double>({10, 10}, shear_rate, 2)); }

const PeriodicImage next_layer(Steps<2>{}, 1);

void expect_home(const Box& box, const Box::Home& home, const Steps<2>& cell,
                 PeriodicImage periodic_image) {
  EXPECT_EQ(box.cells().coordinates(home.cell), cell);
  EXPECT_EQ(home.periodic_image, periodic_image);
}

TEST(SlidingBox, TellsInWhichCellAndImageAPlaceIs) {
  const Box upright = box(0);
  ASSERT_EQ(upright.cells().cells(), (Steps<2>{4, 4}));
  const std::int32_t from = upright.cells().index({0, 1});
  expect_home(upright, upright.home({{5.1, 2.6}}, from, 0), {2, 1}, PeriodicImage());
  expect_home(upright, upright.home({{-0.1, 2.6}}, from, 0), {3, 1},
              PeriodicImage(Steps<2>{-1, 0}, 0));
}

TEST(SlidingBox, FindsTheColumnOfTheNextLayerWhereThatHasSlid) {
  Box sheared = box(0.5);
  const auto from = [&](int layer) { return sheared.cells().index({2, layer}); };
  // Half a cell of 2.5 at time 1: 5.1 - 1.25 is in column 1.
  expect_home(sheared, sheared.home({{5.1, 7.6}}, from(2), 1), {1, 3}, next_layer);
  expect_home(sheared, sheared.home({{5.1, 10.1}}, from(3), 1), {1, 0},
              PeriodicImage(Steps<2>{0, 1}, 1));
  sheared.slide_by_one_cell();  // 5.1 - 2.5
  expect_home(sheared, sheared.home({{5.1, 7.6}}, from(2), 0), {1, 3}, next_layer);
  sheared.displace_images(3);  // 5.1 - 2.5 - 3, and a box further
  expect_home(sheared, sheared.home({{5.1, 10.1}}, from(3), 0), {3, 0},
              PeriodicImage(Steps<2>{-1, 1}, 1));
}

TEST(SlidingBox, SeesASphereFromTheFrameOfTheNextLayer) {
  const Box sheared = box(0.5);
  Box::Sphere sphere{};
  sphere.position = {{5.5, 10.25}};
  sphere.velocity = {{1, 2}};
  sphere.time = 1;
  sheared.see_from(sphere, PeriodicImage(Steps<2>{0, 1}, 1));
  EXPECT_EQ(sphere.position, (Vec<2, double>{{4.25, 0.25}}));
  EXPECT_EQ(sphere.velocity, (Vec<2, double>{{-0.25, 2}}));
}

TEST(SlidingBox, TellsHowFarItsUpperImageIsDisplaced) {
  Box sheared = box(0.5);
  EXPECT_EQ(sheared.lees_edwards_offset(0, 0.5), 2.5);   // four layers
  EXPECT_EQ(sheared.lees_edwards_offset(0, 1.5), -2.5);  // 7.5 less a box
  EXPECT_EQ(sheared.lees_edwards_offset(1, 0.5), 2.5);
  sheared.displace_images(1);
  EXPECT_EQ(sheared.lees_edwards_offset(0, 0.5), 3.5);
}

TEST(SlidingBox, BringsASphereBackFromFarAway) {
  Box displaced = box(0);
  displaced.displace_images(3);
  Box::Sphere sphere{};
  sphere.position = {{1, 45}};
  const Vec<2, double> boxes = displaced.bring_back(sphere, sphere.position);
  EXPECT_EQ(boxes, (Vec<2, double>{{-2, 4}}));  // four images displaced by 12: 1 - 12 is beyond one
  EXPECT_EQ(sphere.position, (Vec<2, double>{{9, 5}}));
}

}  // namespace
}  // namespace zenosphere
