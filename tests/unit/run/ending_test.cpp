#include "run/ending.hpp"

#include <gtest/gtest.h>

#include <string>

#include "case/case_file.hpp"
#include "run/setup.hpp"

namespace zenosphere {
namespace {

/// Why a run of two kicked rods that rest is over at a time without a collision.
std::string end_at(double time, const std::string& limit) {
  const Case values = parse_case(
      "[system]\ndimension = 1\nspheres = 2\nrestitution = 1\nsides = [10]\n"
      "[start]\narrangement = \"given\"\npositions = [1, 5]\nvelocities = [0, 0]\n"
      "[drive]\nkind = \"random\"\nnoise_strength = 1\nkick_interval = 0.5\n[run]\n" +
          limit,
      "test.toml", {});
  auto simulation = new_simulation<1, double>(values);
  simulation.wait_until(time);
  return word(end_of_time(simulation, values));
}

TEST(Ending, KickedSpheresThatMeetNoOtherAreIdleOneDay) {
  // 2^28 + 2 x 2^20 events, eight for each of two spheres and two kicks a time unit: 8 454 144.
  EXPECT_EQ(end_at(8.45e6, "collisions = 1"), "");
  EXPECT_EQ(end_at(8.46e6, "collisions = 1"), "idle");
  EXPECT_EQ(end_at(8.46e6, "time = 1e9"), "");
}

}  // namespace
}  // namespace zenosphere
