#include <gtest/gtest.h>

#include <string>

#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

std::string missing(const std::string& table, const std::string& name) {
  return "missing key " + table + "." + name + " (physics has no default); add " + name +
         " = ... under [" + table + "]";
}

TEST(CaseErrors, AllProblemsOfAFileAreReportedInLineOrder) {
  EXPECT_EQ(problems_of(R"([run]
colisions = 100
[system]
spheres = 4001
restitution = 1.2
dimension = 4
solids_volume_fraction = 0.3
[start]
arrangement = "fcc"
[drive]
kind = "none"
shear_rate = 1
)",
                        {"collapse.window=1", "measure.after_time=-1"}),
            R"(e.toml:2:1: unknown key run.colisions; did you mean collisions?
e.toml:4:11: system.spheres = 4001 (fcc fills 4 n^3 places); use 4000 or 5324
e.toml:5:15: system.restitution = 1.2 (must be in [0, 1]; 1 is elastic)
e.toml:6:13: system.dimension = 4 (must be in [1, 3])
e.toml:12:14: drive.shear_rate = 1 (only for drive.kind = "shear"); remove it
--set collapse.window=1: collapse.window = 1 (must be in [2, 100000000])
--set measure.after_time=-1: measure.after_time = -1 (must be >= 0)
e.toml: )" + missing("start", "granular_temperature"));
}

TEST(CaseErrors, AnEmptyFileMissesAllPhysics) {
  EXPECT_EQ(
      problems_of(""),
      "e.toml: " + missing("system", "dimension") + "\ne.toml: " + missing("system", "spheres") +
          "\ne.toml: " + missing("system", "restitution") +
          "\ne.toml: missing key system.solids_volume_fraction or system.sides (the box needs "
          "a size); add one under [system]\ne.toml: " +
          missing("start", "arrangement") + "\ne.toml: " +
          missing("start", "granular_temperature") + "\ne.toml: " + missing("drive", "kind") +
          "\ne.toml: missing key run.collisions or run.time (a run needs an end); add one "
          "under [run]");
}

TEST(CaseErrors, ShearNeedsAShearRate) {
  EXPECT_EQ(problems_of(replaced(shear_case, "shear_rate = 1\n", "")),
            "e.toml: " + missing("drive", "shear_rate"));
}

TEST(CaseErrors, ShearRateIsNotJudgedWhileTheKindOfDriveIsUnknown) {
  EXPECT_EQ(problems_of(replaced(shear_case, "\"shear\"", "\"sheer\"")),
            "e.toml:11:8: drive.kind = \"sheer\" (must be \"none\", \"shear\" or \"random\"); "
            "did you mean \"shear\"?");
}

TEST(CaseErrors, UnknownKeySuggestsTheNearestOfItsTableOrTheTableThatHasIt) {
  EXPECT_EQ(objection(cooling_case, "system.sphere=5"),
            "unknown key system.sphere; did you mean system.spheres?");
  EXPECT_EQ(objection(cooling_case, "run.window=5"),
            "unknown key run.window; did you mean collapse.window?");
  EXPECT_EQ(objection(cooling_case, "restitution=0.5"),
            "unknown key restitution; did you mean system.restitution?");
  EXPECT_EQ(objection(cooling_case, "sytem.restitution=0.5"),
            "unknown key sytem.restitution; did you mean system.restitution?");
}

TEST(CaseErrors, UnknownKeyThatIsNearNothingHasNoSuggestion) {
  EXPECT_EQ(objection(cooling_case, "system.weather=9.81"), "unknown key system.weather");
  EXPECT_EQ(objection(cooling_case, "system.spheres.a.lot=1"),
            "unknown key system.\"spheres.a.lot\"");
}

TEST(CaseErrors, KeyOfAnotherProgramIsAnsweredWithTheOneThatIsMeant) {
  EXPECT_EQ(objection(cooling_case, "system.gravity=9.81"),
            "unknown key system.gravity; did you mean gravity.acceleration?");
}

