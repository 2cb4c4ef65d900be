#include "campaign/store.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "campaign/csv.hpp"
#include "campaign/seeds.hpp"
#include "model/errors.hpp"
#include "store_fixture.hpp"

namespace zenosphere {
namespace {

TEST_F(SweepStoreTest, HasARowForEveryRunWithTheReplicaOutermost) {
  store();
  EXPECT_EQ(rows(), (std::vector<std::string>{"0 0 0 0.2 0.2 pending", "1 1 0 0.2 0.3 pending",
                                              "2 2 0 0.9 0.2 pending", "3 3 0 0.9 0.3 pending",
                                              "4 0 1 0.2 0.2 pending", "5 1 1 0.2 0.3 pending",
                                              "6 2 1 0.9 0.2 pending", "7 3 1 0.9 0.3 pending"}));
}

TEST_F(SweepStoreTest, GivesRunsTheSeedOfTheirNumber) {
  SweepStore opened = store();
  const auto tasks = opened.pending(3, 2);
  ASSERT_EQ(tasks.size(), 2U);
  EXPECT_EQ(tasks[1].run, 4);
  EXPECT_EQ(tasks[1].overrides[0], "start.seed=" + std::to_string(run_seed(7, 4)));
}

TEST_F(SweepStoreTest, CsvPutsTextsWithCommasInQuotesAndDoublesThoseInThem) {
  SweepStore opened = store();
  opened.record({1, Failure{"key \"a\", not b"}});
  opened.commit();
  Database database(path(), Database::Access::read);
  std::string table;
  write_csv(database, [&](const std::string& text) { table += text; });
  EXPECT_NE(table.find(",failed,\"key \"\"a\"\", not b\","), std::string::npos) << table;
}

TEST_F(SweepStoreTest, KeepsWhatWasCommittedAndDropsWhatWasNot) {
  {
    SweepStore opened = store();
    opened.record({1, some_summary()});
    opened.commit();
    opened.record({2, some_summary()});
    opened.record({3, Dropped{}});
  }
  const RunCounts counts = store().counts();
  EXPECT_EQ(counts.done, 1);
  EXPECT_EQ(counts.pending, 7);
}

TEST_F(SweepStoreTest, RecordsAFailureOnceUntilItIsForgotten) {
  SweepStore opened = store();
  opened.record({5, Failure{"too dense"}});
  opened.commit();
  EXPECT_EQ(opened.counts().failed, 1);
  EXPECT_EQ(opened.pending(5, 1)[0].run, 6);
  opened.forget_failures();
  EXPECT_EQ(opened.pending(5, 1)[0].run, 5);
}

TEST_F(SweepStoreTest, AppendsWhatALongerSweepAdds) {
  {
    SweepStore opened = store();
    opened.record({0, some_summary()});
    opened.commit();
  }
  store(replaced(small_sweep, "[0.2, 0.9]", "[0.9, 0.5, 0.2]"));
  const std::vector<std::string> more = rows();
  ASSERT_EQ(more.size(), 12U);
  EXPECT_EQ(more[0], "0 0 0 0.2 0.2 done");
  EXPECT_EQ(more[7], "7 3 1 0.9 0.3 pending");
  EXPECT_EQ(more[8], "8 4 0 0.5 0.2 pending");
  EXPECT_EQ(more[9], "9 5 0 0.5 0.3 pending");
  EXPECT_EQ(more[10], "10 4 1 0.5 0.2 pending");
  EXPECT_EQ(more[11], "11 5 1 0.5 0.3 pending");
}

TEST_F(SweepStoreTest, AppendsMoreSeedsAtThePointsThereAre) {
  store();
  store(replaced(small_sweep, "[0.2, 0.9]", "[0.9, 0.5, 0.2]"));
  store(replaced(replaced(small_sweep, "[0.2, 0.9]", "[0.9, 0.5, 0.2]"), "seeds = 2", "seeds = 3"));
  const std::vector<std::string> more = rows();
  ASSERT_EQ(more.size(), 18U);
  EXPECT_EQ(more[12], "12 2 2 0.9 0.2 pending");
  EXPECT_EQ(more[14], "14 4 2 0.5 0.2 pending");
  EXPECT_EQ(more[17], "17 1 2 0.2 0.3 pending");
}

TEST_F(SweepStoreTest, AddsNothingTwice) {
  store();
  store();
  EXPECT_EQ(rows().size(), 8U);
}

TEST_F(SweepStoreTest, IsNotTakenOverByAnotherSweep) {
  store();
  std::string other = replaced(small_sweep, "[0.2, 0.9]", "[0.2, 0.8]");
  other = replaced(other, "seeds = 2", "seeds = 1");
  other = replaced(other, "spheres = 32", "spheres = 108");
  other = replaced(other, "collisions_per_sphere = 20", "collisions_per_sphere = 30");
  const std::string told = refusal(other);
  EXPECT_EQ(told.substr(told.find('\n')),
            "\n  stop.collisions_per_sphere is 30 (20 in the store)"
            "\n  system.spheres is 108 (32 in the store)"
            "\n  sweep.seeds is 1 (2 in the store)"
            "\n  axes.\"system.restitution\" lacks 0.9 (which the store has)");
  EXPECT_EQ(rows().size(), 8U);
}

TEST_F(SweepStoreTest, IsTakenOverByTheSameSweepInOtherWords) {
  store();
  EXPECT_EQ(
      refusal("# a remark\n" + replaced(small_sweep, "shear_rate = 1", "shear_rate = 1  # x")),
      "accepted");
}

TEST_F(SweepStoreTest, IsWrittenByOneSweepAtATime) {
  const SweepStore first = store();
  EXPECT_NE(refusal(small_sweep).find("another sweep is writing to it"), std::string::npos);
}

TEST_F(SweepStoreTest, IsLockedUnderEveryNameThatLeadsToIt) {
  const SweepStore first = store();
  const std::string link = (folder_.path / "link.sqlite").string();
  std::filesystem::create_symlink("s.sqlite", link);
  EXPECT_THROW(SweepStore(link, parse_sweep(small_sweep, "s.toml")), OutputError);
}

TEST_F(SweepStoreTest, LeavesNothingBesideItselfWhenItIsClosed) {
  store();
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path)) {
    EXPECT_EQ(entry.path().filename(), "s.sqlite");
    ++files;
  }
  EXPECT_EQ(files, 1);
}

