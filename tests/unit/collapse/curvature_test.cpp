#include "collapse/curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace zenosphere {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A fall from 1e-10 to 1e-90 in 800 contacts, of which every tenth has a margin that changes by
/// `per_decade` from 20 on; the others have ten decades more.
std::optional<Curvature> fall(double per_decade) {
  std::vector<double> depths, margins;
  for (int k = 0; k < 800; ++k) {
    depths.push_back(10 + 0.1 * k);
    margins.push_back(20 + per_decade * 0.1 * k + (k % 10 == 0 ? 0 : 10));
  }
  return curvature_of(depths, margins);
}

TEST(CurvatureOfContacts, DiesOutWhereTheMarginGrows) {
  const auto curvature = fall(0.5).value();
  EXPECT_NEAR(curvature.per_decade, 0.5, 1e-9);
  EXPECT_FALSE(gives_way_at(curvature));
}

// 20 - 0.2 x 80 = 4 decades are left at 1e-90, for 20 decades more. The least of a part is that at
// its end, half of 5 decades behind its middle.
TEST(CurvatureOfContacts, OpensTheGapsWhereTheMarginIsUsedUp) {
  const auto curvature = fall(-0.2).value();
  EXPECT_NEAR(curvature.per_decade, -0.2, 1e-9);
  EXPECT_NEAR(gives_way_at(curvature).value(), 110, 3);
}

TEST(CurvatureOfContacts, IsNoneInAStraightRow) {
  const std::vector<double> depths{10, 20, 30, 40, 50, 60, 70, 80, 81, 82, 83, 84, 85, 86, 87, 88};
  EXPECT_FALSE(curvature_of(depths, std::vector<double>(16, infinity)));
}

TEST(CurvatureOfContacts, IsNotToldOfFewerThanSixteenContacts) {
  EXPECT_FALSE(curvature_of(std::vector<double>(15, 10.0), std::vector<double>(15, 1.0)));
}

}  // namespace
}  // namespace zenosphere