TEST(CaseErrors, QuotedKeyWithADotIsNotADottedKey) {
  EXPECT_EQ(problems_of("\"run.time\" = 5\n" + cooling_case),
            "e.toml:1:1: unknown key \"run.time\"");
}

TEST(CaseErrors, MisspelledRequiredKeyIsNotReportedAsMissingToo) {
  EXPECT_EQ(problems_of(replaced(cooling_case, "restitution", "restituton")),
            "e.toml:5:1: unknown key system.restituton; did you mean restitution?");
  EXPECT_EQ(problems_of(replaced(cooling_case, "collisions = 100", "colisions = 100")),
            "e.toml:13:1: unknown key run.colisions; did you mean collisions?");
}

TEST(CaseErrors, UnknownTableIsReportedOnceAndItsKeysNotAtAll) {
  EXPECT_EQ(problems_of(replaced(cooling_case, "[system]", "[sytem]")),
            "e.toml:2:2: unknown table [sytem]; did you mean [system]?");
  EXPECT_EQ(problems_of(cooling_case + "[weather]\nwind = 3\n"),
            "e.toml:14:2: unknown table [weather]");
}

TEST(CaseErrors, TableThatIsAValueAndValueThatIsATableAreReported) {
  EXPECT_EQ(problems_of(cooling_case + "[[measure]]\n"),
            "e.toml:14:1: measure = [...] (is a table, not a key); give its keys under [measure]");
  EXPECT_EQ(problems_of(replaced(cooling_case, "spheres = 4000", "spheres = {n = 10}")),
            "e.toml:4:11: system.spheres = {...} (found a table, needs an integer)");
}

TEST(CaseErrors, WrongTypeTellsWhatWasFoundAndWhatIsNeeded) {
  EXPECT_EQ(objection(cooling_case, "system.restitution=O.5"),
            "system.restitution = \"O.5\" (found text, needs a real number)");
  EXPECT_EQ(objection(cooling_case, "system.spheres=[1, 2]"),
            "system.spheres = [1, 2] (found an array, needs an integer)");
  EXPECT_EQ(objection(cooling_case, "system.spheres=true"),
            "system.spheres = true (found true or false, needs an integer)");
  EXPECT_EQ(objection(cooling_case, "run.time=2020-01-01"),
            "run.time = ... (found a date or time, needs a real number)");
  EXPECT_EQ(objection(cooling_case, "start.arrangement=1"),
            "start.arrangement = 1 (found an integer, needs one of the words \"fcc\", "
            "\"random\", \"given\" or \"file\")");
  EXPECT_EQ(objection(cooling_case, "collapse.stop_when_collapsed=1"),
            "collapse.stop_when_collapsed = 1 (found an integer, needs true or false)");
  EXPECT_EQ(objection(cooling_case, "run.collisions=2.5"),
            "run.collisions = 2.5 (found a number with a fraction, needs an integer)");
}

TEST(CaseErrors, NumbersThatAreNotFiniteAreRejectedEverywhere) {
  for (const char* key : {"system.restitution", "system.spheres", "start.granular_temperature",
                          "start.seed", "run.time", "run.collisions", "collision.guard"}) {
    for (const char* number : {"nan", "inf", "-inf"}) {
      const std::string assignment = std::string(key) + "=" + number;
      EXPECT_EQ(objection(cooling_case, assignment),
                std::string(key) + " = " + number + " (must be a finite number)");
    }
  }
}

