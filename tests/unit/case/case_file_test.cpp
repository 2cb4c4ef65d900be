#include "case/case_file.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "model/errors.hpp"
#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

/// A folder of its own for each test, gone afterwards.
class CaseFileOnDisk : public testing::Test {
 protected:
  CaseFileOnDisk() {
    std::string name = (std::filesystem::temp_directory_path() / "zenosphere-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~CaseFileOnDisk() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path written(const std::string& content) const {
    const std::filesystem::path file = folder_ / "case.toml";
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }
  static std::string problems_of_file(const std::filesystem::path& file) {
    try {
      read_case(file, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
};

TEST(CaseFile, EveryKeyReachesItsMember) {
  const Case values = parse_case(R"(
[system]
dimension = 3
spheres = 500
restitution = 0.9
solids_volume_fraction = 0.4
[start]
arrangement = "random"
granular_temperature = 2.5
seed = 7
[drive]
kind = "shear"
shear_rate = 0.5
[collision]
overlap = "guarded"
guard = 1e-14
precision = "double"
[collapse]
gap_threshold = 1e-12
window = 50
stop_when_collapsed = false
[run]
collisions = 1000
time = 3.5
[measure]
after_time = 1.5
[output]
snapshot_interval = 0.25
collision_log = "window"
log_first = 10
log_last = 20
)",
                                 "case.toml", {});
  EXPECT_EQ(values.system.dimension, 3);
  EXPECT_EQ(values.system.spheres, 500);
  EXPECT_EQ(values.system.restitution, 0.9);
  EXPECT_EQ(values.system.solids_volume_fraction, 0.4);
  EXPECT_EQ(values.start.arrangement, Arrangement::random);
  EXPECT_EQ(values.start.granular_temperature, 2.5);
  EXPECT_EQ(values.start.seed, 7U);
  EXPECT_EQ(values.drive.kind, DriveKind::shear);
  EXPECT_EQ(values.drive.shear_rate, 0.5);
  EXPECT_EQ(values.collision.overlap, OverlapRule::guarded);
  EXPECT_EQ(values.collision.guard, 1e-14);
  EXPECT_EQ(values.collapse.gap_threshold, 1e-12);
  EXPECT_EQ(values.collapse.window, 50);
  EXPECT_FALSE(values.collapse.stop_when_collapsed);
  EXPECT_EQ(values.run.collisions, 1000);
  EXPECT_EQ(values.run.time, 3.5);
  EXPECT_EQ(values.measure.after_time, 1.5);
  EXPECT_EQ(values.output.snapshot_interval, 0.25);
  EXPECT_EQ(values.output.collision_log, CollisionLog::window);
  EXPECT_EQ(values.output.log_first, 10);
  EXPECT_EQ(values.output.log_last, 20);
}

TEST(CaseFile, WhatIsNotPhysicsHasADefault) {
  const Case values = parse_case(cooling_case, "case.toml", {});
  EXPECT_EQ(values.start.seed, 1U);
  EXPECT_EQ(values.collision.overlap, OverlapRule::rewind);
  EXPECT_EQ(values.collision.guard, 1e-15);
  EXPECT_EQ(values.collision.precision, Precision::double_precision);
  EXPECT_EQ(values.collapse.gap_threshold, 1e-16);
  EXPECT_EQ(values.collapse.window, 10000);
  EXPECT_TRUE(values.collapse.stop_when_collapsed);
  EXPECT_FALSE(values.run.time.has_value());
  EXPECT_EQ(values.measure.after_time, 0);
  EXPECT_FALSE(values.output.snapshot_interval.has_value());
  EXPECT_EQ(values.output.collision_log, CollisionLog::all);
  EXPECT_FALSE(values.output.log_last.has_value());
}

TEST(CaseFile, IntegerStandsForRealNumber) {
  EXPECT_EQ(overridden(cooling_case, {"system.restitution=1"}).system.restitution, 1.0);
}

TEST(CaseFile, RealNumberWithoutFractionStandsForInteger) {
  EXPECT_EQ(overridden(cooling_case, {"run.collisions=2e6"}).run.collisions, 2'000'000);
  EXPECT_EQ(overridden(cooling_case, {"start.seed=1e18"}).start.seed, 1'000'000'000'000'000'000U);
}

TEST(CaseFile, ThresholdFollowsThePrecisionUnlessItIsGiven) {
  const auto threshold = [](const std::vector<std::string>& overrides) {
    return overridden(cooling_case, overrides).collapse.gap_threshold;
  };
  EXPECT_EQ(threshold({}), 1e-16);
  EXPECT_EQ(threshold({"collision.precision=extended"}), 1e-16 / 2048);  // 11 bits more
  EXPECT_EQ(threshold({"collision.precision=quad"}), 1e-16 * 0x1p-60);
  EXPECT_EQ(threshold({"collision.precision=digits100"}), 1e-16 * 0x1p-281);
  EXPECT_EQ(threshold({"collision.precision=quad", "collapse.gap_threshold=1e-16"}), 1e-16);
}

TEST(CaseFile, ThresholdBelowTheRangeOfDoubleStandsInQuotesAndComesBack) {
  const Case values = overridden(cooling_case, {"collision.precision=digits1000"});
  const std::string resolved = resolved_toml(values);
  EXPECT_NE(resolved.find("\ngap_threshold = \"2.1423192150451"), std::string::npos);
  EXPECT_EQ(parse_case(resolved, "again", {}).collapse.gap_threshold,
            values.collapse.gap_threshold);
  const Case given = overridden(cooling_case, {"collapse.gap_threshold=\"1e-1000\""});
  EXPECT_NEAR(given.collapse.gap_threshold.log10(), -1000, 1e-10);
}

TEST(CaseFile, TextIsKeptByteForByte) {
  const std::string text = "# caf\u00e9\r\n" + std::string(cooling_case) + "\n\n";
  EXPECT_EQ(overridden(text, {"system.restitution=0.5"}).text, text);
}

TEST(CaseFile, OverrideReplacesAddsAndTheLastOneWins) {
  const Case values = overridden(
      cooling_case, {"system.restitution=0.5", "measure.after_time=2", "output.collision_log=none",
                     "run.time = 7", "system.restitution=0.25"});
  EXPECT_EQ(values.system.restitution, 0.25);
  EXPECT_EQ(values.measure.after_time, 2);
  EXPECT_EQ(values.output.collision_log, CollisionLog::none);
  EXPECT_EQ(values.run.time, 7);
}

TEST(CaseFile, OverrideOfAWordNeedsNoQuotesButMayHaveThem) {
  EXPECT_EQ(overridden(cooling_case, {"collision.overlap=stop"}).collision.overlap,
            OverlapRule::stop);
  EXPECT_EQ(overridden(cooling_case, {"collision.overlap=\"stop\""}).collision.overlap,
            OverlapRule::stop);
}

TEST(CaseFile, OverrideReplacesAWrongValueOfTheFile) {
  const std::string text = replaced(cooling_case, "restitution = 0.9", "restitution = 9");
  EXPECT_EQ(overridden(text, {"system.restitution=0.5"}).system.restitution, 0.5);
}

TEST(ResolvedCase, ReadsBackAsTheSameCase) {
  const std::vector<std::string> overrides{"system.restitution=0.1",
                                           "start.granular_temperature=0.30000000000000004",
                                           "start.seed=9223372036854775807",
                                           "collision.guard=5e-324",
                                           "run.time=1e300",
                                           "collision.overlap=immediate",
                                           "collapse.stop_when_collapsed=false"};
  for (const std::string& text : {std::string(cooling_case), std::string(shear_case)}) {
    const std::string resolved = resolved_toml(overridden(text, overrides));
    const Case again = parse_case(resolved, "resolved", {});
    EXPECT_EQ(resolved_toml(again), resolved);
    EXPECT_EQ(again.system.restitution, 0.1);
    EXPECT_EQ(again.start.granular_temperature, 0.30000000000000004);
    EXPECT_EQ(again.start.seed, 9223372036854775807U);
    EXPECT_EQ(again.collision.guard, 5e-324);
    EXPECT_EQ(again.run.time, 1e300);
    EXPECT_EQ(again.collision.overlap, OverlapRule::immediate);
    EXPECT_FALSE(again.collapse.stop_when_collapsed);
  }
}

TEST(ResolvedCase, TellsDefaultsAndLeavesOutWhatHasNoValue) {
  const std::string resolved = resolved_toml(parse_case(cooling_case, "case.toml", {}));
  EXPECT_NE(resolved.find("\nseed = 1  #"), std::string::npos);
  EXPECT_NE(resolved.find("\ngap_threshold = 1e-16  #"), std::string::npos);
  EXPECT_NE(resolved.find("\nafter_time = 0.0  #"), std::string::npos);
  EXPECT_EQ(resolved.find("\nshear_rate"), std::string::npos);
  EXPECT_EQ(resolved.find("\nlog_first"), std::string::npos);
  EXPECT_EQ(resolved.find("\ntime ="), std::string::npos);
}

TEST_F(CaseFileOnDisk, IsReadWithItsPathInTheMessages) {
  const auto file = written(cooling_case);
  EXPECT_EQ(read_case(file, {}).text, cooling_case);
  const auto wrong = written(replaced(cooling_case, "restitution = 0.9", "restitution = 9"));
  EXPECT_EQ(problems_of_file(wrong), wrong.string() +
                                         ":5:15: system.restitution = 9 (must be in [0, 1]; "
                                         "1 is elastic)");
}

TEST(CaseFile, OverrideMakesKeysOfTheFileIdle) {
  const std::string sheared = replaced(cooling_case, "\"none\"", "\"shear\"\nshear_rate = 1");
  const std::vector<std::string> overrides{"drive.kind=none"};
  EXPECT_EQ(parse_case(sheared, "e.toml", overrides).drive.kind, DriveKind::none);
}

TEST(CaseFile, KeyWithoutMeaningMayHaveItsDefault) {
  const std::string at_zero = replaced(cooling_case, "\"none\"", "\"none\"\nshear_rate = 0");
  EXPECT_EQ(parse_case(at_zero, "e.toml", {}).drive.kind, DriveKind::none);
}

TEST_F(CaseFileOnDisk, ThatIsMissingOrADirectoryIsAnInputError) {
  EXPECT_EQ(problems_of_file(folder_ / "none.toml"),
            (folder_ / "none.toml").string() +
                ": cannot be opened (No such file or directory); check the name and its "
                "permissions");
  EXPECT_EQ(problems_of_file(folder_), folder_.string() +
                                           ": is a directory (a case is a TOML file); name the "
                                           "file in it");
}

TEST_F(CaseFileOnDisk, MayHaveSixteenMebibytesAndNotAByteMore) {
  const std::string largest =
      cooling_case + std::string(16 * 1024 * 1024 - cooling_case.size(), '\n');
  EXPECT_EQ(problems_of_file(written(largest)), "");
  EXPECT_NE(problems_of_file(written(largest + "\n")).find("is larger than 16 MiB"),
            std::string::npos);
}

TEST_F(CaseFileOnDisk, ThatIsNotUtf8IsAnInputError) {
  EXPECT_NE(problems_of_file(written("# \xE9\n" + std::string(cooling_case)))
                .find("not valid TOML (encountered invalid utf-8 sequence)"),
            std::string::npos);
}

}  // namespace
}  // namespace zenosphere
