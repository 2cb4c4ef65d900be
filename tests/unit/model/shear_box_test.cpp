#include "model/shear_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace zenosphere {
namespace {

using Box = ShearBox<3, double>;

/// A box with as many cells as fit.
Box finely_cut(const Vec<3, double>& sides, double shear_rate) {
  return {sides, shear_rate, narrowest_cell};
}

TEST(ShearBox, CutsEachSideIntoCellsWiderThanASphere) {
  const Box box = finely_cut({3.5, 5.25, 7.5}, 0);
  EXPECT_EQ(box.cells(), (Steps<3>{3, 5, 7}));
  EXPECT_DOUBLE_EQ(box.cell_width()[0], 3.5 / 3);
  EXPECT_DOUBLE_EQ(box.cell_width()[1], 1.05);
  EXPECT_DOUBLE_EQ(box.cell_width()[2], 7.5 / 7);
  EXPECT_DOUBLE_EQ(box.volume(), 137.8125);  // 3.5 x 5.25 x 7.5
}

TEST(ShearBox, LeavesAMarginSoThatCellsAreNeverJustASphereWide) {
  EXPECT_EQ(finely_cut({5, 4, 3}, 0).cells(), (Steps<3>{4, 3, 2}));
}

TEST(ShearBox, HasAtLeastTwoCellsASide) {
  EXPECT_EQ(Box({2.1, 2.5, 2.9}, 0).cells(), (Steps<3>{2, 2, 2}));
}

TEST(ShearBox, KeepsCellsAboveAWantedWidth) {
  EXPECT_EQ(Box({7, 7.5, 8}, 0, 2.5).cells(), (Steps<3>{2, 2, 3}));  // 7.5 / 2.5 needs a margin
}

TEST(ShearBox, RejectsSidesInWhichASphereMeetsTwoImagesOfAnother) {
  EXPECT_THROW(Box({2, 5, 5}, 1), std::invalid_argument);
  EXPECT_THROW(Box({5, 1.5, 5}, 1), std::invalid_argument);
  EXPECT_THROW(Box({5, 5, std::nan("")}, 1), std::invalid_argument);
  EXPECT_THROW(Box({2.02, 5, 5}, 1), std::invalid_argument);
  EXPECT_NO_THROW(Box({2.021, 2.021, 2.021}, 1));
}

TEST(ShearBox, ClockUnitIsTheTimeInWhichLayersSlideByOneCell) {
  // Sides 3, 5, 4: 2, 4, 3 cells of 1.5, 1.25, 1.33. Slide speed 2 x 1.25 = 2.5; 1.5 / 2.5 = 0.6.
  const Box box = finely_cut({3, 5, 4}, 2);
  EXPECT_TRUE(box.is_sheared());
  EXPECT_DOUBLE_EQ(box.slide_speed(), 2.5);
  EXPECT_DOUBLE_EQ(box.clock_unit(), 0.6);
}

TEST(ShearBox, ClockUnitWithoutShearIsTheUnitOfTime) {
  const Box box({3, 5, 4}, 0);
  EXPECT_FALSE(box.is_sheared());
  EXPECT_EQ(box.slide_speed(), 0);
  EXPECT_EQ(box.clock_unit(), 1);
}

TEST(ShearBox, PairAcrossGradientFaceSeesImageVelocityAndSlide) {
  // One layer down through the lower face: 4 layers of 1.25 are lacking, and 1 column of 1.5. The
  // layer below lags by 2.5 x 0.2 = 0.5 and moves at -2.5.
  const Box box = finely_cut({3, 5, 4}, 2);
  const auto below = box.image({1, -4, 0}, -1, 0.2);
  EXPECT_DOUBLE_EQ(below.position[0], 1.5 - 0.5);
  EXPECT_DOUBLE_EQ(below.position[1], -5);
  EXPECT_DOUBLE_EQ(below.position[2], 0);
  EXPECT_DOUBLE_EQ(below.velocity, -2.5);
  const auto above = box.image({0, 4, -3}, 1, 0.2);
  EXPECT_DOUBLE_EQ(above.position[0], 0.5);
  EXPECT_DOUBLE_EQ(above.position[1], 5);
  EXPECT_DOUBLE_EQ(above.position[2], -4);
  EXPECT_DOUBLE_EQ(above.velocity, 2.5);
}

TEST(ShearBox, CellsOfOneLayerDoNotMoveAgainstEachOther) {
  const auto image = finely_cut({3, 5, 4}, 2).image({-2, 0, 3}, 0, 0.2);
  EXPECT_DOUBLE_EQ(image.position[0], -3);
  EXPECT_DOUBLE_EQ(image.position[2], 4);
  EXPECT_EQ(image.velocity, 0);
}

TEST(ShearBox, SlideGrowsByOneCellInOneClockUnit) {
  const Box box = finely_cut({3, 5, 4}, 2);
  EXPECT_DOUBLE_EQ(box.image({0, 0, 0}, 1, box.clock_unit()).position[0], box.cell_width()[0]);
  EXPECT_DOUBLE_EQ(box.image({0, 0, 0}, 1, -0.1).position[0], -0.25);  // before the last re-base
}

TEST(ShearBox, WorksInOneAndTwoDimensions) {
  EXPECT_EQ((ShearBox<1, double>({6.5}, 0, 1.05).cells()), (Steps<1>{6}));
  const ShearBox<2, double> plane({3, 5}, 2, 1.05);
  EXPECT_DOUBLE_EQ(plane.slide_speed(), 2.5);
  EXPECT_DOUBLE_EQ(plane.volume(), 15);
}

}  // namespace
}  // namespace zenosphere
