#include "campaign/boundary_rounds.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../storage/temporary_folder.hpp"
#include "campaign/store.hpp"
#include "model/errors.hpp"
#include "sweep_texts.hpp"

namespace zenosphere {
namespace {

/// Two points, each searched along the restitution. `[boundary]` is on line 3, its axis on line 4.
const std::string small_search = R"([sweep]
master_seed = 7
[boundary]
axis = "system.restitution"
criterion = "arrest"
from = 0.1
to = 0.9
resolution = 0.1
runs = 60
[axes]
"system.solids_volume_fraction" = [0.2, 0.3]
[stop]
collisions_per_sphere = 20
)" + inline_case;

std::string boundary_refusal(const std::string& part, const std::string& other) {
  try {
    parse_sweep(replaced(small_search, part, other), "s.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

class BoundaryRoundsTest : public testing::Test {
 protected:
  std::string path() const { return (folder_.path / "s.sqlite").string(); }

  /// Opens the store as the program does, which creates it.
  void open(const Sweep& sweep) { SweepStore(path(), sweep); }

  /// Lets all pending runs end: an arrest where e is below 0.1 + the volume fraction.
  void end_runs() {
    Database(path(), Database::Access::write)
        .execute(
            "UPDATE run SET status = 'done', separation_hits = 1, arrest_met = "
            "\"system.restitution\" < 0.1 + \"system.solids_volume_fraction\" WHERE status = "
            "'pending'");
  }

  Cell value(const std::string& sql) { return Database(path(), Database::Access::read).value(sql); }

  /// Goes through a search, opening the store anew for each of so many rounds at a time.
  void search(const Sweep& sweep, int rounds_at_a_time) {
    for (bool goes_on = true; goes_on;) {
      Database database(path(), Database::Access::write);
      BoundaryRounds rounds(database, sweep);
      end_runs();
      for (int n = 0; n < rounds_at_a_time && goes_on; ++n) {
        goes_on = rounds.place_next();
        end_runs();
      }
    }
  }

  TemporaryFolder folder_;
};

TEST(BoundaryRequest, IsReadWithItsAxisLast) {
  const Sweep sweep = parse_sweep(small_search, "s.toml");
  ASSERT_TRUE(sweep.boundary.has_value());
  ASSERT_EQ(sweep.axes.size(), 2U);
  EXPECT_EQ(sweep.axes.back().path(), "system.restitution");
  EXPECT_EQ(sweep.searches(), 2);
  EXPECT_EQ(sweep.runs(), 120);
  EXPECT_EQ(sweep.boundary->range.round_runs, 8);
  EXPECT_FALSE(sweep.boundary->range.is_whole);
}

TEST(BoundaryRequest, EndsOfTheRangeMustBeValuesOfTheKey) {
  EXPECT_EQ(boundary_refusal("to = 0.9", "to = 1.9"),
            "s.toml:7:6: system.restitution = 1.9 (must be in [0, 1]; 1 is elastic)");
}

TEST(BoundaryRequest, WrongOnesAreRefusedWithWhatToDo) {
  EXPECT_EQ(boundary_refusal("master_seed = 7", "seeds = 3"),
            "s.toml:3:2: boundary (a search decides how many runs it needs); remove sweep.seeds");
  EXPECT_EQ(boundary_refusal("\"arrest\"", "\"arest\""),
            "s.toml:5:13: boundary.criterion = \"arest\" (must be \"separation\" or \"arrest\")");
  EXPECT_EQ(boundary_refusal("to = 0.9", "to = 0.1"),
            "s.toml:7:6: boundary.to = 0.1 (must be > from = 0.1)");
  EXPECT_EQ(boundary_refusal("resolution = 0.1", "resolution = 2"),
            "s.toml:8:14: boundary.resolution = 2 (must be in [0.0008, 0.8], parts of the range)");
  EXPECT_EQ(boundary_refusal("system.restitution", "system.restituton"),
            "s.toml:4:8: boundary.axis = \"system.restituton\" (is no key of a case); did you mean "
            "\"system.restitution\"?");
  EXPECT_EQ(boundary_refusal("system.restitution", "collision.overlap"),
            "s.toml:4:8: boundary.axis = \"collision.overlap\" (must be a key with a number, and "
            "not the seed)");
  EXPECT_EQ(boundary_refusal("system.restitution", "system.solids_volume_fraction"),
            "s.toml:4:8: boundary.axis = \"system.solids_volume_fraction\" (is under [axes] too); "
            "remove it there");
  EXPECT_EQ(boundary_refusal("[0.2, 0.3]", "{ from = 0.1, to = 0.3, points = 1001 }"),
            "s.toml: 1001 points to search at (at most 1000); give fewer values");
  EXPECT_EQ(boundary_refusal("resolution = 0.1\n", ""),
            "s.toml:3:2: boundary (needs axis, criterion, from, to and resolution); add what is "
            "missing");
}

TEST_F(BoundaryRoundsTest, FindTheCrossingOfEachPoint) {
  const Sweep sweep = parse_sweep(small_search, "s.toml");
  open(sweep);
  search(sweep, 100);
  for (const auto& [point, crossing] : {std::pair("0", 0.3), std::pair("1", 0.4)}) {
    const std::string row = std::string(" FROM boundary WHERE point = ") + point;
    EXPECT_EQ(cell_text(value("SELECT finding" + row)), "crossing");
    EXPECT_LE(std::get<double>(value("SELECT low" + row)), crossing);
    EXPECT_GE(std::get<double>(value("SELECT high" + row)), crossing);
    EXPECT_EQ(value("SELECT runs" + row),
              value(std::string("SELECT count(*) FROM run WHERE point = ") + point));
  }
}

TEST_F(BoundaryRoundsTest, AreTheSameInOneGoAndWithAStopAfterEach) {
  const Sweep sweep = parse_sweep(small_search, "s.toml");
  const std::string all =
      "SELECT group_concat(run || ' ' || point || ' ' || replica || ' ' || seed || ' ' || "
      "\"system.restitution\") FROM run";
  open(sweep);
  search(sweep, 100);
  const Cell at_once = value(all);
  const Cell places = value("SELECT group_concat(place) FROM boundary");
  std::filesystem::remove(path());
  open(sweep);
  search(sweep, 1);
  EXPECT_EQ(value(all), at_once);
  EXPECT_EQ(value("SELECT group_concat(place) FROM boundary"), places);
}

TEST_F(BoundaryRoundsTest, FirstRoundOfEveryPointIsThereAtOnce) {
  const Sweep sweep = parse_sweep(small_search, "s.toml");
  open(sweep);
  Database database(path(), Database::Access::write);
  BoundaryRounds rounds(database, sweep);
  EXPECT_TRUE(rounds.place_next());
  EXPECT_EQ(value("SELECT count(*) FROM run WHERE status = 'pending'"), Cell(std::int64_t{16}));
  EXPECT_EQ(value("SELECT max(\"system.restitution\") FROM run"), Cell(0.9));
}

TEST_F(BoundaryRoundsTest, ShareNoStoreWithAGridOrAnotherCriterion) {
  open(parse_sweep(small_search, "s.toml"));
  {
    Database database(path(), Database::Access::write);
    const Sweep sweep = parse_sweep(small_search, "s.toml");
    BoundaryRounds(database, sweep).place_next();
  }
  EXPECT_THROW(open(parse_sweep(small_sweep, "s.toml")), InputError);
  EXPECT_THROW(open(parse_sweep(replaced(small_search, "arrest", "separation"), "s.toml")),
               InputError);
  EXPECT_NO_THROW(
      open(parse_sweep(replaced(small_search, "resolution = 0.1", "resolution = 0.05"), "s.toml")));
}

TEST_F(BoundaryRoundsTest, LearnNothingFromARunThatItsWallTimeEnded) {
  const Sweep sweep = parse_sweep(small_search, "s.toml");
  open(sweep);
  Database database(path(), Database::Access::write);
  BoundaryRounds rounds(database, sweep);
  rounds.place_next();
  end_runs();
  database.execute("UPDATE run SET ended_by = 'wall time' WHERE run < 3");
  rounds.place_next();
  EXPECT_EQ(value("SELECT failed FROM boundary WHERE point = 0"), Cell(std::int64_t{3}));
  EXPECT_EQ(value("SELECT failed FROM boundary WHERE point = 1"), Cell(std::int64_t{0}));
}

TEST_F(BoundaryRoundsTest, KeepTheirPointsSinceRowsAreKnownByTheirNumber) {
  open(parse_sweep(small_search, "s.toml"));
  for (const char* values : {"[0.2, 0.25, 0.3]", "[0.3, 0.2]", "[0.2, 0.3, 0.4]", "[0.2]"}) {
    const Sweep other = parse_sweep(replaced(small_search, "[0.2, 0.3]", values), "s.toml");
    EXPECT_THROW(open(other), InputError) << values;
  }
}

}  // namespace
}  // namespace zenosphere
