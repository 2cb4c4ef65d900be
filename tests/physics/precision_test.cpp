#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/simulation.hpp"
#include "engine/start.hpp"
#include "model/real.hpp"
#include "support/few_balls.hpp"
#include "support/run_text.hpp"

namespace zenosphere {
namespace {

// Three rods with e = 1/20 at x = 10, 11, 13 and v = (1, 0, 1/8), so that g = 1. From the first
// collision on each one scales the relative speed by 2/5 and the time step by 5/16; the sum of all
// flights is 40/11.
template <class Real>
Simulation<1, Real> three_rods() {
  const ShearBox<1, Real> ring({Real(100)}, 0);
  const Configuration<1, Real> start{{{Real(10)}, {Real(11)}, {Real(13)}},
                                     {{Real(1)}, {Real(0)}, {Real(1) / 8}}};
  return Simulation<1, Real>(ring, start, {from_decimal<Real>(0.05)});
}

template <class Real>
std::vector<Collision<1, Real>> collisions(Simulation<1, Real>& simulation, int count) {
  std::vector<Collision<1, Real>> all;
  while (static_cast<int>(all.size()) < count) {
    if (const auto collision = simulation.next_collision(4)) all.push_back(*collision);
  }
  return all;
}

TEST(Precision, DecimalNumbersAreReadInTheRunsOwnPrecision) {
  EXPECT_EQ(from_decimal<double>(0.05), 0.05);
  EXPECT_NE(Digits(0.05), Digits(1) / 20);
  EXPECT_EQ(from_decimal<Digits>(0.05), Digits(1) / 20);
  EXPECT_EQ(from_decimal<Quad>(0.05), Quad(1) / 20);
  EXPECT_EQ(from_decimal<Extended>(0.05), 0.05L);
  EXPECT_EQ(from_decimal<Digits>(1e-3), Digits(1) / 1000);
}

TEST(Precision, ThreeRodsKeepTheirExactFactorsToNinetyDigitsInDigits100) {
  auto rods = three_rods<Digits>();
  const auto all = collisions(rods, 10);
  // A flight near the collapse loses the digits that the time itself has in front: after 10
  // collisions flights are 2e-6 of the time.
  const Digits tolerance("1e-90");
  for (std::size_t k = 2; k < all.size(); ++k) {
    EXPECT_LT(abs(all[k].flight / all[k - 1].flight - Digits(5) / 16), tolerance) << k;
    EXPECT_LT(abs(all[k].impact.normal_speed / all[k - 1].impact.normal_speed - Digits(2) / 5),
              tolerance)
        << k;
  }
}

TEST(Precision, ThreeRodsCollapseAtTheirExactTimeInDigits100) {
  auto rods = three_rods<Digits>();
  const auto all = collisions(rods, 40);
  const auto& last = all.back();
  // The rest of the series: flight x ratio / (1 - ratio) with the ratio 5/16.
  const Digits end = last.time.units + last.time.remainder + last.flight * 5 / 11;
  EXPECT_LT(abs(end - Digits(40) / 11), Digits("1e-60"));
}

class InDigits : public ::testing::TestWithParam<int> {};

// Up to three quarters of the digits in collisions a gap, 8^-n, is far above rounding, and so the
// flights keep their ratio: time and the rest of its series are right to the last places of 40/11.
TEST_P(InDigits, ThreeRodsCollapseAtTheirExactTime) {
  const int decimal = GetParam();
  const WorkingPrecision here(bits_of_digits(decimal));
  auto rods = three_rods<Digits>();
  const auto all = collisions(rods, 3 * decimal / 4);
  const auto& last = all.back();
  const Digits end = last.time.units + last.time.remainder + last.flight * 5 / 11;
  const Digits tolerance("1e-" + std::to_string(decimal - 3));
  EXPECT_LT(abs(end - Digits(40) / 11), tolerance);
}

INSTANTIATE_TEST_SUITE_P(Precision, InDigits, ::testing::Values(20, 50, 100, 116, 1000));

TEST(Precision, MoreDigitsFollowTheThreeRodsFurtherDown) {
  // The separation criterion is met where gaps reach the rounding of the type: each collision takes
  // a factor 1/8, so that n collisions reach 8^-n: 8^-18 = 6e-17, 8^-38 = 5e-35, 8^-112 = 7e-102.
  const auto first_hit = [](const std::string& precision) {
    const Summary run = test::run_text(
        test::three_rods_case,
        {"collapse.window=20", "run.collisions=300", "collision.precision=" + precision});
    return static_cast<double>(*run.separation.first_collision);
  };
  EXPECT_NEAR(first_hit("double"), 19, 2);
  EXPECT_NEAR(first_hit("quad"), 39, 2);
  EXPECT_NEAR(first_hit("digits100"), 113, 2);
  EXPECT_NEAR(first_hit("digits50"), 58, 2);  // 8^-57 = 3.3e-52, the threshold 9.6e-52
}

template <class Real>
std::vector<Collision<3, Real>> cold_shear(int count) {
  const double side = box_side<3>(500, 0.3);
  const ShearBox<3, double> box({side, side, side}, 0);
  const auto made = make_start<3>(
      {.arrangement = Arrangement::fcc, .spheres = 500, .granular_temperature = 6e-3, .seed = 1},
      box);
  Configuration<3, Real> start;
  for (std::size_t i = 0; i < made.positions.size(); ++i) {
    const auto convert = [](const Vec<3, double>& v) {
      return Vec<3, Real>{{Real(v[0]), Real(v[1]), Real(v[2])}};
    };
    start.positions.push_back(convert(made.positions[i]));
    start.velocities.push_back(convert(made.velocities[i]));
  }
  const Real length(side);
  Simulation<3, Real> simulation(ShearBox<3, Real>({length, length, length}, Real(1)), start,
                                 {from_decimal<Real>(0.6)});
  std::vector<Collision<3, Real>> all;
  while (static_cast<int>(all.size()) < count) {
    if (const auto collision = simulation.next_collision(100)) all.push_back(*collision);
  }
  return all;
}

template <class Real>
void expect_same_as_double() {
  // Four collisions per sphere, before chaos has amplified the rounding of double (1e-15 x 8^4).
  const auto in_double = cold_shear<double>(1000);
  const auto in_real = cold_shear<Real>(1000);
  for (std::size_t k = 0; k < in_double.size(); ++k) {
    ASSERT_EQ(in_real[k].i, in_double[k].i) << k;
    ASSERT_EQ(in_real[k].j, in_double[k].j) << k;
    ASSERT_NEAR(static_cast<double>(in_real[k].time.remainder), in_double[k].time.remainder, 1e-11)
        << k;
  }
}

TEST(Precision, ExtendedAgreesWithDoubleCollisionByCollision) { expect_same_as_double<Extended>(); }

TEST(Precision, QuadAgreesWithDoubleCollisionByCollision) { expect_same_as_double<Quad>(); }

}  // namespace
}  // namespace zenosphere