TEST(CaseErrors, RangesIncludeTheirEndsWhereTheySaySo) {
  for (const char* right :
       {"system.restitution=0", "system.restitution=1", "system.solids_volume_fraction=0.74048",
        "run.collisions=0", "run.collisions=1e15", "run.time=0", "collision.guard=0",
        "collapse.window=2", "collapse.window=100000000", "start.seed=0", "measure.after_time=0"}) {
    EXPECT_EQ(objection(cooling_case, right), "");
  }
  EXPECT_EQ(objection(cooling_case, "system.restitution=1.0000000000000002"),
            "system.restitution = 1.0000000000000002 (must be in [0, 1]; 1 is elastic)");
  EXPECT_EQ(objection(cooling_case, "system.solids_volume_fraction=0"),
            "system.solids_volume_fraction = 0 (must be in (0, 1])");
  EXPECT_EQ(objection(cooling_case, "system.solids_volume_fraction=0.74049"),
            "system.solids_volume_fraction = 0.74049 (must be in (0, 0.74048]; spheres cannot be "
            "packed denser)");
  EXPECT_EQ(objection(cooling_case, "system.spheres=0"),
            "system.spheres = 0 (must be in [1, 16777215])");
  EXPECT_EQ(objection(cooling_case, "collapse.gap_threshold=0"),
            "collapse.gap_threshold = 0 (must be > 0)");
  EXPECT_EQ(objection(cooling_case, "output.snapshot_interval=0.0"),
            "output.snapshot_interval = 0.0 (must be > 0)");
  EXPECT_EQ(objection(cooling_case, "run.collisions=2e15"),
            "run.collisions = 2000000000000000.0 (must be in [0, 1000000000000000])");
  EXPECT_EQ(objection(cooling_case, "start.seed=-1"), "start.seed = -1 (must be >= 0)");
  EXPECT_EQ(objection(cooling_case, "start.seed=1e19"),
            "start.seed = 1e+19 (must fit in 64 bits: at most 9223372036854775807)");
}

TEST(CaseErrors, FccNamesTheNearestFullLattices) {
  // 4 n^3: n = 2: 32, 3: 108, 10: 4000, 11: 5324, 161: 16693124; n = 162 has more than 2^24.
  const auto sphere_objection = [](const std::string& spheres) {
    return objection(cooling_case, "system.spheres=" + spheres);
  };
  const std::string fcc = " (fcc fills 4 n^3 places); use ";
  EXPECT_EQ(sphere_objection("3999"), "system.spheres = 3999" + fcc + "2916 or 4000");
  EXPECT_EQ(sphere_objection("4001"), "system.spheres = 4001" + fcc + "4000 or 5324");
  EXPECT_EQ(sphere_objection("100"), "system.spheres = 100" + fcc + "32 or 108");
  EXPECT_EQ(sphere_objection("16777215"), "system.spheres = 16777215" + fcc + "16693124");
  EXPECT_EQ(sphere_objection("16693124"), "");
}

TEST(CaseErrors, FccIsJudgedEvenIfTheDensityIsWrong) {
  EXPECT_EQ(problems_of(replaced(cooling_case, "spheres = 4000", "spheres = 5"),
                        {"system.solids_volume_fraction=0.8"}),
            "e.toml:4:11: system.spheres = 5 (fcc fills 4 n^3 places); use 4 or 32\n"
            "--set system.solids_volume_fraction=0.8: system.solids_volume_fraction = 0.8 (must be "
            "in (0, 0.74048]; spheres cannot be packed denser)");
}

TEST(CaseErrors, FccSuggestsNoLatticeWhoseBoxIsTooNarrow) {
  // At phi = 0.3 four spheres fill a box of side (4 pi / 1.8)^(1/3) = 1.911, 32 one of 3.82.
  EXPECT_EQ(objection(cooling_case, "system.spheres=5"),
            "system.spheres = 5 (fcc fills 4 n^3 places); use 32");
  EXPECT_EQ(objection(cooling_case, "system.spheres=4"),
            "system.spheres = 4 (the box side would be 1.91123 diameters, must be above 2.02); "
            "use at least 32");
}

TEST(CaseErrors, BoxMustBeWiderThanTwoDiameters) {
  // phi = 0.3: N > 8 (6/pi) 0.3 = 4.58, so five spheres fit; (2 pi/1.8)^(1/3) = 1.51694.
  const std::string random = replaced(cooling_case, "\"fcc\"", "\"random\"");
  EXPECT_EQ(objection(random, "system.spheres=2"),
            "system.spheres = 2 (the box side would be 1.51694 diameters, must be above 2.02); "
            "use at least 5");
  EXPECT_EQ(objection(random, "system.spheres=5"), "");
}