TEST_F(SweepStoreTest, IsNoFileOfAnotherProgram) {
  std::ofstream(path()) << "a text that is long enough to be no empty database\n";
  EXPECT_NE(refusal(small_sweep).find("is not the store of a sweep"), std::string::npos);
  std::filesystem::remove(path());
  Database(path(), Database::Access::write).execute("CREATE TABLE mine (x)");
  EXPECT_NE(refusal(small_sweep).find("is a database of another program"), std::string::npos);
}

TEST_F(SweepStoreTest, KeepsFindingsBesideTheRun) {
  SweepStore opened = store(judging_sweep);
  opened.record({1, with_hits(), some_findings()});
  opened.commit();
  EXPECT_EQ(row_of(1), "done|320|singular|7|");
  EXPECT_EQ(opened.counts().left(), 7);
}

TEST_F(SweepStoreTest, KeepsARunWhoseAdjudicationFailedWithTheReason) {
  SweepStore opened = store(judging_sweep);
  opened.record({1, with_hits(), AdjudicationResult{{}, "adjudication: no"}});
  opened.commit();
  EXPECT_EQ(row_of(1), "done|320|||adjudication: no");
  EXPECT_EQ(opened.counts().failed_adjudications, 1);
  EXPECT_EQ(opened.counts().to_adjudicate, 0);
  opened.forget_failures();
  EXPECT_EQ(opened.counts().to_adjudicate, 1);
}

TEST_F(SweepStoreTest, HandsOutRunsWithHitsToBeAdjudicatedLater) {
  {
    SweepStore opened = store();
    opened.record({0, some_summary()});
    opened.record({1, with_hits()});
    Summary cut_off = with_hits();
    cut_off.ended_by = EndedBy::wall_time;
    opened.record({2, cut_off});
    opened.commit();
    EXPECT_EQ(opened.counts().to_adjudicate, 0);
  }
  SweepStore opened = store(judging_sweep);
  EXPECT_EQ(opened.counts().to_adjudicate, 2);
  const auto tasks = opened.pending(0, 3);  // run 0 has no hit
  ASSERT_EQ(tasks.size(), 3U);
  EXPECT_TRUE(tasks[0].run == 1 && tasks[0].done && !tasks[0].done->collisions);
  EXPECT_TRUE(tasks[1].run == 2 && tasks[1].done && tasks[1].done->collisions == 320);
  EXPECT_TRUE(tasks[2].run == 3 && !tasks[2].done);
  opened.record({1, Unchanged{}, some_findings()});
  opened.commit();
  EXPECT_EQ(row_of(1), "done|320|singular|7|");
  EXPECT_EQ(opened.counts().to_adjudicate, 1);
}

TEST_F(SweepStoreTest, WithFindingsKeepsItsAdjudication) {
  const std::string other = replaced(judging_sweep, "groups = 1", "groups = 2");
  store(judging_sweep);
  EXPECT_EQ(refusal(other), "accepted");  // nothing has been adjudicated yet
  {
    SweepStore opened = store(judging_sweep);
    opened.record({1, with_hits(), some_findings()});
    opened.commit();
  }
  EXPECT_NE(refusal(other).find("\n  adjudicate.groups is 2 (1 in the store)"), std::string::npos);
  EXPECT_NE(refusal(replaced(judging_sweep, "groups", "up_to = \"quad\"\ngroups"))
                .find("\n  adjudicate.up_to is quad (absent in the store)"),
            std::string::npos);
  EXPECT_NE(refusal(small_sweep).find("\n  [adjudicate] is absent (there in the store)"),
            std::string::npos);
  EXPECT_EQ(refusal(judging_sweep), "accepted");
}

TEST_F(SweepStoreTest, ThatIsDamagedIsRefused) {
  store();
  {
    std::fstream file(path(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(4096);  // the second page
    file << std::string(4096, 'x');
  }
  EXPECT_NE(refusal(small_sweep).find("is damaged"), std::string::npos);
}

}  // namespace
}  // namespace zenosphere
