#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "result/summary.hpp"
#include "support/summaries.hpp"

namespace zenosphere {
namespace {

using test::collapsed_summary;
using test::planar_averages;

using Json = nlohmann::ordered_json;

TEST(Summary, SaysWhyThereAreNoAverages) {
  Summary summary;
  summary.time = 176.25;
  const std::string none = "no averages: time 176.25 is not beyond measure.after_time";
  EXPECT_NE(to_text(summary, 2).find(none), std::string::npos);
  summary.averages = planar_averages();
  EXPECT_EQ(to_text(summary, 2).find("no averages"), std::string::npos);
}

TEST(Summary, TextGivesAnAverageWithItsError) {
  auto summary = collapsed_summary();
  summary.averages = planar_averages();
  summary.averages->standard_error = planar_averages();
  summary.averages->standard_error->granular_temperature = 0.003;
  EXPECT_NE(to_text(summary, 2, "").find("granular temperature    0.100(3) (diameter"),
            std::string::npos);
}

TEST(Summary, TextGivesAveragesThatFewCollisionsSupportInFewDigits) {
  Summary summary;
  summary.verdict = Verdict::none;
  summary.averages = planar_averages();
  summary.averages->granular_temperature = 0.123456789;
  const auto told_after = [&](std::int64_t collisions) {
    summary.collisions = collisions;
    const std::string text = to_text(summary, 2, "");
    const std::size_t begin = text.find("granular temperature") + 24;
    return text.substr(begin, text.find(' ', begin) - begin);
  };
  EXPECT_EQ(told_after(23), "0.12");        // 1 / sqrt(23) is a fifth
  EXPECT_EQ(told_after(10'000), "0.1235");  // a per cent
  EXPECT_EQ(told_after(100'000'000), "0.123457");
}

TEST(Summary, TextBeginsWithTheVerdictInPlainWords) {
  auto summary = collapsed_summary();
  EXPECT_EQ(to_text(summary, 2).find("Collapse: "), 0u);
  summary.verdict = Verdict::open;
  EXPECT_EQ(to_text(summary, 2).find("Undecided: "), 0u);
  summary.verdict = Verdict::temporary;
  EXPECT_EQ(to_text(summary, 2).find("No arrest: "), 0u);
  summary.verdict = Verdict::none;
  EXPECT_EQ(to_text(summary, 2).find("No collapse: "), 0u);
}

TEST(Summary, TextTellsHowManyOthersStillMoveWhereTheClockStands) {
  auto summary = collapsed_summary();
  EXPECT_NE(to_text(summary, 2).find("\n1 other sphere was still moving and held up too: "),
            std::string::npos);
  EXPECT_NE(to_text(summary, 2).find("  0-3 1-3; 1 other sphere still moving\n"),
            std::string::npos);
  summary.arrest.others_moving = 0;
  EXPECT_EQ(to_text(summary, 2).find("still moving"), std::string::npos);
}

TEST(Summary, OfAnOlderVersionTellsNeitherTheLastTimeNorWhoStillMoves) {
  auto json = Json::parse(to_json(collapsed_summary(), 2));
  json["separation"].erase("last_time");
  json["separation"].erase("longest_pause");
  json["arrest"].erase("others_moving");
  const Summary old = summary_from_json(json.dump(), 2);
  EXPECT_FALSE(old.separation.last_time);
  EXPECT_FALSE(old.arrest.others_moving);
}

TEST(Summary, TextAlignsItsValuesInOneColumn) {
  auto summary = collapsed_summary();
  summary.averages = planar_averages();
  const std::string text = to_text(summary, 2);
  for (const char* line :
       {"\n  collisions              90 (45 per sphere)\n", "\n  arrested pairs          0-3 1-3;",
        "\n    along each axis       0.12          0.075\n",
        "\n    tensor                1             2\n",
        "\n                          3             4\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "is not in\n" << text;
  }
}

TEST(Summary, TextNamesOnlyTheFirstPairsOfALargeCluster) {
  auto summary = collapsed_summary();
  summary.arrest.pairs.assign(9, {4, 5});
  EXPECT_NE(to_text(summary, 2).find(" 4-5 4-5 4-5 4-5 4-5 4-5 and 3 more;"), std::string::npos);
  summary.arrest.pairs.resize(7);
  EXPECT_NE(to_text(summary, 2).find(" 4-5 4-5 4-5 4-5 4-5 4-5 and 1 more;"), std::string::npos);
}

TEST(Summary, TextTellsTheStrainBehindTheTime) {
  Summary summary;
  summary.time = 2;
  EXPECT_NE(to_text(summary, 2).find("\n  time                    2\n"), std::string::npos);
  summary.strain = 5;
  EXPECT_NE(to_text(summary, 2).find("\n  time                    2 (strain 5)\n"),
            std::string::npos);
}

TEST(Summary, TextTellsTheFirstAndTheLastHit) {
  EXPECT_NE(
      to_text(collapsed_summary(), 2).find("12 hits, collisions 70 to 90, first at time 0.25"),
      std::string::npos);
}

TEST(Summary, TextGivesTheStrongestStreakWithTheErrorOfItsMode) {
  Summary summary;
  summary.collisions = 10'000;
  summary.averages = planar_averages();
  summary.averages->streak_amplitude = 0.5;
  summary.averages->streak_modes = {0.1, 0.5, 0.2};
  summary.averages->standard_error = planar_averages();
  summary.averages->standard_error->streak_modes = {0.4, 0.03, 0.002};
  EXPECT_NE(to_text(summary, 2).find("\n  streak amplitude        0.50(3) diameter/time\n"),
            std::string::npos);
}

TEST(Summary, TextGivesTheTemperaturesOfEachKind) {
  Summary summary;
  summary.species = {{"large", 30, 0.5, 0.25}, {"fixed", 1}};
  EXPECT_NE(to_text(summary, 2)
                .find("\n  species large           30 spheres, granular temperature "
                      "0.5, rotational 0.25\n  species fixed           1 sphere\n"),
            std::string::npos);
}

TEST(Summary, CourseHasTheTimesOfTheLastHitAndOfTheLongestPause) {
  const Course course = course_of(collapsed_summary());
  EXPECT_EQ(course.last_hit, 90);
  EXPECT_EQ(course.last_hit_time, 0.5);
  EXPECT_EQ(course.longest_pause, 0.125);
}

}  // namespace
}  // namespace zenosphere
