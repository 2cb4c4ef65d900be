#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "../storage/temporary_folder.hpp"
#include "campaign/run_case.hpp"
#include "campaign/sweep.hpp"
#include "case/case_file.hpp"
#include "model/errors.hpp"
#include "sweep_texts.hpp"

namespace zenosphere {
namespace {

/// What is said against a sweep file.
std::string refusal(const std::string& text) {
  try {
    parse_sweep(text, "s.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// The same of the small sweep with one part replaced.
std::string refusal(const std::string& part, const std::string& other) {
  return refusal(replaced(small_sweep, part, other));
}

TEST(SweepFile, GivesAxesInTheOrderOfTheFile) {
  const Sweep sweep = parse_sweep(small_sweep, "s.toml");
  ASSERT_EQ(sweep.axes.size(), 2U);
  EXPECT_EQ(sweep.axes[0].path(), "system.restitution");
  EXPECT_EQ(sweep.axes[1].path(), "system.solids_volume_fraction");
  EXPECT_EQ(sweep.points(), 4);
  EXPECT_EQ(sweep.runs(), 8);
}

TEST(SweepFile, TakesAxesInTablesOfTheirOwn) {
  const Sweep sweep =
      parse_sweep(replaced(small_sweep, "\"system.restitution\"", "system.restitution"), "s.toml");
  ASSERT_EQ(sweep.axes.size(), 2U);
  EXPECT_EQ(sweep.axes[0].path(), "system.restitution");
}

TEST(SweepFile, GivesEachRunItsValuesItsSeedAndItsStop) {
  const Sweep sweep = parse_sweep(small_sweep, "s.toml");
  const Case values = case_of_run(sweep.base, sweep.stop, overrides_of(sweep, 5));
  EXPECT_EQ(values.system.restitution, 0.2);  // run 5: replica 1, point 1
  EXPECT_EQ(values.system.solids_volume_fraction, 0.3);
  EXPECT_EQ(values.run.collisions, 320);  // 20 x 32 / 2
}

TEST(SweepFile, StopsARunThatItsCaseStopsEarlierWhereTheCaseSays) {
  const Sweep sweep = parse_sweep(small_sweep + "[case.run]\ncollisions = 5\n", "s.toml");
  EXPECT_EQ(case_of_run(sweep.base, sweep.stop, overrides_of(sweep, 0)).run.collisions, 5);
}

TEST(SweepFile, BaseTextStandsForTheBaseCase) {
  const Sweep sweep = parse_sweep(small_sweep, "s.toml");
  const CaseTemplate base(case_format::entries_of(sweep.base_text, "base"), "base");
  for (int run = 0; run < 8; ++run) {
    const auto overrides = overrides_of(sweep, run);
    EXPECT_EQ(resolved_toml(case_of_run(base, sweep.stop, overrides)),
              resolved_toml(case_of_run(sweep.base, sweep.stop, overrides)));
  }
}

TEST(SweepFile, MayVaryKeysOfSpeciesAndContacts) {
  const Sweep sweep = parse_sweep(mixture_sweep, "s.toml");
  const Case values = case_of_run(sweep.base, sweep.stop, overrides_of(sweep, 3));
  EXPECT_EQ(values.species[1].mass, 10);
  EXPECT_EQ(values.contacts[0].restitution, 0.7);
  EXPECT_EQ(values.contacts[0].friction->coefficient, 0.1);
}

TEST(SweepFile, TakesAxesOverSpeciesInTablesOfTheirOwn) {
  const Sweep sweep =
      parse_sweep(replaced(mixture_sweep, "\"species.heavy.mass\" = [1, 10]",
                           "species.heavy.mass = { from = 1, to = 10, points = 2 }"),
                  "s.toml");
  EXPECT_EQ(sweep.axes[0].path(), "species.heavy.mass");
  EXPECT_EQ(case_of_run(sweep.base, sweep.stop, overrides_of(sweep, 3)).species[1].mass, 10);
}

TEST(SweepFile, BaseTextHasSpeciesAndContactsWithoutTheKeysOfAxes) {
  const Sweep sweep = parse_sweep(mixture_sweep, "s.toml");
  EXPECT_EQ(sweep.base_text.find("mass"), std::string::npos);
  const CaseTemplate base(case_format::entries_of(sweep.base_text, "base"), "base");
  for (int run = 0; run < 8; ++run) {
    const auto overrides = overrides_of(sweep, run);
    EXPECT_EQ(resolved_toml(case_of_run(base, sweep.stop, overrides)),
              resolved_toml(case_of_run(sweep.base, sweep.stop, overrides)));
  }
}

TEST(SweepFile, RefusesAxesOverSpeciesThatAreNotThere) {
  const auto told = [](const std::string& key) {
    return refusal(replaced(mixture_sweep, "species.heavy.mass", key));
  };
  EXPECT_EQ(told("species.heavy.mas"),
            "s.toml:4:1: unknown key axes.\"species.heavy.mas\" (an axis is over a key of the "
            "case); did you mean \"species.heavy.mass\"?");
  EXPECT_EQ(told("species.heavie.mass"),
            "s.toml:4:26: axes.\"species.heavie.mass\" (the base case has no [[species]] heavie); "
            "use a name that it has");
  EXPECT_EQ(told("contact.heavy.light.friction"),
            "s.toml:4:35: axes.\"contact.heavy.light.friction\" (the base case has no [[contact]] "
            "heavy.light); use a name that it has");
  EXPECT_EQ(told("species.heavy.share"),
            "s.toml:4:26: species.heavy.share = 1.0 (the shares add up to 1.5, must be 1)\n"
            "s.toml:4:29: species.heavy.share = 10.0 (must be in (0, 1])");
}

TEST(SweepFile, NamesItsBaseCaseRelativeToItself) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "base.toml")
      << "[system]\ndimension = 1\nspheres = 3\nsides = [9]\n[start]\narrangement = \"file\"\nfile "
         "= "
         "\"start.xyz\"\n[drive]\nkind = \"none\"\n[run]\ntime = 1\n";
  std::ofstream(folder.path / "s.toml")
      << "[sweep]\ncase = \"base.toml\"\nseeds = 1\n[axes]\n\"system.restitution\" = [0.5]\n";
  const Sweep sweep = read_sweep(folder.path / "s.toml");
  EXPECT_EQ(case_of_run(sweep.base, sweep.stop, overrides_of(sweep, 0)).start.file,
            (folder.path / "start.xyz").string());
}

TEST(SweepFile, StartFilesOfAnAxisAreFromTheFolderOfTheBaseCase) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "base.toml")
      << "[system]\ndimension = 1\nspheres = 3\nsides = [9]\nrestitution = 0.5\n[start]\n"
         "arrangement = \"file\"\n[drive]\nkind = \"none\"\n[run]\ntime = 1\n";
  std::ofstream(folder.path / "s.toml")
      << "[sweep]\ncase = \"base.toml\"\nseeds = 1\n[axes]\n\"start.file\" = [\"a.xyz\"]\n";
  const Sweep sweep = read_sweep(folder.path / "s.toml");
  EXPECT_EQ(column_text(sweep.axes[0].values[0].value), (folder.path / "a.xyz").string());
}

TEST(SweepFile, IntegersThatNoDoubleHoldsAreOutOfRangeToo) {
  EXPECT_NE(refusal("[0.2, 0.9]", "[0.2, 9007199254740993]").find("(must be in [0, 1]"),
            std::string::npos);
}

TEST(SweepFile, ProblemsOfValuesStandWhereTheValuesStand) {
  EXPECT_EQ(refusal("[0.2, 0.9]", "[0.2, 1.5]"),
            "s.toml:5:30: system.restitution = 1.5 (must be in [0, 1]; 1 is elastic)");
  EXPECT_EQ(refusal("[0.2, 0.9]", "[0.2, \"high\"]"),
            "s.toml:5:30: system.restitution = \"high\" (found text, needs a real number)");
}

TEST(SweepFile, SeedsThatAreWrongAreNotMissing) {
  const std::string told = refusal("seeds = 2", "seeds = -2");
  EXPECT_NE(told.find("sweep.seeds = -2 (must be in"), std::string::npos);
  EXPECT_EQ(told.find("missing"), std::string::npos);
}

TEST(SweepFile, TellsAllProblemsAtOnceInTheOrderOfTheFile) {
  EXPECT_EQ(
      refusal("[sweep]\nseed = 1\n[axis]\nx = 1\n[stop]\nwall_seconds = -1\n"),
      "s.toml:2:1: unknown key sweep.seed; did you mean seeds?\n"
      "s.toml:3:2: unknown table axis; did you mean [axes]?\n"
      "s.toml:6:16: stop.wall_seconds = -1 (must be in (0, 1000000000000000])\n"
      "s.toml: missing the base case; add case = \"FILE.toml\" under [sweep]\n"
      "s.toml: missing key sweep.seeds (runs at each point of the grid); add seeds = 10 under "
      "[sweep]");
}

TEST(SweepFile, KnowsWhichKeyAnAxisMeant) {
  EXPECT_EQ(refusal("\"system.restitution\"", "\"system.restituton\""),
            "s.toml:5:1: unknown key axes.\"system.restituton\" (an axis is over a key of the "
            "case); did you mean \"system.restitution\"?");
}

TEST(SweepFile, RefusesAnAxisOverTheSeed) {
  EXPECT_EQ(refusal("\"system.restitution\"", "\"start.seed\""),
            "s.toml:5:1: axes.\"start.seed\" (the seed of each run follows from sweep.master_seed "
            "and its number); remove it and raise sweep.seeds");
}

TEST(SweepFile, RefusesAValueTwice) {
  EXPECT_EQ(refusal("[0.2, 0.9]", "[1, 0.2, 1.0]"),
            "s.toml:5:25: axes.\"system.restitution\" has 1.0 twice; remove one");
}

TEST(SweepFile, RefusesRangesThatAreNone) {
  EXPECT_EQ(refusal("[0.2, 0.9]", "{ from = 0, to = 1, points = 3, spacing = \"log\" }"),
            "s.toml:5:24: axes.\"system.restitution\" = {...} (a log range needs from and to above "
            "0)");
  EXPECT_EQ(refusal("[0.2, 0.9]", "{ from = 0, points = 3 }"),
            "s.toml:5:24: axes.\"system.restitution\" = {...} (a range needs from, to and points)");
}

TEST(SweepFile, RefusesMoreRunsThanAStoreHolds) {
  EXPECT_EQ(refusal("seeds = 2", "seeds = 9999999"),
            "s.toml: 4e+07 runs (at most 10000000); give fewer values or seeds");
}

TEST(SweepFile, FindsPointsOfTheGridThatAreNoCase) {
  const std::string told =
      refusal("\"system.solids_volume_fraction\" = [0.2, 0.3]", "\"system.spheres\" = [32, 33]");
  EXPECT_EQ(told.substr(0, 33), "s.toml:6:25: system.spheres = 33 ");
}

TEST(SweepFile, SaysHowHitsAreAdjudicated) {
  EXPECT_FALSE(parse_sweep(small_sweep, "s.toml").adjudicate);
  const auto plain = parse_sweep(small_sweep + "[adjudicate]\n", "s.toml").adjudicate;
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->seconds, 120);
  EXPECT_FALSE(plain->groups || plain->up_to || plain->collisions);
  const auto full = parse_sweep(small_sweep +
                                    "[adjudicate]\ngroups = 3\nseconds = 0.5\n"
                                    "up_to = \"digits250\"\ncollisions = 9\n",
                                "s.toml")
                        .adjudicate;
  EXPECT_EQ(full->groups, 3);
  EXPECT_EQ(full->seconds, 0.5);
  EXPECT_EQ(full->up_to, Precision::digits(250));
  EXPECT_EQ(full->collisions, 9);
}

