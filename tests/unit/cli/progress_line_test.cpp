#include "cli/progress_line.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

TEST(DurationText, IsInMinutesAndSecondsOrHoursAndMinutes) {
  EXPECT_EQ(duration_text(0.4), "0:00");
  EXPECT_EQ(duration_text(61), "1:01");
  EXPECT_EQ(duration_text(3599), "59:59");
  EXPECT_EQ(duration_text(3600), "1 h 00 min");
  EXPECT_EQ(duration_text(2 * 3600 + 61 * 60), "3 h 01 min");
  EXPECT_EQ(duration_text(1e9), "more than 100 h");
}

TEST(ProgressLine, TellsTheTimeThatIsLeft) {
  const Progress progress{.collisions = 1000,
                          .time = 2.5,
                          .collisions_per_second = 50,
                          .separation_hits = 1,
                          .done = 0.25,
                          .wall_seconds = 20};
  EXPECT_EQ(progress_line(progress, 100),
            " 25 %  1000 collisions  time 2.5  50/s  1 hit  1:00 left");
  EXPECT_EQ(progress_line(progress, 30), " 25 %  1:00 left");
}

}  // namespace
}  // namespace zenosphere
