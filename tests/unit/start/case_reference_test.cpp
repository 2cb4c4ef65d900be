#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "case/case_table.hpp"
#include "start/derived.hpp"
#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

std::string reference() {
  std::ifstream stream(ZENOSPHERE_SOURCE_DIR "/docs/case-file.md");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What stands between `begin` and the next `end`, or nothing.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return "";
  const std::size_t from = at + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

/// The n-th TOML text of the page, from 0.
std::string example(int n) {
  std::string page = reference();
  for (; n > 0; --n) page = page.substr(page.find("```toml\n") + 8);
  return between(page, "```toml\n", "```");
}

TEST(CaseReference, FirstExampleIsARightCase) {
  const Case values = parse_case(example(0), "docs/case-file.md", {});
  EXPECT_EQ(values.system.spheres, 4000);
  EXPECT_EQ(values.run.collisions, 2'000'000);
  EXPECT_NO_THROW(derived_text(values));
}

TEST(CaseReference, SecondExampleIsABouncingBallThatHitsTheFloorAtUnitSpeed) {
  const Case values = parse_case(example(1), "docs/case-file.md", {});
  EXPECT_NO_THROW(derived_text(values));
  EXPECT_EQ(values.system.dimension, 1);
  EXPECT_EQ(values.system.spheres, 1);
  EXPECT_EQ(values.walls.axis, Axis::x);
  const double height = values.start.positions[0][0] - 0.5;
  EXPECT_EQ(-2 * values.gravity.acceleration[0] * height, 1);  // v^2 = 2 G h
}

TEST(CaseReference, ThirdExampleIsAMixtureOfTwoKinds) {
  const Case values = parse_case(example(2), "docs/case-file.md", {});
  EXPECT_NO_THROW(derived_text(values));
  ASSERT_EQ(values.species.size(), 2u);
  EXPECT_EQ(values.species[1].diameter, 1.4);
  EXPECT_EQ(values.contacts.size(), 1u);
  EXPECT_EQ(values.polydispersity.spread, 0.05);
  EXPECT_EQ(values.collision.friction->coefficient, 0.3);
}

TEST(CaseReference, ExamplesShowEveryTable) {
  const std::string examples = example(0) + example(1) + example(2);
  for (const auto& key : case_format::keys()) {
    EXPECT_NE(examples.find(fmt::format("[{}]\n", key.table)), std::string::npos) << key.table;
  }
}

TEST(CaseReference, EveryKeyHasARowWithItsRange) {
  const std::string page = reference() + "\n## ";
  for (const auto& key : case_format::keys()) {
    const std::string section = between(page, fmt::format("## [{}]\n", key.table), "\n## ");
    const std::string row = between(section, fmt::format("| `{}` |", key.name), "\n");
    EXPECT_NE(row, "") << key.path() << " is not in the reference";
    std::string range = case_format::range_text(key.range);  // `must be in [0, 1]; 1 is elastic`
    range = range.substr(0, range.find(';'));
    for (const std::string words : {"must be in ", "must be "}) {
      if (range.starts_with(words)) range = range.substr(words.size());
    }
    const bool is_number = range.find("inf") == std::string::npos;
    if (is_number) {
      EXPECT_NE(row.find("| " + range + " |"), std::string::npos) << key.path();
    }
  }
}

TEST(CaseReference, ErrorsAreThoseOfTheProgram) {
  const std::string text = R"([system]
dimension = 4
spheres = 4001
restituton = 0.6
solids_volume_fraction = "dense"

[start]
arrangement = "fcc"

[drive]
kind = "none"
shear_rate = 1.0

[colapse]
window = 100

[output]
collision_log = "windw"
)";
  std::string problems;
  try {
    parse_case(text, "case.toml",
               std::vector<std::string>{"collision.precision=half", "system.gravity=1"});
  } catch (const InputError& error) {
    problems = error.what();
  }
  EXPECT_EQ(problems + "\n", between(reference(), "```text\n", "```"));
}

}  // namespace
}  // namespace zenosphere
