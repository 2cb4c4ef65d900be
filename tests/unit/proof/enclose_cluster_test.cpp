#include "proof/enclose_cluster.hpp"

#include <gtest/gtest.h>

#include <string>

#include "model/real.hpp"
#include "proof/ball_spheres.hpp"
#include "proof/exact_rods.hpp"

namespace zenosphere {
namespace {

using Kind = Certificate::Kind;
using Spheres = std::vector<ExactSphere>;

/// Places and velocities along a direction.
Spheres along(const std::vector<Rational>& direction, const std::vector<Rational>& places,
              const std::vector<Rational>& speeds) {
  Spheres spheres(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const Rational& part : direction) {
      spheres[i].position.push_back(places[i] * part);
      spheres[i].velocity.push_back(speeds[i] * part);
    }
  }
  return spheres;
}

/// Three disks, nearly in line, with sideways velocities: their normals turn as they collapse.
Spheres bent_row() {
  return {
      {{0, 0}, {1, Rational(1, 100)}},
      {{exact_number("1.01"), 0}, {0, 0}},
      {{exact_number("2.1"), exact_number("0.3")}, {exact_number("0.1"), exact_number("-0.02")}}};
}

// (1, 2, 2)/3 is a unit vector. The end is at 40/11 (tests/unit/proof/certify_rods_test.cpp); each
// contact leaves 5/16 of what remained and 1/8 of the gap: at 1e-100 there remain about 1e-56.
TEST(EncloseCluster, TheRationalTripleAlongADiagonalNearsFortyElevenths) {
  const Certificate certificate = enclose_cluster(
      along({Rational(1, 3), Rational(2, 3), Rational(2, 3)}, {0, 1, 3}, {1, 0, Rational(1, 8)}),
      Rational(1, 20));
  EXPECT_EQ(certificate.kind, Kind::enclosed) << certificate.reason;
  EXPECT_EQ(certificate.word, "ab");
  EXPECT_GE(certificate.decades, 100);
  const Rational end(40, 11);
  EXPECT_LT(exact_number(certificate.upper), end);
  EXPECT_LT(end - exact_number(certificate.lower), exact_number("1e-54"));
  EXPECT_GT(end - exact_number(certificate.upper), exact_number("1e-60"));
}

/// Checks that spheres on a line, with restitution 0.15, meet when and where rods do.
void expect_times_of(ExactRods& rods, const Spheres& spheres) {
  const BallPrecision precision(2000);
  BallSpheres balls(spheres, exact_number("0.15"));
  for (int k = 0; k < 200; ++k) {
    ASSERT_EQ(balls.next_event(), BallSpheres::Event::collision);
    ASSERT_EQ(rods.next_event(), ExactRods::Event::contact);
    ASSERT_EQ(balls.pair(), BallSpheres::Pair(rods.letter(), rods.letter() + 1));
    const Enclosure now = balls.now().ends();
    ASSERT_LE(now.lower, rods.now());
    ASSERT_GE(now.upper, rods.now());
    ASSERT_LT(now.upper - now.lower, exact_number("1e-60"));
  }
}

TEST(EncloseCluster, HoldsTheTimesOfExactRods) {
  const std::vector<Rational> x{0, exact_number("1.4"), exact_number("2.9"), exact_number("4.1")};
  const std::vector<Rational> v{1, Rational(1, 5), Rational(-3, 10), Rational(-11, 10)};
  const Spheres spheres = along({1}, x, v);
  ExactRods rods({.positions = {"0", "1.4", "2.9", "4.1"},
                  .velocities = {"1", "0.2", "-0.3", "-1.1"},
                  .restitution = "0.15"});
  expect_times_of(rods, spheres);
}

TEST(EncloseCluster, HoldsTheTimesOfExactRodsOfDifferentLengthAndMass) {
  Spheres spheres = along({1}, {0, exact_number("1.9"), exact_number("3.1"), exact_number("4.1")},
                          {1, Rational(1, 5), Rational(-3, 10), Rational(-11, 10)});
  const std::vector<std::string> lengths{"2", "0.5", "1", "0.4"};
  const std::vector<std::string> masses{"3", "0.25", "2", "7"};
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    spheres[i].radius = exact_number(lengths[i]) / 2;
    spheres[i].mass = exact_number(masses[i]);
  }
  ExactRods rods({.positions = {"0", "1.9", "3.1", "4.1"},
                  .velocities = {"1", "0.2", "-0.3", "-1.1"},
                  .restitution = "0.15",
                  .lengths = lengths,
                  .masses = masses});
  expect_times_of(rods, spheres);
}

