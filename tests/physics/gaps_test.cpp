#include <gtest/gtest.h>

#include "support/run_text.hpp"

namespace zenosphere {
namespace {

// Four spheres meet the same one again and again through other images of the small box; right after
// a collision they touch in the image that has just met, 1282 times here.
TEST(SeparationCriterion, IsNotMetByPairsThatMeetAgainThroughAnotherImage) {
  const Summary run = test::run_text(R"(
[system]
dimension = 3
spheres = 4
restitution = 0.9
solids_volume_fraction = 0.05
[start]
arrangement = "fcc"
granular_temperature = 1
seed = 3
[drive]
kind = "shear"
shear_rate = 1
[run]
collisions = 20000
)");
  EXPECT_EQ(run.separation.hits, 0);
  EXPECT_EQ(run.verdict, Verdict::none);
}

// Three elastic disks meet in one point and fly apart.
TEST(VerdictOfDisks, ThatHaveFlownApartIsNotOpen) {
  const std::string triple = R"(
[system]
dimension = 2
spheres = 3
restitution = 1
sides = [60, 60]
[start]
arrangement = "given"
positions = [[31.5, 30], [29.25, 31.299038105676658], [29.25, 28.700961894323342]]
velocities = [[-1, 0], [0.5, -0.8660254037844386], [0.5, 0.8660254037844386]]
[drive]
kind = "none"
[collapse]
gap_threshold = 1e-14
[run]
time = 20
)";
  const Summary run = test::run_text(triple);
  EXPECT_GT(run.separation.hits, 0);
  EXPECT_EQ(run.collisions, 3);
  EXPECT_EQ(run.verdict, Verdict::temporary);  // though three collisions are less than a window
}

}  // namespace
}  // namespace zenosphere
