#include "run/enclosure.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace zenosphere {
namespace {

using Place = Vec<2, double>;

Case discs_of(double restitution) {
  Case values;
  values.system.dimension = 2;
  values.system.restitution = restitution;
  return values;
}

/// Three discs nearly in line, which collapse at a restitution of 0.03 (tests/unit/proof), and
/// others.
Simulation<2, double> discs(double side, std::vector<Place> others = {}) {
  std::vector<Place> places{{5, 5}, {6.01, 5}, {7.1, 5.3}};
  std::vector<Place> velocities{{1, 0.01}, {0, 0}, {0.1, -0.02}};
  places.insert(places.end(), others.begin(), others.end());
  velocities.resize(places.size(), Place{0.2, 0});
  const Configuration<2, double> start{places, velocities};
  return {ShearBox<2, double>(Place{side, side}, 0), start, {0.03}};
}

std::optional<Certificate> enclosure(const Simulation<2, double>& gas, double restitution = 0.03) {
  return enclosed(discs_of(restitution), ClusterGaps(gas), {0, 1, 2}, 30,
                  std::chrono::steady_clock::time_point::max(), nullptr);
}

TEST(Enclosures, RowOfDiscsIsEnclosedAsFarAsAsked) {
  // All contacts come within a fifth of a time unit, and another disc needs more than that.
  const auto found = enclosure(discs(60, {{30, 30}}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Certificate::Kind::enclosed);
  EXPECT_GE(found->decades, 30);
}

TEST(Enclosures, RowThatPartsIsCertainToDoSo) {
  const auto found = enclosure(discs(60, {{30, 30}}), 0.3);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Certificate::Kind::escapes);
}

TEST(Enclosures, NothingIsSaidWhereAnotherDiscMayComeNear) {
  EXPECT_FALSE(enclosure(discs(60, {{8.11, 5.3}})));
}

TEST(Enclosures, NothingIsSaidOfARowThatClosesAroundTheBox) { EXPECT_FALSE(enclosure(discs(3.2))); }

/// A light disc of half the size between two of three times its mass, all in line, and one far
/// away. They collapse below 0.2038 (docs/decisions/0019), and equal ones below 0.0718.
Simulation<2, double> unlike_discs() {
  Configuration<2, double> start{{{5, 5}, {5.9, 5}, {7.02, 5}, {30, 30}},
                                 {{1, 0}, {0, 0}, {-0.2, 0}, {0, 0}}};
  start.grains.diameters = {1, 0.5, 1, 2};
  start.grains.masses = {3, 1, 3, 1};
  return {ShearBox<2, double>(Place{60, 60}, 0, 2.2), start, {0.2}};
}

TEST(Enclosures, DiscsOfDifferentSizeAndMassAreEnclosed) {
  const auto below = enclosure(unlike_discs(), 0.2);
  ASSERT_TRUE(below);
  EXPECT_EQ(below->kind, Certificate::Kind::enclosed);
  EXPECT_GE(below->decades, 30);
  const auto above = enclosure(unlike_discs(), 0.21);
  ASSERT_TRUE(above);
  EXPECT_EQ(above->kind, Certificate::Kind::escapes);
}

JudgedApproach singular() {
  JudgedApproach approach;
  approach.finding = Finding::singular;
  approach.spheres = {0, 1, 2};
  approach.milestones = {{9, 40, "1"}, {10, 44, "1"}, {11, 48, "1"}};
  return approach;
}

TEST(Enclosures, BeginWhereTheMedianGapIsBelowTenDecades) {
  EXPECT_EQ(place_to_enclose(discs_of(0.03), singular()), 44);
}

TEST(Enclosures, AreNotMadeWhereKicksOrContactModelsAct) {
  Case kicked = discs_of(0.03);
  kicked.drive.kind = DriveKind::random;
  EXPECT_FALSE(place_to_enclose(kicked, singular()));
  Case lasting = discs_of(0.03);
  lasting.collision.contact_duration = 1e-6;
  EXPECT_FALSE(place_to_enclose(lasting, singular()));
  Case rough = discs_of(0.03);
  rough.collision.tangential_restitution = 0.5;
  rough.collision.friction = Friction{0.3};
  EXPECT_FALSE(place_to_enclose(rough, singular()));
  Case fixed = discs_of(0.03);
  fixed.species = {{.name = "wall", .immobile = true}};
  EXPECT_FALSE(place_to_enclose(fixed, singular()));
}

}  // namespace
}  // namespace zenosphere
