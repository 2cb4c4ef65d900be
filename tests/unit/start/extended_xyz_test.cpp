#include "start/extended_xyz.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/start/start_fixture.hpp"

namespace zenosphere {
namespace {

using ExtendedXyz = StartFile;

TEST_F(ExtendedXyz, GivesItsLastFrame) {
  write("3\nany comment\nA 0 0 0\nB 1 1 1\nC 2 2 2\n" + xyz_header + xyz_rows + "\n");
  const GivenStart start = given_start(case_with());
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(start.sides, (std::vector<double>{10, 8}));
}

TEST_F(ExtendedXyz, GivesTheFrameThatIsChosen) {
  write(xyz_header + "A 2 2 0 1 0 0\nA 6 6 0 0 0 0\n" + xyz_header + xyz_rows);
  EXPECT_EQ(given_start(case_with({"start.snapshot=0"})).positions,
            (std::vector<double>{2, 2, 6, 6}));
  EXPECT_EQ(given_start(case_with({"start.snapshot=1"})).positions,
            (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(problem({"start.snapshot=2"}),
            "start: has 2 frames (start.snapshot = 2, counted from 0); choose one of them");
}

TEST_F(ExtendedXyz, PlacesSpheresInALeaningCell) {
  // The second sphere lies above the box: in it, it is 8 lower and 3 further left, and slower by
  // the flow between the two places.
  write(replaced(xyz_header, "10 0 0 0 8", "10 0 0 3 8") + "A 5 5 0 1 0.5 0\nA 4 9 0 2 0 0\n");
  const GivenStart start = given_start(case_with({"drive.kind=shear", "drive.shear_rate=0.25"}));
  EXPECT_EQ(start.offset, 3);
  EXPECT_EQ(start.positions, (std::vector<double>{5, 5, 1, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
}

TEST_F(ExtendedXyz, MayHaveOtherColumnsLineEndsAndBrackets) {
  write(
      "2\r\nproperties=id:I:1:velocity:R:3:Name:S:2:POS:R:3 time=\"0 \\\" Lattice=\" LATTICE = "
      "[[10, 0, 0], [0, 8, 0], [0, 0, 1]]\r\n"
      "7 1 5e-1 0 a b +1 1.0 0 \r\n8\t0 0 0 a b 4 1 0\r\n");
  const GivenStart start = given_start(case_with());
  EXPECT_EQ(start.positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(start.velocities, (std::vector<double>{1, 0.5, 0, 0}));
}

TEST_F(ExtendedXyz, ThatIsNoExtendedXyzIsRejectedWithItsLine) {
  EXPECT_EQ(problem_of(""), "start: is empty (needs a frame of extended XYZ)");
  EXPECT_EQ(problem_of("\n\n"), "start: is empty (needs a frame of extended XYZ)");
  EXPECT_EQ(problem_of("two\n"),
            "start:1: found no number of spheres (extended XYZ begins each frame with it)");
  EXPECT_EQ(problem_of("999999999999\n"),
            "start:1: 999999999999 spheres (must be in [1, 16777215])");
  EXPECT_EQ(problem_of("3\n\nA 1 1 0\n"),
            "start:4: the file ends (the frame that begins in line 1 needs 5 lines)");
  EXPECT_EQ(problem_of("3\n\nA 1 1 0\nA 2 2 0\nA 3 3 0\n"),
            "start:1: has 3 spheres (system.spheres = 2); make them equal");
  EXPECT_EQ(problem_of(xyz_header + "A 1 1 0 1 0.5 0\nA 4 1 0 0 0\n"),
            "start:4: has too few numbers");
  EXPECT_EQ(problem_of(xyz_header + "A 1 x 0 1 0.5 0\n" + xyz_rows.substr(16)),
            "start:3: found \"x\", needs a finite number that a double can hold");
  EXPECT_EQ(problem_of(xyz_header + "A 1 nan 0 1 0.5 0\n" + xyz_rows.substr(16)),
            "start:3: found \"nan\", needs a finite number that a double can hold");
  EXPECT_EQ(problem_of(xyz_header + "A 1 1 2 1 0.5 0\n" + xyz_rows.substr(16)),
            "start:3: column 4 is 2 (must be 0 where system.dimension = 2)");
  EXPECT_EQ(problem_of(xyz_header + "A 1 1e-400 0 1 0.5 0\n" + xyz_rows.substr(16)),
            "start:3: found \"1e-400\", needs a finite number that a double can hold");
  EXPECT_EQ(problem_of(xyz_header + "A 1 1 0 1 0.5 0 7\n" + xyz_rows.substr(16)),
            "start:3: has 8 columns (Properties has 7); make them equal");
  const std::string lattice = "2\nLattice=\"10 0 0 0 8 0 0 0 1\" ";
  EXPECT_EQ(problem_of(lattice + "Properties=species:S:1:force:R:3\n" + xyz_rows),
            "start:2: Properties has no pos:R:3; add the positions");
  EXPECT_EQ(problem_of(lattice + "Properties=pos:R:-3\n" + xyz_rows),
            "start:2: Properties: column \"pos\" has the count \"-3\" (must be in [1, 10000])");
  EXPECT_EQ(problem_of(std::string(1'048'577, '1')),
            "start:1: line of more than 1 MiB (is this a text file?)");
}

TEST_F(ExtendedXyz, HasTheBoxOfTheCase) {
  EXPECT_EQ(problem_of(replaced(xyz_header, "10", "10.1") + xyz_rows),
            "start: has a box of 10.1 x 8 diameters (that of the case is 10 x 8); make them equal "
            "with system.sides");
  EXPECT_EQ(problem_of(replaced(xyz_header, "10 0 0", "10 3 0") + xyz_rows),
            "start:2: Lattice has 3 beside its diagonal (only the second vector may lean, along "
            "x)");
  const std::string three =
      "start:2: Lattice has 3 numbers (must be 9, three vectors); write \"Lx 0 0 "
      "0 Ly 0 0 0 Lz\"";
  EXPECT_EQ(problem_of(replaced(xyz_header, "10 0 0 0 8 0 0 0 1", "5 6 7") + xyz_rows), three);
  EXPECT_EQ(
      problem_of(replaced(xyz_header, "10 0 0 0 8 0 0 0 1", "10 0 0 0 8 0 0 0 1 0") + xyz_rows),
      replaced(three, "3 numbers", "10 numbers"));
  EXPECT_EQ(
      problem_of("2\nany comment\nA 1 1 0\nA 4 1 0\n"),
      "start:2: has no Lattice (which box are the spheres in?); add Lattice=\"Lx 0 0 0 Ly 0 0 "
      "0 Lz\"");
  EXPECT_EQ(problem_of(replaced(xyz_header, "10", "10.000000001") + xyz_rows), "");
}

/// The xyz_header with more in front of its Properties.
std::string header_with(const std::string& more) {
  return replaced(xyz_header, " Properties", " " + more + " Properties");
}

TEST_F(ExtendedXyz, OriginIsTheLowestCornerOfTheBox) {
  write(header_with("Origin=\"-5 -4 -0.5\"") + "A -4 -3 0 1 0.5 0\nA -1 -3 0 0 0 0\n");
  EXPECT_EQ(given_start(case_with()).positions, (std::vector<double>{1, 1, 4, 1}));
  EXPECT_EQ(problem_of(header_with("Origin=\"0 0\"") + xyz_rows),
            "start:2: Origin has 2 numbers (must be 3)");
}

TEST_F(ExtendedXyz, BoundariesAreThoseOfTheCase) {
  const std::vector<std::string> walls{"walls.axis=y", "walls.restitution=1"};
  EXPECT_EQ(problem_of(header_with("pbc=\"T T F\"") + xyz_rows), "");  // there is no z
  EXPECT_EQ(problem(walls),
            "start: pbc has T along y (the case has [walls] there); make them agree");
  EXPECT_EQ(problem_of(header_with("pbc=[true, False, TRUE]") + xyz_rows),
            "start: pbc has F along y (the case is periodic there); make them agree");
  EXPECT_EQ(problem(walls), "");
  EXPECT_EQ(problem_of(header_with("pbc=\"F F F\"") + xyz_rows),
            "start: pbc has F along x (the case is periodic there); make them agree");
  EXPECT_EQ(problem_of(header_with("pbc=\"T\"") + xyz_rows),
            "start:2: pbc has 1 words (must be 3)");
  EXPECT_EQ(problem_of(header_with("pbc=\"T T no\"") + xyz_rows),
            "start:2: pbc has \"no\" (must be T or F)");
}

TEST_F(ExtendedXyz, WhatIsToldTwiceIsRefused) {
  EXPECT_EQ(problem_of(header_with("lattice=\"9 0 0 0 8 0 0 0 1\"") + xyz_rows),
            "start:2: has lattice twice; keep one");
  const std::string both = replaced(xyz_header, "velo:R:3", "velo:R:3:vel:R:3");
  EXPECT_EQ(problem_of(both + "A 1 1 0 1 0.5 0 2 0 0\nA 4 1 0 0 0 0 0 0 0\n"),
            "start:2: Properties has velo and vel (which are the velocities?); keep one");
  EXPECT_EQ(problem_of(replaced(xyz_header, "velo", "pos") + xyz_rows),
            "start:2: Properties has pos twice; keep one");
}

TEST_F(ExtendedXyz, MomentaBesideVelocitiesMustRepeatThem) {
  const std::string both = replaced(xyz_header, "velo:R:3", "velo:R:3:momenta:R:3");
  EXPECT_EQ(problem_of(both + "A 1 1 0 1 0.5 0 1 0.5 0\nA 4 1 0 0 0 0 0 0 0\n"), "");
  EXPECT_EQ(given_start(case_with()).velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(problem_of(both + "A 1 1 0 1 0.5 0 2 1 0\nA 4 1 0 0 0 0 0 0 0\n"),
            "start:3: momentum 2 beside velo 1 (they are equal: mass is the unit); keep one");
  EXPECT_EQ(problem_of(replaced(both, "momenta:R:3", "momenta:R:2") +
                       "A 1 1 0 1 0.5 0 1 0.5\nA 4 1 0 0 0 0 0 0\n"),
            "start:2: Properties has momenta of 2 columns (must be 3, as of velo)");
}

TEST_F(ExtendedXyz, RadiusDiameterAndMassAreThoseOfAUnitSphere) {
  const auto with = [](const std::string& name, const std::string& value) {
    return replaced(xyz_header, "velo:R:3", "velo:R:3:" + name + ":R:1") + "A 1 1 0 1 0.5 0 " +
           value + "\nA 4 1 0 0 0 0 " + value + "\n";
  };
  EXPECT_EQ(problem_of(with("radius", "0.5")), "");
  EXPECT_EQ(problem_of(with("masses", "1.0")), "");
  EXPECT_EQ(problem_of(with("radius", "1")),
            "start:3: radius = 1 (spheres have 0.5: diameter and mass are the units); give the "
            "file in them");
  EXPECT_EQ(problem_of(with("Diameter", "2")),
            "start:3: diameter = 2 (spheres have 1: diameter and mass are the units); give the "
            "file in them");
  EXPECT_EQ(problem_of(with("mass", "1.008")),
            "start:3: mass = 1.008 (spheres have 1: diameter and mass are the units); give the "
            "file in them");
}

TEST_F(ExtendedXyz, MomentaAreVelocitiesWhereTheMassIsKnownToBeOne) {
  const std::string momenta = replaced(xyz_header, "velo", "momenta");
  write(momenta + "X 1 1 0 1 0.5 0\nX 4 1 0 0 0 0\n");  // ASE: the element X has the mass 1
  EXPECT_EQ(given_start(case_with()).velocities, (std::vector<double>{1, 0.5, 0, 0}));
  write(replaced(momenta, "momenta:R:3", "momenta:R:3:masses:R:1") +
        "H 1 1 0 1 0.5 0 1\nH 4 1 0 0 0 0 1\n");
  EXPECT_EQ(given_start(case_with()).velocities, (std::vector<double>{1, 0.5, 0, 0}));
  EXPECT_EQ(problem_of(momenta + "H 1 1 0 1 0.5 0\nH 4 1 0 0 0 0\n"),
            "start: has momenta of spheres whose mass it does not tell (must be 1); add a column "
            "masses:R:1, or give velo:R:3");
  EXPECT_EQ(problem({"start.granular_temperature=1"}), "");  // they are drawn anew
}

TEST_F(ExtendedXyz, WhatAKeySaysOfAllSpheresIsThatOfAUnitSphere) {
  EXPECT_EQ(problem_of(header_with("radius=0.5 Diameter=\"1.0\" masses=1") + xyz_rows), "");
  EXPECT_EQ(problem_of(header_with("radius=1") + xyz_rows),
            "start:2: radius = 1 (spheres have 0.5: diameter and mass are the units); give the "
            "file in them");
  EXPECT_EQ(problem_of(header_with("Mass=39.95") + xyz_rows),
            "start:2: mass = 39.95 (spheres have 1: diameter and mass are the units); give the "
            "file in them");
  EXPECT_EQ(problem_of(header_with("radius=[0.5, 0.5]") + xyz_rows),
            "start:2: found \"0.5, 0.5\", needs a finite number that a double can hold");
  EXPECT_EQ(problem_of(header_with("velocity=\"1 0 0\"") + xyz_rows),
            "start:2: has velocity for all spheres (needs columns); name them in Properties");
}

TEST_F(ExtendedXyz, KeyThatIsNearlyOneThatIsReadIsNamed) {
  EXPECT_EQ(problem_of(header_with("Orgin=\"-5 -4 0\"") + xyz_rows),
            "start:2: has an unknown key \"orgin\"; did you mean Origin?");
  EXPECT_EQ(problem_of(replaced(xyz_header, "Properties", "Propertis") + xyz_rows),
            "start:2: has an unknown key \"propertis\"; did you mean Properties?");
  // What other programs note of a frame is theirs.
  EXPECT_EQ(problem_of(header_with("energy=-1.5 Time=3 step=4 config_type=gas original=yes PBE") +
                       xyz_rows),
            "");
}

TEST_F(ExtendedXyz, MassThatAKeyTellsMakesMomentaVelocities) {
  write(replaced(header_with("mass=1"), "velo", "momenta") + xyz_rows);
  EXPECT_EQ(given_start(case_with()).velocities, (std::vector<double>{1, 0.5, 0, 0}));
}

}  // namespace
}  // namespace zenosphere
