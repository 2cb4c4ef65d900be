#include "start/derived.hpp"

#include <gtest/gtest.h>

#include <string>

#include "case/case_cells.hpp"
#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

template <int Dim>
auto cells_of(const Case& values) {
  return box_of<Dim, double>(values);
}

/// What stands behind a label, without the blanks between; empty if the label is not there.
std::string line_of(const Case& values, const std::string& label) {
  const std::string text = '\n' + derived_text(values);
  const std::size_t at = text.find("\n" + label + "  ");
  if (at == std::string::npos) return "";
  const std::size_t begin = text.find_first_not_of(' ', at + 1 + label.size());
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(DerivedText, TellsBoxAndCellsOfThePaperCase) {
  // L^3 = 4000 pi / 1.8 = 6981.3170, L = 19.112278; n = 6 x 0.3 / pi = 0.57295780. 3.5
  // spheres a cell: (3.5 / n)^(1/3) = 1.8281; 10 layers of 1.9112278; 10^3 = 1000.
  const Case values = overridden(shear_case, {});
  EXPECT_EQ(line_of(values, "number density"), "0.5729578 per diameter^3");
  EXPECT_EQ(line_of(values, "box side"), "19.112278 diameters");
  EXPECT_EQ(line_of(values, "layers"), "10");
  EXPECT_EQ(line_of(values, "cells"), "1000");
  EXPECT_EQ(line_of(values, "cell width"), "1.9112278 diameters");
}

TEST(BoxOf, GivesADiluteSystemAboutTwoCellsForASphere) {
  // phi = 3e-7: L = 1911.23; 8000^(1/3) = 20 cells a side instead of 1911 / 4. The margin of a
  // cell lets only 19 fit.
  const Case dilute = overridden(shear_case, {"system.solids_volume_fraction=3e-7"});
  EXPECT_EQ(cells_of<3>(dilute).cells()[0], 19);
}

TEST(BoxOf, SlidesOnlyUnderShear) {
  EXPECT_TRUE(cells_of<3>(overridden(shear_case, {})).is_sheared());
  EXPECT_FALSE(cells_of<3>(overridden(cooling_case, {})).is_sheared());
}

TEST(DerivedText, TellsTheGapOfTheLattice) {
  // The lattice is closest packed at phi_c = 0.74048049: gap = (phi_c / 0.3)^(1/3) - 1 = 0.3514.
  EXPECT_EQ(line_of(overridden(shear_case, {}), "gap of lattice neighbours").substr(0, 6),
            "0.3514");
  EXPECT_EQ(
      line_of(overridden(shear_case, {"start.arrangement=random"}), "gap of lattice neighbours"),
      "");
}

TEST(BoxOf, HasTheSidesOfAPlaneAndIsClosedAtWalls) {
  const Case walled = overridden(
      replaced(replaced(shear_case, "dimension = 3", "dimension = 2"), "\"fcc\"", "\"random\""),
      {"drive.kind=none", "system.sides=[80, 90]", "walls.axis=y", "walls.restitution=1"});
  const auto box = cells_of<2>(walled);
  EXPECT_EQ(box.sides()[0], 80);
  EXPECT_EQ(box.sides()[1], 90);
  EXPECT_EQ(box.closed_axis(), 1);
  EXPECT_EQ(line_of(walled, "box side"), "80 x 90 diameters");
  EXPECT_EQ(line_of(walled, "number density"), "0.55555556 per diameter^2");  // 4000 / 7200
  EXPECT_EQ(line_of(walled, "solids volume fraction"), "0.43633231");         // x pi / 4
}

TEST(DerivedText, TellsTheLineOfAOneDimensionalCase) {
  const Case rods = overridden(
      replaced(replaced(cooling_case, "dimension = 3", "dimension = 1"), "\"fcc\"", "\"random\""),
      {"run.time=10", "drive.kind=random", "drive.noise_strength=1", "drive.kick_interval=0.25"});
  EXPECT_EQ(line_of(rods, "box side"), "13333.333 diameters");  // 4000 / 0.3
  EXPECT_EQ(line_of(rods, "number density"), "0.3 per diameter");
  EXPECT_EQ(line_of(rods, "layers"), "");
  EXPECT_EQ(line_of(rods, "kicks until run.time"), "40");
  EXPECT_EQ(line_of(rods, "one snapshot"), "0.061035156 MiB");  // 4000 x 16 bytes
}

TEST(DerivedText, ChecksWhatACaseGives) {
  const std::string pair =
      replaced(replaced(cooling_case, "\"fcc\"", "\"given\"\npositions = [[1, 1, 1], [3, 1, 1]]"),
               "spheres = 4000", "spheres = 2");
  const std::vector<std::string> moving{"system.solids_volume_fraction=0.01",
                                        "start.velocities=[[1, 2, 2], [0, 0, 1]]"};
  const Case right = overridden(pair, moving);
  EXPECT_EQ(line_of(right, "kinetic energy at start"), "5 mass diameter^2/time^2");
  EXPECT_THROW(derived_text(overridden(replaced(pair, "[3,", "[1.5,"), moving)), InputError);
}

TEST(DerivedText, TellsTheRestitutionOfViscoelasticSpheres) {
  EXPECT_EQ(line_of(overridden(cooling_case, {}), "restitution at the speed 1"), "");
  const Case values = overridden(cooling_case, {"collision.restitution_law=viscoelastic",
                                                "collision.viscoelastic_constant=0.5"});
  // The quotient at x = sqrt(0.5): 1.354321 / (1.354321 + 0.576724 + 0.204346 + 0.133044).
  EXPECT_EQ(line_of(values, "restitution at the speed 1").substr(0, 6), "0.5970");
}

TEST(DerivedText, TellsFromWhichSpeedAFixedEnergyIsLost) {
  const Case values = overridden(
      cooling_case, {"collision.restitution_law=fixed-loss", "collision.energy_loss=0.16"});
  EXPECT_EQ(line_of(values, "energy lost above the speed"), "0.8 diameters/time");
  EXPECT_EQ(line_of(values, "restitution at the speed 1"), "0.6");  // sqrt(1 - 0.64)
}

TEST(DerivedText, TellsHowStronglyAPlateIsAccelerated) {
  EXPECT_EQ(line_of(overridden(ball_case, {}), "peak acceleration of plate"), "");
  const Case values = overridden(ball_case, {"walls.motion=parabolic", "walls.amplitude=0.25",
                                             "walls.frequency=0.5", "gravity.acceleration=[-4]"});
  // 32 x 0.25 x 0.5^2
  EXPECT_EQ(line_of(values, "peak acceleration of plate"), "2 diameters/time^2");
  EXPECT_EQ(line_of(values, "the same over gravity"), "0.5");
}

TEST(DerivedText, TellsStrainOnlyUnderShear) {
  const Case sheared = overridden(shear_case, {"drive.shear_rate=4", "run.time=10"});
  EXPECT_EQ(line_of(sheared, "time of one strain unit"), "0.25 time");
  EXPECT_EQ(line_of(sheared, "strain at run.time"), "40");
  EXPECT_EQ(line_of(sheared, "strain at measure.after_time"), "0");
  EXPECT_EQ(line_of(overridden(cooling_case, {}), "time of one strain unit"), "");
  EXPECT_EQ(line_of(overridden(shear_case, {"drive.shear_rate=0"}), "time of one strain unit"), "");
}

TEST(DerivedText, WarnsOfAThresholdFarAboveTheDigits) {
  EXPECT_EQ(line_of(overridden(shear_case, {}), "gap threshold"), "");
  EXPECT_EQ(line_of(overridden(shear_case, {"collapse.gap_threshold=1e-14"}), "gap threshold"), "");
  EXPECT_EQ(line_of(overridden(shear_case, {"collapse.gap_threshold=1e-12"}), "gap threshold"),
            "1e+04 times that of the precision (warning: spheres that are close count as hits, and "
            "only the clock tells an arrest)");
  EXPECT_EQ(line_of(overridden(shear_case, {"collapse.window=10000"}), "window"),
            "5 collisions per sphere");
}

TEST(DerivedText, TellsTheSizeOfTheOutput) {
  // 2^20 collisions of 41 bytes; 2^14 of them in the window; 4000 x 48 bytes = 0.18310547 MiB.
  const std::vector<std::string> limited{"run.collisions=1048576"};
  EXPECT_EQ(line_of(overridden(cooling_case, limited), "collision log"), "41 MiB at most");
  EXPECT_EQ(line_of(overridden(cooling_case, limited), "collisions per sphere"), "524.288 at most");
  EXPECT_EQ(line_of(overridden(cooling_case, limited), "one snapshot"), "0.18310547 MiB");
  EXPECT_EQ(
      line_of(overridden(cooling_case, {"run.collisions=1048576", "output.collision_log=window",
                                        "output.log_first=1001", "output.log_last=17384"}),
              "collision log"),
      "0.640625 MiB at most");
  EXPECT_EQ(line_of(overridden(shear_case, {}), "collision log"), "");
}

}  // namespace
}  // namespace zenosphere
