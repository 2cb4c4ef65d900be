#include "campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <string>

#include "../storage/temporary_folder.hpp"
#include "campaign/csv.hpp"
#include "campaign/show.hpp"
#include "campaign/thread_workers.hpp"
#include "case/case_file.hpp"
#include "run/run.hpp"
#include "sweep_texts.hpp"

namespace zenosphere {
namespace {

class CampaignTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path / name).string(); }

  SweepProgress run(const std::string& name, std::size_t threads,
                    const std::string& text = small_sweep, const SweepOptions& options = {}) {
    SweepStore store(path(name), parse_sweep(text, "s.toml"));
    ThreadWorkers workers(store.setting(), threads);
    return run_sweep(store, workers, options);
  }

  /// All rows but for wall times.
  std::string rows(const std::string& name) const {
    Database(path(name), Database::Access::write).execute("UPDATE run SET wall_seconds = 0");
    Database database(path(name), Database::Access::read);
    std::string rows;
    write_csv(database, [&](const std::string& text) { rows += text; });
    return rows;
  }

  TemporaryFolder folder_;
};

TEST_F(CampaignTest, HasTheSameRowsWhateverTheNumberOfThreads) {
  run("one.sqlite", 1);
  run("four.sqlite", 4);
  EXPECT_EQ(rows("one.sqlite"), rows("four.sqlite"));
}

TEST_F(CampaignTest, DoesNothingTwice) {
  EXPECT_EQ(run("s.sqlite", 2).ended_here, 8);
  const SweepProgress again = run("s.sqlite", 2);
  EXPECT_EQ(again.ended_here, 0);
  EXPECT_EQ(again.counts.done, 8);
}

TEST_F(CampaignTest, GoesOnWithTheOtherRunsWhereOneFails) {
  const std::string head = "2\nLattice=\"9 0 0 0 1 0 0 0 1\" Properties=pos:R:3:velo:R:3\n";
  std::ofstream(path("apart.xyz")) << head << "1 0 0 1 0 0\n5 0 0 -1 0 0\n";
  std::ofstream(path("overlapping.xyz")) << head << "1 0 0 1 0 0\n1.5 0 0 -1 0 0\n";
  const std::string text = R"([sweep]
seeds = 1
[axes]
"start.file" = ["OVERLAPPING", "APART"]
[case.system]
dimension = 1
spheres = 2
sides = [9]
restitution = 0.9
[case.start]
arrangement = "file"
[case.drive]
kind = "none"
[case.run]
collisions = 10
)";
  const SweepProgress progress = run(
      "s.sqlite", 2,
      replaced(replaced(text, "OVERLAPPING", path("overlapping.xyz")), "APART", path("apart.xyz")));
  EXPECT_EQ(progress.counts.done, 1);
  EXPECT_EQ(progress.counts.failed, 1);
  Database database(path("s.sqlite"), Database::Access::read);
  EXPECT_NE(cell_text(database.value("SELECT error FROM run WHERE run = 0")).find("overlap"),
            std::string::npos);
}

TEST_F(CampaignTest, DropsRunsInWorkWhenItIsInterrupted) {
  const std::string endless =
      replaced(small_sweep, "collisions_per_sphere = 20", "collisions_per_sphere = 1e12");
  std::atomic<bool> interrupt{false};
  const SweepOptions options{.interrupt = &interrupt,
                             .on_progress = [&](const SweepProgress&) { interrupt = true; }};
  const SweepProgress progress =
      run("s.sqlite", 2, replaced(endless, "[0.2, 0.9]", "[0.99, 1]"), options);
  EXPECT_EQ(progress.counts.done, 0);
  EXPECT_EQ(progress.counts.pending, 8);
}

TEST_F(CampaignTest, EndsRunsThatTakeLongerThanTheirWallTimeAndSaysSo) {
  const std::string endless =
      replaced(small_sweep, "collisions_per_sphere = 20", "wall_seconds = 0.01") +
      "[case.run]\ntime = 1e9\n";
  run("s.sqlite", 4, replaced(replaced(endless, "seeds = 2", "seeds = 1"), "[0.2, 0.9]", "[0.99]"));
  Database database(path("s.sqlite"), Database::Access::read);
  EXPECT_EQ(database.integer("SELECT count(*) FROM run WHERE ended_by = 'wall time' AND outcome = "
                             "'interrupted' AND status = 'done'"),
            2);
}

TEST_F(CampaignTest, ShowsTheCaseThatRepeatsARun) {
  run("s.sqlite", 2);
  Database database(path("s.sqlite"), Database::Access::read);
  for (const int number : {1, 6}) {
    const Case values = parse_case(case_text_of_run(path("s.sqlite"), number), "case.toml", {});
    const Summary summary = run_case(values, {});
    const auto stored = [&](const std::string& column) {
      return database.value("SELECT " + column + " FROM run WHERE run = " + std::to_string(number));
    };
    EXPECT_EQ(stored("collisions"), Cell(summary.collisions));
    EXPECT_EQ(stored("verdict"), Cell(word(summary.verdict)));
    EXPECT_EQ(stored("time"), Cell(summary.time));
    EXPECT_EQ(stored("granular_temperature"), Cell(summary.averages->granular_temperature));
    EXPECT_EQ(stored("separation_hits"), Cell(summary.separation.hits));
  }
}

}  // namespace
}  // namespace zenosphere
