#include "campaign/message.hpp"

#include <gtest/gtest.h>

#include "campaign/run_columns.hpp"

namespace zenosphere {
namespace {

/// The columns of the store that a summary fills.
std::vector<Cell> cells(const Summary& summary) {
  std::vector<Cell> cells;
  for (const ResultColumn& column : result_columns(summary)) cells.push_back(column.cell);
  return cells;
}

TEST(Message, BringsEveryBitOfASummaryThatTheStoreKeeps) {
  Summary summary;
  summary.outcome = Outcome::collapsed;
  summary.ended_by = EndedBy::arrest;
  summary.verdict = Verdict::arrested;
  summary.collisions = 1234567890123;
  summary.collisions_per_sphere = 1.0 / 3;
  summary.time = 0x1.fffffffffffffp-1;
  summary.separation = {3, 5, 0.1, 7, 0.2, 0.05};
  summary.arrest.met = true;
  summary.arrest.pairs = {{1, 2}, {3, 4}};
  summary.ledger_error = 4.9e-324;
  Averages averages;
  averages.granular_temperature = 2.0 / 3;
  averages.temperature_diagonal = {0.1, 0.2};
  averages.pressure_tensor = {1.0 / 7, -0.0, 0.5, 0.25};
  summary.averages = averages;
  const RunResult result = result_from_message(to_message({42, summary}, 2));
  EXPECT_EQ(result.run, 42);
  ASSERT_TRUE(std::holds_alternative<Summary>(result.outcome));
  EXPECT_EQ(cells(std::get<Summary>(result.outcome)), cells(summary));
}

TEST(Message, BringsFailuresAndDroppedRuns) {
  const RunResult failed = result_from_message(to_message({1, Failure{"a \"b\"\n"}}, 3));
  EXPECT_EQ(std::get<Failure>(failed.outcome).error, "a \"b\"\n");
  const RunResult dropped = result_from_message(to_message({2, Dropped{}}, 3));
  EXPECT_TRUE(std::holds_alternative<Dropped>(dropped.outcome));
}

TEST(Message, BringsATask) {
  const TaskMessage sent{9, "[system]\n", {.wall_seconds = 0.1}};
  const TaskMessage task = task_from_message(to_message(sent));
  EXPECT_EQ(task.run, 9);
  EXPECT_EQ(task.case_text, "[system]\n");
  EXPECT_EQ(task.rules.wall_seconds, 0.1);
  EXPECT_FALSE(task.rules.adjudicate || task.rules.done);
}

TEST(Message, BringsWhatIsToBeAdjudicated) {
  TaskMessage sent{9, "[system]\n"};
  sent.rules.adjudicate = {
      .groups = 3, .seconds = 0.1, .up_to = Precision::digits(250), .collisions = 7};
  sent.rules.done = DoneRun{12};
  const RunRules rules = task_from_message(to_message(sent)).rules;
  ASSERT_TRUE(rules.adjudicate && rules.done);
  EXPECT_EQ(rules.adjudicate->groups, 3);
  EXPECT_EQ(rules.adjudicate->seconds, 0.1);
  EXPECT_EQ(rules.adjudicate->up_to, Precision::digits(250));
  EXPECT_EQ(rules.adjudicate->collisions, 7);
  EXPECT_EQ(rules.done->collisions, 12);
  sent.rules = {.adjudicate = AdjudicationRequest{}, .done = DoneRun{}};
  const RunRules bare = task_from_message(to_message(sent)).rules;
  EXPECT_TRUE(bare.done && !bare.done->collisions);
  EXPECT_TRUE(!bare.adjudicate->groups && !bare.adjudicate->up_to && !bare.adjudicate->collisions);
}

TEST(Message, BringsFindingsWithARunAndWithoutOne) {
  const AdjudicationResult sent{
      {std::string("singular"), Cell(), std::int64_t{1} << 53, 1.0 / 3, 2.0}, {}};
  Summary summary;
  summary.outcome = Outcome::finished;
  summary.ended_by = EndedBy::collisions;
  summary.verdict = Verdict::none;
  const RunResult whole = result_from_message(to_message({4, summary, sent}, 2));
  EXPECT_TRUE(std::holds_alternative<Summary>(whole.outcome));
  ASSERT_TRUE(whole.adjudication);
  EXPECT_EQ(whole.adjudication->cells, sent.cells);
  const RunResult alone = result_from_message(to_message({4, Unchanged{}, sent}, 2));
  EXPECT_TRUE(std::holds_alternative<Unchanged>(alone.outcome));
  EXPECT_EQ(alone.adjudication->cells, sent.cells);
  const AdjudicationResult failed{{}, "no hit"};
  EXPECT_EQ(result_from_message(to_message({4, Unchanged{}, failed}, 2)).adjudication->error,
            "no hit");
}

}  // namespace
}  // namespace zenosphere
