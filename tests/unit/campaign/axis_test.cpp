#include "campaign/axis.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace zenosphere {
namespace {

std::vector<std::string> texts(const AxisRange& range, Storage storage) {
  std::vector<std::string> texts;
  for (const auto& value : numbers_of(range, storage)) texts.push_back(column_text(value));
  return texts;
}

Storage storage_of(std::string_view path) { return AxisKey::named(path).value().storage(); }

// In doubles 0.1 + 0.4 * 2 / 4 and 0.1 + 0.4 * 3 / 4 end in ...04: no user means that.
TEST(AxisRange, LinearHasBothEndsAndNumbersAsPeopleWriteThem) {
  EXPECT_EQ(texts({0.1, 0.5, 5}, Storage::real),
            (std::vector<std::string>{"0.1", "0.2", "0.3", "0.4", "0.5"}));
}

TEST(AxisRange, LogarithmicHasEqualRatios) {
  EXPECT_EQ(texts({1, 1000, 4, AxisRange::Spacing::log}, Storage::real),
            (std::vector<std::string>{"1.0", "10.0", "100.0", "1000.0"}));
}

TEST(AxisRange, MayGoDown) {
  EXPECT_EQ(texts({1, 0, 3}, Storage::real), (std::vector<std::string>{"1.0", "0.5", "0.0"}));
}

// 100 * 10^(1/3) = 215.44..., 100 * 10^(2/3) = 464.15...
TEST(AxisRange, OfACountIsRounded) {
  EXPECT_EQ(texts({100, 1000, 4, AxisRange::Spacing::log}, Storage::integer),
            (std::vector<std::string>{"100", "215", "464", "1000"}));
}

TEST(Storage, FollowsTheTypeOfTheKey) {
  EXPECT_EQ(storage_of("system.restitution"), Storage::real);
  EXPECT_EQ(storage_of("start.granular_temperature"), Storage::real);
  EXPECT_EQ(storage_of("system.spheres"), Storage::integer);
  EXPECT_EQ(storage_of("run.collisions"), Storage::integer);
  EXPECT_EQ(storage_of("collision.overlap"), Storage::text);
  EXPECT_EQ(storage_of("collapse.stop_when_collapsed"), Storage::text);
  EXPECT_EQ(storage_of("system.sides"), Storage::text);
}

TEST(Storage, TurnsIntegersIntoRealNumbersAndWholeNumbersIntoCounts) {
  EXPECT_EQ(column_text(in_storage(std::int64_t{1}, Storage::real)), "1.0");
  EXPECT_EQ(column_text(in_storage(1e3, Storage::integer)), "1000");
  EXPECT_EQ(column_text(in_storage(0.5, Storage::integer)), "0.5");  // left for the case reader
}

TEST(Override, QuotesNamesOfFilesWhateverTheyLookLike) {
  EXPECT_EQ(AxisKey::named("start.file")->override_of("5"), "start.file=\"5\"");
  EXPECT_EQ(AxisKey::named("collision.overlap")->override_of("stop"), "collision.overlap=stop");
}

TEST(AxisKey, IsOfATableOrOfASpeciesOrOfAContact) {
  EXPECT_EQ(storage_of("species.heavy.mass"), Storage::real);
  EXPECT_EQ(storage_of("species.heavy.spheres"), Storage::integer);
  EXPECT_EQ(storage_of("species.heavy.immobile"), Storage::text);
  EXPECT_EQ(storage_of("contact.a.b.restitution"), Storage::real);
  EXPECT_EQ(AxisKey::named("species.heavy.mass")->override_of("3.0"), "species.heavy.mass=3.0");
}

TEST(AxisKey, HasNoOtherPath) {
  for (const std::string path : {"species", "species.mass", "species.heavy", "species.heavy.name",
                                 "species.a.b.mass", "species..mass", "species.a\"b.mass",
                                 "contact.a.restitution", "contact.a.b.between", "system"}) {
    EXPECT_FALSE(AxisKey::named(path)) << path;
  }
}

TEST(AxisKey, KnowsTheNearestPath) {
  EXPECT_EQ(AxisKey::nearest_path("species.heavy.mas"), "species.heavy.mass");
  EXPECT_EQ(AxisKey::nearest_path("contact.a.b.restitutio"), "contact.a.b.restitution");
  EXPECT_EQ(AxisKey::nearest_path("species.mas"), std::nullopt);
  EXPECT_EQ(AxisKey::nearest_path("system.restitutio"), "system.restitution");
}

}  // namespace
}  // namespace zenosphere
