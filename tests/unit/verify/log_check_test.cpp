#include "verify/log_check.hpp"

#include <gtest/gtest.h>

namespace zenosphere::verify {
namespace {

Case two_spheres() {
  Case values;
  values.system.dimension = 1;
  values.system.spheres = 2;
  values.system.restitution = 0.5;
  return values;
}

/// What is said about the last of some rows.
std::string objection(const std::vector<CollisionRow>& rows, const Case& values = two_spheres()) {
  LogCheck check(values, 2, 10.0);
  std::string text;
  for (const auto& row : rows) {
    Findings findings;
    check.observe(row, findings);
    text = findings.texts().empty() ? "" : findings.texts().front();
  }
  return text;
}

TEST(LogCheck, RowsInOrderPass) {
  EXPECT_EQ(objection({{1, 0.5, 0, 1, 0.1, 1.0, 0}, {2, 0.75, 0, 1, 1e-17, 1.0, 1}}), "");
}

TEST(LogCheck, TimesMayFallOnlyWithTheFlagsOfAnOverlap) {
  EXPECT_EQ(objection({{1, 0.5, 0, 1, 0.1, 1.0, 0}, {2, 0.4999, 0, 1, 0.1, 1.0, 2 + 16}}), "");
  EXPECT_NE(objection({{1, 0.5, 0, 1, 0.1, 1.0, 0}, {2, 0.4999, 0, 1, 0.1, 1.0, 0}}), "");
}

TEST(LogCheck, AClockThatStoodHasNotMoved) {
  EXPECT_EQ(objection({{1, 0.5, 0, 1, 0.1, 1.0, 0}, {2, 0.5, 0, 1, 0.1, 1.0, 16}}), "");
  EXPECT_NE(objection({{1, 0.5, 0, 1, 0.1, 1.0, 0}, {2, 0.6, 0, 1, 0.1, 1.0, 16}}), "");
}

TEST(LogCheck, RecedingPairsHaveTheirFlagAndOnlyThey) {
  EXPECT_EQ(objection({{1, 0.5, 0, 1, 0.1, -1e-17, 8}}), "");
  EXPECT_NE(objection({{1, 0.5, 0, 1, 0.1, -1e-17, 0}}), "");
  EXPECT_NE(objection({{1, 0.5, 0, 1, 0.1, 1.0, 8}}), "");
}

TEST(LogCheck, AWindowBeginsWhereTheCaseSays) {
  Case values = two_spheres();
  values.output.collision_log = CollisionLog::window;
  values.output.log_first = 7;
  EXPECT_EQ(objection({{7, 0.5, 0, 1, 0.1, 1.0, 0}}, values), "");
  EXPECT_NE(objection({{8, 0.5, 0, 1, 0.1, 1.0, 0}}, values), "");
}

TEST(LogCheck, LossIsAQuarterOfOneMinusESquaredTimesTheSquareOfTheSpeed) {
  const Case values = two_spheres();
  LogCheck check(values, 2, 10.0);
  Findings findings;
  check.observe({1, 0.5, 0, 1, 0.1, 2.0, 0}, findings);
  EXPECT_EQ(check.take_dissipated(), 0.75);  // (1 - 1/4) x 4 / 4
}

}  // namespace
}  // namespace zenosphere::verify
