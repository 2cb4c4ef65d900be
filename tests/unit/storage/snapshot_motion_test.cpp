#include "storage/snapshot_motion.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

/// Two disks in a box of 8 x 4, in the flow 2 (y - 2) along x.
const Snapshot two_disks{
    .positions = {1, 1, 5, 3}, .velocities = {3, -1, 0, 2}, .box_edges = {8, 0, 1, 4}};

TEST(SnapshotMotion, VelocitiesAreRelativeToTheProfileThatIsAtRestInTheMiddle) {
  EXPECT_EQ(peculiar_velocity(two_disks, 2, 2, 0), (std::array<double, 3>{5, -1, 0}));
  EXPECT_EQ(peculiar_velocity(two_disks, 2, 2, 1), (std::array<double, 3>{-2, 2, 0}));
}

TEST(SnapshotMotion, SumsCountByMass) {
  const Grains<double> grains{.diameters = {1, 1}, .masses = {1, 3}};
  const SnapshotMotion motion = motion_of(two_disks, 2, 2, grains);
  EXPECT_EQ(motion.squares, (std::array<double, 3>{25 + 3 * 4, 1 + 3 * 4, 0}));
  EXPECT_EQ(motion.shear, -5 - 3 * 4);
  EXPECT_EQ(motion.fastest, 26);  // the square of its speed, whatever its mass
  EXPECT_EQ(motion.granular_temperature(2), (37.0 + 13) / (2 * 2));
}

TEST(SnapshotMotion, ImmobileSpheresDoNotCount) {
  const Grains<double> grains{.diameters = {1, 1}, .masses = {1, 3}, .immobile = {0, 1}};
  const SnapshotMotion motion = motion_of(two_disks, 2, 2, grains);
  EXPECT_EQ(motion.mobile, 1);
  EXPECT_EQ(motion.granular_temperature(2), 26.0 / 2);
}

}  // namespace
}  // namespace zenosphere
