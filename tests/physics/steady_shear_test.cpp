#include <gtest/gtest.h>

#include "support/run_text.hpp"

namespace zenosphere {
namespace {

const char* const steady_shear = R"(
[system]
dimension = 3
spheres = 4000
restitution = 0.9
solids_volume_fraction = 0.3
[start]
arrangement = "random"
granular_temperature = 1
[drive]
kind = "shear"
shear_rate = 1
[run]
collisions = 900000
[measure]
after_time = 8
)";

struct Reference {
  double temperature, pressure, shear_stress, collision_rate;
};

// The reference values are those of a separate event-driven code (errors 0.1 to 0.5 %); our run of
// about 35 strain units scatters by 0.3 % from seed to seed, the shear stress by 0.6 %.
void expect_near(const Averages& averages, const Reference& reference) {
  EXPECT_NEAR(averages.granular_temperature, reference.temperature, 0.015 * reference.temperature);
  EXPECT_NEAR(averages.pressure, reference.pressure, 0.015 * reference.pressure);
  EXPECT_NEAR(averages.collision_rate, reference.collision_rate, 0.015 * reference.collision_rate);
  EXPECT_NEAR(-averages.pressure_tensor[1], reference.shear_stress, 0.03 * reference.shear_stress);
  // In the steady state all work is dissipated; the stored energy drifts by less than a per cent.
  EXPECT_NEAR(averages.shear_work, averages.dissipation, 0.01 * averages.dissipation);
}

TEST(SteadyShear, StateAtRestitution09IsTheReferenceState) {
  const Summary run = test::run_text(steady_shear);
  ASSERT_TRUE(run.averages);
  expect_near(*run.averages, {1.139, 2.561, 0.714, 10.885});
}

TEST(SteadyShear, StateAtRestitution08IsTheReferenceState) {
  const Summary run =
      test::run_text(steady_shear, {"system.restitution=0.8", "start.granular_temperature=0.5"});
  ASSERT_TRUE(run.averages);
  expect_near(*run.averages, {0.5171, 1.1429, 0.4407, 7.436});
}

TEST(SteadyShear, ShearRateOnlySetsTheUnitOfTime) {
  // Twice the rate and twice the speeds: the same flow, seen in half the time.
  const Summary one = test::run_text(steady_shear, {"run.collisions=20000"});
  const Summary two = test::run_text(
      steady_shear, {"run.collisions=20000", "drive.shear_rate=2", "start.granular_temperature=4"});
  EXPECT_NEAR(two.time, one.time / 2, 1e-12);  // powers of two: only a few roundings differ
  EXPECT_EQ(two.collisions, one.collisions);
}

}  // namespace
}  // namespace zenosphere
