#include <cmath>

#include "store_fixture.hpp"

namespace zenosphere {
namespace {

Summary with_averages() {
  Summary summary = some_summary();
  Averages& averages = summary.averages.emplace();
  averages.pressure = 2;
  averages.temperature_diagonal = {1, 3};
  averages.pressure_tensor = {1, 2, 3, 4};
  averages.sonine_a2 = -0.5;
  averages.blocks = 40;
  averages.steady = false;
  averages.steady_reason = "not steady: why";
  Observables& errors = averages.standard_error.emplace();
  errors.pressure = 0.25;
  errors.pressure_tensor = {0.5, std::nan(""), 0, 0};
  errors.sonine_a2 = std::nan("");
  return summary;
}

TEST_F(SweepStoreTest, OfANewerFormatIsRefused) {
  store();
  Database(path(), Database::Access::write).execute("PRAGMA user_version = 5");
  EXPECT_NE(refusal(small_sweep).find("is a store of format 5"), std::string::npos);
}

TEST_F(SweepStoreTest, OfTheFirstFormatIsReadAndExtendedInPlace) {
  {
    SweepStore opened = store();
    opened.record({1, with_hits()});
    opened.commit();
  }
  make_first_format();
  {
    Database database(path(), Database::Access::read);
    const StoredSweep old = stored_sweep(database);
    EXPECT_EQ(run_counts(database, old).done, 1);
    EXPECT_EQ(StoredRuns(database, old).run(1).run, 1);
  }
  SweepStore opened = store(judging_sweep);
  EXPECT_EQ(opened.sweep().format_version, 4);
  EXPECT_EQ(row_of(1), "done|320|||");
  opened.record({1, Unchanged{}, some_findings()});
  opened.commit();
  EXPECT_EQ(row_of(1), "done|320|singular|7|");
}

TEST_F(SweepStoreTest, OfTheSecondFormatGetsTheColumnThatItLacks) {
  store(judging_sweep);
  {
    Database database(path(), Database::Access::write);
    database.execute("ALTER TABLE run DROP COLUMN adjudication_margin_per_decade");
    database.execute("PRAGMA user_version = 2");
  }
  SweepStore opened = store(judging_sweep);
  opened.record({1, with_hits(), some_findings()});
  opened.commit();
  EXPECT_EQ(row_of(1), "done|320|singular|7|");
}

TEST_F(SweepStoreTest, OfTheThirdFormatGetsTheErrorsOfAverages) {
  {
    SweepStore opened = store();
    opened.record({0, some_summary()});
    opened.commit();
  }
  {
    Database database(path(), Database::Access::write);
    database.execute("ALTER TABLE run DROP COLUMN pressure_standard_error");
    database.execute("ALTER TABLE run DROP COLUMN sonine_a2");
    database.execute("PRAGMA user_version = 3");
  }
  SweepStore opened = store();
  opened.record({1, with_averages()});
  opened.commit();
  EXPECT_EQ(cell("pressure_standard_error", 0), "");
  EXPECT_EQ(cell("pressure_standard_error", 1), "0.25");
  EXPECT_EQ(cell("sonine_a2", 1), "-0.5");
}

TEST_F(SweepStoreTest, KeepsAveragesWithTheirErrors) {
  SweepStore opened = store();
  opened.record({1, with_averages()});
  opened.commit();
  EXPECT_EQ(cell("pressure", 1), "2");
  EXPECT_EQ(cell("pressure_tensor", 1), "[[1, 2], [3, 4]]");
  EXPECT_EQ(cell("pressure_tensor_standard_error", 1), "[[0.5, null], [0, 0]]");
  EXPECT_EQ(cell("temperature_diagonal", 1), "[1, 3]");
  EXPECT_EQ(cell("wall_pressure", 1), "");
  EXPECT_EQ(cell("sonine_a2_standard_error", 1), "");  // is no number
  EXPECT_EQ(cell("averages_blocks", 1), "40");
  EXPECT_EQ(cell("averages_steady", 1), "0");
  EXPECT_EQ(cell("averages_steady_reason", 1), "not steady: why");
}

}  // namespace
}  // namespace zenosphere
