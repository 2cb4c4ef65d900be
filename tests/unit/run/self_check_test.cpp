#include "run/self_check.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/archive.hpp"
#include "support/records.hpp"

namespace zenosphere {
namespace {

/// Four spheres apart in a box of 10 diameters, sheared.
Simulation<3, double> sheared_four(double second_x = 4) {
  const Configuration<3, double> start{
      {{1, 1, 1}, {second_x, 1, 1}, {1, 5, 5}, {6, 6, 6}},
      {{1, 0.5, 0}, {-1, 0.25, 0}, {0.5, -1, 0.125}, {0, 0.5, -0.25}}};
  return {ShearBox<3, double>({10, 10, 10}, 1.0), start, {0.9, OverlapRule::immediate}};
}

class SelfCheckTest : public testing::Test {
 protected:
  std::string found() {
    check.look(simulation, measurements);
    return check.violation().value_or("");
  }

  Simulation<3, double> simulation = sheared_four();
  Measurements<3, double> measurements{simulation, 0};
  SelfCheck<3, double> check{simulation};
};

TEST_F(SelfCheckTest, FindsNothingInARun) {
  for (int n = 0; n < 200; ++n) {
    const auto collision = simulation.next_collision(1e9);
    if (!collision) continue;
    measurements.observe(*collision, simulation);
    check.observe(*collision, simulation);
  }
  EXPECT_GT(simulation.collisions(), 100);
  EXPECT_EQ(found(), "");
}

TEST(SelfCheck, FindsNothingWhereAFastShearHasNotHeatedTheSpheresYet) {
  // Speeds of 7e12 across the box beside those of 1: momentum and energy are rounded to 1e-4.
  const Simulation<3, double> slow = sheared_four();
  Simulation<3, double> simulation(ShearBox<3, double>({10, 10, 10}, 7e11), slow.configuration(),
                                   {0.9, OverlapRule::immediate});
  const Measurements<3, double> measurements(simulation, 0);
  SelfCheck<3, double> check(simulation);
  EXPECT_FALSE(simulation.collision_until(1e-13));
  simulation.wait_until(1e-13);
  check.look(simulation, measurements);
  EXPECT_EQ(check.violation().value_or(""), "");
}

TEST(SelfCheck, RoundingOfTheClockIsThatOfItsStride) {
  // At 1e17 the clock counts in 32 units: 4096 units in the last place of that are 2.9e-11.
  const Configuration<1, double> start{{{1}, {4}}, {{1e-19}, {-1e-19}}};
  Simulation<1, double> simulation(ShearBox<1, double>({8}, 0), start, {1.0});
  SelfCheck<1, double> check(simulation);
  EXPECT_FALSE(simulation.collision_until(1e17));
  simulation.wait_until(1e17);
  ASSERT_EQ(simulation.stride(), 32);
  Collision<1, double> collision{};
  collision.flight = -5e-12;
  check.observe(collision, simulation);
  EXPECT_EQ(check.violation().value_or(""), "");
  collision.flight = -1e-10;
  check.observe(collision, simulation);
  EXPECT_NE(check.violation().value_or("").find("the clock went -1e-10 forward"),
            std::string::npos);
}

TEST_F(SelfCheckTest, FindsMomentumFromNowhere) {
  measurements.kick(simulation, {{0, 0, 1e-6}, {}, {}, {}});
  EXPECT_NE(found().find("momentum along axis 2"), std::string::npos) << found();
}

TEST_F(SelfCheckTest, FindsEnergyFromNowhere) {
  simulation.kick({{0, 1e-3, 0}, {0, -1e-3, 0}, {}, {}});  // the measurements are not told
  EXPECT_NE(found().find("the energy ledger is open"), std::string::npos) << found();
}

TEST_F(SelfCheckTest, FindsWhatIsNoNumber) {
  simulation.kick({{0, std::numeric_limits<double>::quiet_NaN(), 0}, {}, {}, {}});
  EXPECT_NE(found(), "");
}

TEST_F(SelfCheckTest, GoesOnFromAnArchiveWithTheMomentumOfTheStart) {
  ArchiveWriter writer;
  writer(check);
  measurements.kick(simulation, {{0, 0, 1e-6}, {}, {}, {}});
  SelfCheck<3, double> resumed(simulation);
  ArchiveReader reader(writer.bytes());
  reader(resumed);
  reader.require_end();
  resumed.look(simulation, measurements);
  ASSERT_TRUE(resumed.violation());
  EXPECT_NE(resumed.violation()->find("momentum along axis 2"), std::string::npos);
}

/// A check as an archive holds it that was given a finding from outside.
void read_with(const Simulation<3, double>& simulation, const std::string& finding) {
  SelfCheck<3, double> check(simulation);
  ArchiveWriter writer, forged;
  writer(check);
  Bytes bytes = writer.release();
  bytes.pop_back();  // there is no finding
  forged(std::optional(finding));
  bytes.insert(bytes.end(), forged.bytes().begin(), forged.bytes().end());
  ArchiveReader reader(bytes);
  reader(check);
}

TEST(SelfCheck, RefusesAFindingInAnArchiveThatIsNoText) {
  const auto simulation = sheared_four();
  EXPECT_NO_THROW(read_with(simulation, "after collision 7: no (please report it)"));
  EXPECT_THROW(read_with(simulation, "a\xF1"), ArchiveError);         // not UTF-8: no JSON either
  EXPECT_THROW(read_with(simulation, "\x1B]0;title"), ArchiveError);  // commands to a terminal
}

TEST(SelfCheck, FindsSpheresInEachOther) {
  auto simulation = sheared_four(1.5);
  const Measurements<3, double> measurements(simulation, 0);
  SelfCheck<3, double> check(simulation);
  check.look(simulation, measurements);
  ASSERT_TRUE(check.violation());
  EXPECT_EQ(check.violation()->substr(0, 59),
            "after collision 0: spheres 0 and 1 overlap by 0.5 diameters");
}

TEST(SelfCheck, FindsAClockThatGoesBackWithoutAnOverlap) {
  const auto simulation = sheared_four();
  SelfCheck<3, double> check(simulation);
  auto collision = support::record(1, 0, 1, 0, 0.5);
  collision.impact.normal_speed = 1;
  collision.flight = -1e-15;  // some units in the last place
  check.observe(collision, simulation);
  EXPECT_FALSE(check.violation());
  collision.flight = -1e-6;
  check.observe(collision, simulation);
  EXPECT_TRUE(check.violation());
}

TEST(SelfCheck, FindsARewindThatLeadsBackBeyondItsBound) {
  // Rods 2^-50 deep in each other that approach: their contact lies back, so that the bound is
  // known. A side of 32 lets a sphere go back by 2^-17; the fastest has the speed 2.
  const Configuration<1, double> start{{{4}, {5 - 0x1p-50}}, {{2}, {-2}}};
  Simulation<1, double> simulation(ShearBox<1, double>({32}, 0), start, {0.5, OverlapRule::rewind});
  EXPECT_EQ(simulation.longest_rewind(), 0x1p-18);
  Collision<1, double> collision;
  collision.overlapping = true;
  collision.flight = -0x1p-18;
  SelfCheck<1, double> check(simulation);
  check.observe(collision, simulation);
  EXPECT_FALSE(check.violation());
  collision.flight = -0x1p-17;
  check.observe(collision, simulation);
  EXPECT_TRUE(check.violation());
}

}  // namespace
}  // namespace zenosphere