/// A light sphere of half the size between two of M = 3 times its mass, along (3, 4)/5.
Spheres light_one_between_heavy_ones() {
  Spheres spheres = along({Rational(3, 5), Rational(4, 5)},
                          {0, exact_number("0.9"), exact_number("2.02")}, {1, 0, Rational(-1, 5)});
  for (ExactSphere& sphere : spheres) sphere.mass = 3;
  spheres[1].mass = 1;
  spheres[1].radius = Rational(1, 4);
  return spheres;
}

// In line they collapse below ((1 - sqrt(1 - b^2)) / b)^2 = 0.20378, b = M/(M + 1)
// (docs/decisions/0019); equal ones below 0.0718.
TEST(EncloseCluster, ALightDiskBetweenHeavyOnesCollapsesBelowTheRestitutionOfRods) {
  const Certificate below =
      enclose_cluster(light_one_between_heavy_ones(), exact_number("0.203"), {.decades = 60});
  EXPECT_EQ(below.kind, Kind::enclosed) << below.reason;
  EXPECT_EQ(below.word, "ab");
  const Certificate above = enclose_cluster(light_one_between_heavy_ones(), exact_number("0.21"));
  EXPECT_EQ(above.kind, Kind::escapes) << above.reason;
}

// Two contacts in turn have real eigenvalues, so that the gaps can fall for ever, if
// b^2 (1 + e)(1 + e') - e - e' >= 2 sqrt(e e'), b = 3/4: 0.383 >= 0.179 with 0.4 and 0.02, but
// 0.303 < 0.8 with 0.4 twice.
TEST(EncloseCluster, TakesTheRestitutionOfEachPair) {
  const Spheres spheres = light_one_between_heavy_ones();
  PairRestitutions restitutions(3, exact_number("0.4"));
  EXPECT_EQ(enclose_cluster(spheres, restitutions).kind, Kind::escapes);
  restitutions.rows[1][2] = restitutions.rows[2][1] = exact_number("0.02");
  EXPECT_EQ(enclose_cluster(spheres, restitutions, {.decades = 40}).kind, Kind::enclosed);
}

TEST(EncloseCluster, ABentRowOfDisksIsFollowedForHundredsOfDecades) {
  const Certificate certificate =
      enclose_cluster(bent_row(), exact_number("0.03"), {.decades = 300, .bits = 4096});
  EXPECT_EQ(certificate.kind, Kind::enclosed) << certificate.reason;
  EXPECT_EQ(certificate.spheres, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(certificate.word, "ab");
}

// Where the time left falls faster than the speed squared the turning of the normals parts them.
TEST(EncloseCluster, TheSameRowCertainlyEscapesAtALargerRestitution) {
  const Certificate certificate = enclose_cluster(bent_row(), exact_number("0.06"));
  EXPECT_EQ(certificate.kind, Kind::escapes);
  EXPECT_LT(certificate.decades, 20);
}

TEST(EncloseCluster, ThreeThatMeetAtOneInstantAreNeverCertain) {
  const Certificate certificate = enclose_cluster(
      along({Rational(3, 5), Rational(4, 5)}, {1, 10, 19}, {1, 0, -1}), 1, {.bits = 2048});
  EXPECT_EQ(certificate.kind, Kind::none);
  EXPECT_NE(certificate.reason.find("one instant"), std::string::npos) << certificate.reason;
}

TEST(EncloseCluster, AnOverlapThatClosesIsNoStart) {
  const Certificate certificate =
      enclose_cluster(along({1, 0}, {0, exact_number("0.9999999999999999")}, {1, 0}), 0);
  EXPECT_EQ(certificate.kind, Kind::none);
  EXPECT_NE(certificate.reason.find("overlap"), std::string::npos) << certificate.reason;
}

TEST(EncloseCluster, ALimitOfCollisionsIsToldWithTheDecadesReached) {
  const Certificate certificate =
      enclose_cluster(bent_row(), exact_number("0.03"), {.collisions = 50});
  EXPECT_EQ(certificate.kind, Kind::none);
  EXPECT_EQ(certificate.collisions, 50);
  EXPECT_GT(certificate.decades, 20);
}

TEST(Exactly, AFloatingPointNumberIsTheFractionThatItIs) {
  EXPECT_EQ(exactly(0.1), Rational(0.1));
  EXPECT_NE(exactly(0.1), Rational(1, 10));
  EXPECT_EQ(exactly(-0x1p-1074), Rational(-1) / Rational(Integer(1) << 1074));
  EXPECT_EQ(exactly(0.0), 0);
  EXPECT_EQ(exactly(Extended(1) + 0x1p-63L), 1 + Rational(1) / Rational(Integer(1) << 63));
  const Digits tenth = Digits(1) / 10;
  const Rational error = exactly(tenth) - Rational(1, 10);
  EXPECT_NE(error, 0);
  EXPECT_LT(abs(error), exact_number("1e-100"));
  EXPECT_EQ(exactly(Digits(3) * 1e40), exact_number("3") * Rational(1e40));
}

}  // namespace
}  // namespace zenosphere
