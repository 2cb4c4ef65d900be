#include "proof/certify_rods.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <vector>

namespace zenosphere {
namespace {

using Kind = Certificate::Kind;
using Texts = std::vector<std::string>;

bool encloses(const Certificate& certificate, const Rational& time) {
  return exact_number(certificate.lower) <= time && time <= exact_number(certificate.upper);
}

Rational width(const Certificate& certificate) {
  return exact_number(certificate.upper) - exact_number(certificate.lower);
}

/// The rational case of three rods, with the first gap closed: gaps 0 and g, speeds 1, 0, 1/8.
RodsStart triple(const std::string& restitution, const std::string& last_place = "3") {
  return {.positions = {"0", "1", last_place},
          .velocities = {"1", "0", "0.125"},
          .restitution = restitution};
}

RodsStart four_rods(const std::string& restitution) {
  return {.positions = {"0", "1.4", "2.9", "4.1"},
          .velocities = {"1", "0.2", "-0.3", "-1.1"},
          .restitution = restitution};
}

// By hand (docs/decisions/0019): with the gap that closes next first, one contact is the matrix
// ((a, 1), (-e, 0)), a = (1 + e)/2, whose left eigenvector is (x, 1), x^2 - a x + e = 0. From the
// start c = (0, g), u = (-1, 1/8) it follows that the end is at -(l c)/(l u) = g / (x - 1/8). At e
// = 1/20 x = 2/5: 40/11 g.
TEST(CertifyRods, ThreeRodsAtOneTwentiethEndAtFortyEleventhsExactly) {
  const Certificate certificate = certify_rods(triple("0.05"));
  EXPECT_EQ(certificate.kind, Kind::proven);
  EXPECT_EQ(certificate.word, "ab");
  EXPECT_EQ(certificate.exact, "40/11");
  EXPECT_TRUE(encloses(certificate, Rational(40, 11)));
  EXPECT_LT(width(certificate), exact_number("1e-30"));
  EXPECT_NEAR(certificate.contraction, 0.3125 * 0.3125, 1e-12);  // two contacts of 5/16 each
  EXPECT_EQ(certificate.spheres, (std::vector<int>{0, 1, 2}));
}

TEST(CertifyRods, TheEndScalesWithTheGapHoweverSmall) {
  const Certificate certificate = certify_rods(triple("1/20", "2." + std::string(80, '0') + "3"));
  EXPECT_EQ(certificate.kind, Kind::proven);
  EXPECT_EQ(exact_number(certificate.exact), Rational(40, 11) * exact_number("3e-81"));
}

/// A light rod between two that are three times as heavy, as above.
RodsStart light_between(const std::string& restitution) {
  RodsStart start = triple(restitution);
  start.masses = {"3", "1", "3"};
  return start;
}

// As above with a = (1 + e) 3/4 = 9/10 at e = 1/5: x^2 - 9/10 x + 1/5 = 0, x = 1/2, the end is at
// g / (1/2 - 1/8), and what remains shrinks by e / x^2 = 4/5 in each of the two contacts.
TEST(CertifyRods, ALightRodBetweenHeavyOnesEndsAtEightThirdsExactly) {
  const Certificate certificate = certify_rods(light_between("1/5"));
  EXPECT_EQ(certificate.kind, Kind::proven);
  EXPECT_EQ(certificate.word, "ab");
  EXPECT_EQ(certificate.exact, "8/3");
  EXPECT_NEAR(certificate.contraction, 0.64, 1e-12);
  RodsStart longer = light_between("1/5");
  longer.positions = {"0", "1.5", "4"};
  longer.lengths = {"1", "2", "1"};
  EXPECT_EQ(certify_rods(longer).exact, "8/3");
}

// e_c = ((1 - sqrt(1 - b^2)) / b)^2, b = 3/4: 0.203776...
TEST(CertifyRods, ALightRodBetweenHeavyOnesHasItsThreshold) {
  EXPECT_EQ(certify_rods(light_between("0.2037")).kind, Kind::proven);
  EXPECT_EQ(certify_rods(light_between("0.2038")).kind, Kind::escapes);
}

// 7 - 4 sqrt(3) = 0.071796769724...
TEST(CertifyRods, ThreeRodsCollapseAMillionthBelowTheThresholdAndEscapeAMillionthAbove) {
  const Certificate below = certify_rods(triple("0.0717958"));
  EXPECT_EQ(below.kind, Kind::proven);
  const Certificate above = certify_rods(triple("0.0717977"));
  EXPECT_EQ(above.kind, Kind::escapes);
  EXPECT_GT(above.collisions, 500);
  EXPECT_TRUE(above.upper.empty());
  // The end solves p(1/t + 1/8) = 0, p(x) = x^2 - a x + e, at the larger of the two roots.
  const Rational e = exact_number("0.0717958");
  const Rational a = (1 + e) / 2;
  const auto p = [&](const std::string& time) {
    const Rational x = 1 / exact_number(time) + Rational(1, 8);
    EXPECT_GT(x, a / 2);
    return Rational(x * x - a * x + e);
  };
  EXPECT_GT(p(below.lower), 0);
  EXPECT_LT(p(below.upper), 0);
  EXPECT_TRUE(below.exact.empty());  // a^2 - 4e is no square
}

// On a line of period 100 the outer two meet around the end at last, long after time 10.
TEST(CertifyRods, RodsOnAPeriodicLineAreProvenToMeetSoOftenAndNoMoreUntilATime) {
  RodsStart start = triple("0.0717977");
  const auto alone = certify_rods(start);
  start.period = "100";
  const Certificate certificate = certify_rods(start, {.until = "10"});
  EXPECT_EQ(certificate.kind, Kind::finite);
  EXPECT_GT(certificate.collisions, 900);
  EXPECT_LE(certificate.collisions, alone.collisions);
  EXPECT_EQ(certify_rods(start, {.contacts = 3000}).kind, Kind::none);
}

TEST(CertifyRods, CollapseAfterTheTimeAskedForIsNotProven) {
  // The end is at 40/11 = 3.6.
  EXPECT_EQ(certify_rods(triple("0.05"), {.until = "0.5"}).kind, Kind::finite);
  EXPECT_EQ(certify_rods(triple("0.05"), {.until = "4"}).kind, Kind::proven);
}

// 3 - 2 sqrt(2) = 0.171572875...
TEST(CertifyRods, FourRodsCollapseBelowTheThresholdAndEscapeAbove) {
  const Certificate below = certify_rods(four_rods("0.17147"));
  EXPECT_EQ(below.kind, Kind::proven);
  EXPECT_EQ(below.spheres.size(), 4U);
  EXPECT_LT(width(below), exact_number("1e-28"));
  EXPECT_EQ(certify_rods(four_rods("0.17167")).kind, Kind::escapes);
}

TEST(CertifyRods, FourRodsZigzagInLongerRoundsJustAboveTheThresholdOfThree) {
  EXPECT_EQ(certify_rods(four_rods("0.15")).word, "ababcbcb");
  EXPECT_EQ(certify_rods(four_rods("0.1")).word, "abababcbcbcb");
  EXPECT_EQ(certify_rods(four_rods("0.08")).word, "abababababcbcbcbcbcb");
}

TEST(CertifyRods, TheExactRunGoesOnInsideTheEnclosure) {
  for (const std::string e : {"0.05", "0.1", "0.15"}) {
    const Certificate certificate = certify_rods(four_rods(e), {.digits = 6});
    ASSERT_EQ(certificate.kind, Kind::proven);
    ExactRods rods(four_rods(e));
    for (int k = 0; k < 400; ++k) ASSERT_EQ(rods.next_event(), ExactRods::Event::contact);
    EXPECT_LT(rods.now(), exact_number(certificate.upper));
    EXPECT_GT(rods.now(), exact_number(certificate.lower));
  }
}

TEST(CertifyRods, NoProofWhileAnotherRodIsOnItsWay) {
  RodsStart start = triple("0.05");
  start.positions.push_back("13");
  start.velocities.push_back("0");
  const Certificate alone = certify_rods(start);
  EXPECT_EQ(alone.kind, Kind::proven);
  EXPECT_EQ(alone.spheres, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(alone.exact, "40/11");
  // Sixth contact at 40/11 (1 - (5/16)^5) = 3.6255, end at 3.6364. In between, at 3.630, the third
  // rod is near 4/3 + 3/8 t + 1 = 3.695, and so is 8.325 - t - 1.
  start.positions.back() = "8.325";
  start.velocities.back() = "-1";
  const Certificate disturbed = certify_rods(start);
  EXPECT_FALSE(disturbed.kind == Kind::proven && disturbed.exact == "40/11");
}

TEST(CertifyRods, OnAPeriodicLineTheRowMayLieAcrossTheEnd) {
  const RodsStart start{.positions = {"0.5", "8.5", "9.5"},
                        .velocities = {"0.125", "1", "0"},
                        .restitution = "0.05",
                        .period = "10"};
  // The triple with g = 10 + 0.5 - 9.5 - 1 = 0: three rods touch. With a gap of one it is the
  // triple.
  EXPECT_EQ(certify_rods(start).kind, Kind::exact_contact);
  RodsStart open = start;
  open.positions[0] = "1.5";
  const Certificate certificate = certify_rods(open);
  EXPECT_EQ(certificate.exact, "40/11");
  EXPECT_EQ(certificate.spheres, (std::vector<int>{1, 2, 0}));
}

TEST(CertifyRods, RodsThatMeetSymmetricallyAreAnExactContactAndNoCollapse) {
  for (const std::string e : {"1", "0.5", "0.05", "0"}) {
    const Certificate certificate = certify_rods(
        {.positions = {"1", "10", "19"}, .velocities = {"1", "0", "-1"}, .restitution = e});
    EXPECT_EQ(certificate.kind, Kind::exact_contact);
    EXPECT_TRUE(certificate.upper.empty());
  }
  // Newton's cradle: two rods at rest touch each other when the third arrives.
  EXPECT_EQ(certify_rods(
                {.positions = {"0", "3", "4"}, .velocities = {"1", "0", "0"}, .restitution = "1"})
                .kind,
            Kind::exact_contact);
}

TEST(CertifyRods, AtZeroRestitutionRodsStickAndTheNextContactIsExact) {
  const Certificate certificate = certify_rods({.positions = {"0", "2.87", "5.36"},
                                                .velocities = {"-1", "0.3", "0.2"},
                                                .restitution = "0",
                                                .period = "7.5"});
  EXPECT_EQ(certificate.kind, Kind::exact_contact);
  EXPECT_EQ(certificate.collisions, 1);
}

TEST(CertifyRods, ElasticRodsAreNeverProvenToCollapse) {
  RodsStart start = four_rods("1");
  start.period = "9";
  EXPECT_EQ(certify_rods(start, {.contacts = 1000}).kind, Kind::none);
  start.period = "";
  EXPECT_EQ(certify_rods(start).kind, Kind::escapes);
}

TEST(CertifyRods, AnInterruptEndsIt) {
  const std::atomic<bool> interrupt = true;
  RodsStart start = four_rods("1");
  start.period = "9";
  const Certificate certificate = certify_rods(start, {.interrupt = &interrupt});
  EXPECT_EQ(certificate.kind, Kind::none);
  EXPECT_EQ(certificate.collisions, 1);
}

TEST(CertifyRods, EqualTimesOfSeparatePairsAreToldWhereTheProofDoesNotCoverThem) {
  const Certificate certificate = certify_rods({.positions = {"0", "2", "4", "6"},
                                                .velocities = {"3", "1", "-1", "-3"},
                                                .restitution = "0.05"});
  // All three gaps close at t = 1/2: three rods at once. With a wider middle the outer pairs meet
  // together.
  EXPECT_EQ(certificate.kind, Kind::exact_contact);
  const Certificate pairs = certify_rods({.positions = {"0", "2", "5", "7"},
                                          .velocities = {"3", "1", "-1", "-3"},
                                          .restitution = "0.05"},
                                         {.contacts = 200});
  EXPECT_EQ(pairs.kind, Kind::none);
  EXPECT_NE(pairs.reason.find("at one instant"), std::string::npos) << pairs.reason;
}

}  // namespace
}  // namespace zenosphere
