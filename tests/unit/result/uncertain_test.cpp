#include "result/uncertain.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zenosphere {
namespace {

TEST(Uncertain, EndsWhereTheErrorBegins) {
  EXPECT_EQ(with_error(1.13945, 0.0021, 6), "1.139(2)");
  EXPECT_EQ(with_error(1.13945, 0.00123, 6), "1.1395(12)");
  EXPECT_EQ(with_error(1.13945, 0.00194, 6), "1.1395(19)");  // two digits of an error up to 1.94
  EXPECT_EQ(with_error(1.13945, 0.00196, 6), "1.139(2)");
  EXPECT_EQ(with_error(-0.00012, 0.003, 6), "-0.000(3)");
  EXPECT_EQ(with_error(17.2, 3.4, 6), "17(3)");
  EXPECT_EQ(with_error(0.5, 0.0000999, 6), "0.50000(10)");
}

TEST(Uncertain, HasAPowerOfTenWhereANumberIsFarFromOne) {
  EXPECT_EQ(with_error(1.13945e-9, 2.1e-12, 6), "1.139(2)e-09");
  EXPECT_EQ(with_error(4.2e8, 3e6, 6), "4.20(3)e+08");
  EXPECT_EQ(with_error(173.2, 34, 6), "1.7(3)e+02");
}

TEST(Uncertain, IsANumberWhereNoErrorIsKnown) {
  EXPECT_EQ(with_error(1.13945, std::nan(""), 4), "1.139");
  EXPECT_EQ(with_error(2.5, 0, 4), "2.5");
}

}  // namespace
}  // namespace zenosphere