TEST(SweepFile, RefusesAnAdjudicationThatMakesNoSense) {
  const auto told = [](const std::string& line) {
    return refusal("[axes]", "[adjudicate]\n" + line + "\n[axes]");
  };
  EXPECT_EQ(told("groups = 0").substr(0, 32), "s.toml:5:10: adjudicate.groups =");
  EXPECT_EQ(told("seconds = 0").substr(0, 33), "s.toml:5:11: adjudicate.seconds =");
  EXPECT_EQ(told("up_to = \"triple\""),
            "s.toml:5:9: adjudicate.up_to = \"triple\" (must be \"double\", \"extended\", \"quad\" "
            "or \"digitsN\" with N from 20 to 10000)");
  EXPECT_EQ(told("group = 3"), "s.toml:5:1: unknown key adjudicate.group; did you mean groups?");
  EXPECT_EQ(refusal(replaced(small_sweep, "[axes]", "[adjudicate]\nup_to = \"quad\"\n[axes]") +
                    "[case.collision]\nprecision = \"digits100\"\n"),
            "s.toml:5:9: adjudicate.up_to = \"quad\" (runs are in digits100 already, and digits "
            "cannot be taken away); choose a higher one");
}

TEST(SweepFile, SearchesWithoutAdjudicating) {
  const std::string boundary =
      "[boundary]\naxis = \"drive.shear_rate\"\ncriterion = \"arrest\"\nfrom = 1\nto = 2\n"
      "resolution = 0.1\n[adjudicate]\n[axes]";
  const std::string text = replaced(replaced(small_sweep, "seeds = 2\n", ""), "[axes]", boundary);
  EXPECT_EQ(refusal(text),
            "s.toml:3:2: boundary (a search asks for the criteria only, not for findings); remove "
            "[adjudicate], or give a grid under [axes]");
}

}  // namespace
}  // namespace zenosphere
