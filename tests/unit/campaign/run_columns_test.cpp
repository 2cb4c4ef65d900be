#include "campaign/run_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace zenosphere {
namespace {

std::vector<std::string> names_of_columns() {
  std::vector<std::string> names;
  for (const ResultColumn& column : result_columns()) names.push_back(column.name);
  return names;
}

TEST(RunColumns, HaveTheOrderOfEveryFormatOfTheStore) {
  const std::vector<std::string> first{"outcome",
                                       "ended_by",
                                       "verdict",
                                       "collisions",
                                       "collisions_per_sphere",
                                       "time",
                                       "strain",
                                       "separation_hits",
                                       "separation_first_collision",
                                       "separation_first_time",
                                       "separation_last_collision",
                                       "arrest_met",
                                       "arrest_collision",
                                       "arrest_time",
                                       "arrest_window",
                                       "arrest_pairs",
                                       "absorbed",
                                       "granular_temperature",
                                       "granular_temperature_standard_error"};
  const std::vector<std::string> last{"streak_amplitude",
                                      "temperature_without_streak",
                                      "averages_from_time",
                                      "averages_to_time",
                                      "averages_blocks",
                                      "averages_steady",
                                      "averages_steady_reason",
                                      "ledger_error",
                                      "wall_seconds",
                                      "program_version",
                                      "git_hash"};
  const auto names = names_of_columns();
  EXPECT_TRUE(std::equal(first.begin(), first.end(), names.begin()));
  EXPECT_TRUE(std::equal(last.rbegin(), last.rend(), names.rbegin()));
}

Cell cell(const Summary& summary, std::string_view name) {
  const auto columns = result_columns(summary);
  const auto found = std::ranges::find(columns, name, &ResultColumn::name);
  return found == columns.end() ? Cell("no such column") : found->cell;
}

TEST(RunColumns, OfARunWithoutAveragesAreNull) {
  for (const char* name : {"pressure", "pressure_standard_error", "averages_to_time",
                           "averages_steady_reason", "streak_amplitude"}) {
    EXPECT_EQ(cell(Summary(), name), Cell()) << name;
  }
}

TEST(RunColumns, HoldWordsNumbersAndPairsAsTheyAreRead) {
  Summary summary;
  summary.outcome = Outcome::collapsed;
  summary.arrest.met = true;
  summary.arrest.pairs = {{1, 2}, {3, 4}};
  EXPECT_EQ(cell(summary, "outcome"), Cell("collapsed"));
  EXPECT_EQ(cell(summary, "ended_by"), Cell(""));
  EXPECT_EQ(cell(summary, "arrest_met"), Cell(std::int64_t{1}));
  EXPECT_EQ(cell(summary, "arrest_pairs"), Cell("[[1, 2], [3, 4]]"));
}

}  // namespace
}  // namespace zenosphere
