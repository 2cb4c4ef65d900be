#include "campaign/adjudication_columns.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace zenosphere {
namespace {

/// The cells of an adjudication by their names without `adjudication_`, as text; NULL is empty.
std::map<std::string, std::string> texts(const Adjudication& found) {
  const auto cells = adjudication_cells({found, 2.5});
  std::map<std::string, std::string> texts;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    const std::string name(adjudication_columns()[n].name);
    texts[name.substr(std::string("adjudication_").size())] = cell_text(cells[n]);
  }
  return texts;
}

JudgedApproach approach(std::int64_t run_hit, Finding finding, int decades) {
  return {.finding = finding,
          .sentence = std::string("it is ") + word(finding),
          .spheres = {1, 4, 7},
          .decades = decades,
          .run_hit = run_hit};
}

TEST(AdjudicationColumns, TellTheFirstGroupByItsStrongestApproachAndCountTheOthers) {
  Adjudication found;
  found.finding = Finding::singular;
  found.left_out = 2;
  found.approaches = {approach(5, Finding::exact_contact, 30),
                      approach(5, Finding::near_collapse, 20), approach(9, Finding::singular, 90),
                      approach(9, Finding::undecided, 10), approach(12, Finding::undecided, 3)};
  found.approaches[1].spheres = {1, 4};
  found.approaches[1].curvature = Curvature{.margin = 3, .per_decade = -0.125, .depth = 20};
  found.approaches[2].collapse_time = "0.25000000000000000000000000000000001";
  auto told = texts(found);
  EXPECT_EQ(told["finding"], "singular");
  EXPECT_EQ(told["first_finding"], "near-collapse");
  EXPECT_EQ(told["sentence"], "it is near-collapse");
  EXPECT_EQ(told["groups"], "3");
  EXPECT_EQ(told["left_out"], "2");
  EXPECT_EQ(told["near_collapse"], "1");  // once, by the strongest of its approaches
  EXPECT_EQ(told["singular"], "1");
  EXPECT_EQ(told["undecided"], "1");
  EXPECT_EQ(told["exact_contact"], "0");
  EXPECT_EQ(told["first_spheres"], "2");
  EXPECT_EQ(told["decades"], "30");
  EXPECT_EQ(told["margin_per_decade"], "-0.125");
  EXPECT_EQ(told["collapse_time"], "0.25");
  EXPECT_EQ(told["seconds"], "2.5");
}

TEST(AdjudicationColumns, SayUndecidedWhereThereWasNoTimeForAnyGroup) {
  Adjudication found;
  found.left_out = 4;
  auto told = texts(found);
  EXPECT_EQ(told["finding"], "undecided");
  EXPECT_EQ(told["groups"], "0");
  EXPECT_EQ(told["left_out"], "4");
  EXPECT_EQ(told["first_finding"] + told["sentence"] + told["first_spheres"] + told["decades"], "");
}

}  // namespace
}  // namespace zenosphere