TEST(CaseErrors, RandomArrangementFillsNoMoreThanGrowthReaches) {
  const std::string random = replaced(cooling_case, "\"fcc\"", "\"random\"");
  EXPECT_EQ(objection(random, "system.solids_volume_fraction=0.64"), "");
  EXPECT_EQ(objection(random, "system.solids_volume_fraction=0.65"),
            "system.solids_volume_fraction = 0.65 (must be in (0, 0.64] for start.arrangement = "
            "\"random\")");
}

TEST(CaseErrors, ASystemInWhichNothingCanMoveIsRejected) {
  const std::string nothing =
      "start.granular_temperature = 0 (nothing would ever move); use a value above 0, or drive the "
      "spheres";
  EXPECT_EQ(objection(cooling_case, "start.granular_temperature=0"), nothing);
  EXPECT_EQ(objection(shear_case, "start.granular_temperature=0"), "");
  EXPECT_EQ(objection(replaced(shear_case, "shear_rate = 1", "shear_rate = 0"),
                      "start.granular_temperature=0"),
            nothing);
}

TEST(CaseErrors, LogLimitsBelongToAWindowedLogAndStandInOrder) {
  EXPECT_EQ(objection(cooling_case, "output.log_first=5"),
            "output.log_first = 5 (only for output.collision_log = \"window\"); remove it");
  const std::string windowed =
      cooling_case + "[output]\ncollision_log = \"window\"\nlog_first = 10\n";
  EXPECT_EQ(objection(windowed, "output.log_last=10"), "");
  EXPECT_EQ(objection(windowed, "output.log_last=9"),
            "output.log_last = 9 (must be >= output.log_first = 10)");
}

TEST(CaseErrors, AnOverrideNeedsAKeyAndAnEqualsSign) {
  for (const std::string text : {"system.restitution", "=0.5", ""}) {
    EXPECT_EQ(objection(cooling_case, text),
              "not an override (needs KEY=VALUE); write system.restitution=0.2");
  }
}

TEST(CaseErrors, AnOverrideCannotSmuggleInASecondLine) {
  EXPECT_EQ(problems_of(cooling_case, {"run.time=1\ncollisions=5"}),
            "--set \"run.time=1\\u000Acollisions=5\": run.time = \"1\\u000Acollisions=5\" "
            "(found text, needs a real number)");
}

TEST(CaseErrors, SyntaxErrorHasLineAndColumn) {
  EXPECT_EQ(problems_of("[system]\nspheres = \n"),
            "e.toml:2:11: not valid TOML (error while parsing key-value pair: expected value, saw "
            "'\\n')");
  EXPECT_EQ(problems_of("[run]\ntime = 1\ntime = 2\n"),
            "e.toml:3:8: not valid TOML (error while parsing key-value pair: cannot redefine "
            "existing integer 'time')");
}

TEST(CaseErrors, LineOfMoreThanTenThousandBytesIsRejected) {
  EXPECT_EQ(problems_of(cooling_case + "#" + std::string(9'999, 'x')), "");
  EXPECT_EQ(problems_of(cooling_case + "#" + std::string(10'000, 'x')),
            "e.toml:14:1: line of more than 10000 bytes; break it");
}

TEST(CaseErrors, LongValuesAreCutInTheMessage) {
  std::string cut = "e.toml:11:8: drive.kind = \"";
  cut += std::string(60, 'x');
  cut += "...\" (must be \"none\", \"shear\" or \"random\")";
  EXPECT_EQ(problems_of(replaced(cooling_case, "\"none\"", '"' + std::string(5000, 'x') + '"')),
            cut);
}

}  // namespace
}  // namespace zenosphere
