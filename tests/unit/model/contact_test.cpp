#include "model/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace zenosphere {
namespace {

using Motion = RelativeMotion<3, double>;

TEST(Gap, IsTheSurfaceDistance) {
  EXPECT_EQ(gap(Vec<3, double>{{0, 3, 4}}), 4);  // 5 - 1
  EXPECT_EQ(gap(Vec<3, double>{{0, 0, -0.75}}), -0.25);
}

TEST(Contact, OfAHeadOnPairComesAfterTheGapIsFlown) {
  // Centres 3 apart, surfaces 2, closing speed 4: time 0.5.
  const auto contact = zenosphere::contact(Motion{{{0, 3, 0}}, {{0, -4, 0}}});
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->time, 0.5);
  EXPECT_FALSE(contact->overlapping);
  EXPECT_EQ(contact->approach, -12);
}

TEST(Contact, OfAnObliquePairIsTheEarlierRoot) {
  // Moving along -x past a centre 0.6 aside: touches where dx = 0.8, that is after 2 - 0.8 = 1.2;
  // it would leave again at dx = -0.8.
  const auto contact = zenosphere::contact(Motion{{{2, 0.6, 0}}, {{-1, 0, 0}}});
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->time, 1.2, 4e-16);  // two ulps
}

TEST(Contact, DoesNotComeWhilePairsRecedeOrRest) {
  EXPECT_FALSE(contact(Motion{{{2, 0, 0}}, {{1, 0, 0}}}));
  EXPECT_FALSE(contact(Motion{{{2, 0, 0}}, {{0, 1, 0}}}));
  EXPECT_FALSE(contact(Motion{{{2, 0, 0}}, {{0, 0, 0}}}));
  EXPECT_FALSE(contact(Motion{{{0.9, 0, 0}}, {{1, 0, 0}}}));  // overlapping and receding
}

TEST(Contact, IsMissedByFarAndByLittle) {
  EXPECT_FALSE(contact(Motion{{{5, 3, 0}}, {{-1, 0, 0}}}));
  EXPECT_FALSE(contact(Motion{{{5, 1.001, 0}}, {{-1, 0, 0}}}));
}

TEST(Contact, OfAGrazingPairComesAtTheClosestApproach) {
  // |(0.75, 1)| = 1.25: b = -0.75, c = 0.25 x 2.25 = 0.5625 = b^2 exactly; touches after 0.75.
  const auto contact = zenosphere::contact(Motion{{{0.75, 1, 0}}, {{-1, 0, 0}}});
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->time, 0.75);
  // An impact parameter of 1 -+ 1e-12 touches 1.4e-6 = sqrt(2e-12) earlier, or never.
  const auto deeper = zenosphere::contact(Motion{{{0.75, 1 - 1e-12, 0}}, {{-1, 0, 0}}});
  ASSERT_TRUE(deeper);
  EXPECT_NEAR(deeper->time, 0.75 - std::sqrt(2e-12), 1e-9);
  EXPECT_FALSE(zenosphere::contact(Motion{{{0.75, 1 + 1e-12, 0}}, {{-1, 0, 0}}}));
}

TEST(Contact, KeepsTheDigitsOfATinyGapWhereTheTextbookRootLosesThem) {
  // A gap of 5 x 2^-52 = 1.1e-15 along x, closing speed 1, tangential speeds up to 2. To first
  // order the time is the gap; the next order is 1e-15 smaller.
  const double tiny = 5 * 0x1p-52;
  double worst = 0;
  for (int n = 1; n <= 100; ++n) {
    const Motion motion{{{1 + tiny, 0, 0}}, {{-1, 0.02 * n, 0}}};
    const auto contact = zenosphere::contact(motion);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->time / tiny, 1, 4e-15);
    const double b = dot(motion.dr, motion.dv);
    const double v2 = dot(motion.dv, motion.dv);
    const double textbook = (-b - std::sqrt(b * b - v2 * (dot(motion.dr, motion.dr) - 1))) / v2;
    worst = std::max(worst, std::abs(textbook / tiny - 1));
  }
  EXPECT_GT(worst, 0.05);
}

TEST(Contact, OfATouchingApproachingPairIsNowAndLeftToTheOverlapRule) {
  const auto contact = zenosphere::contact(Motion{{{1, 0, 0}}, {{-2, 1, 0}}});
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->time, 0);
  EXPECT_TRUE(contact->overlapping);
}

TEST(Contact, OfAnOverlappingApproachingPairLiesInThePast) {
  // Centres 0.75 apart, closing at 0.5: they touched 0.25 / 0.5 ago.
  const auto contact = zenosphere::contact(Motion{{{0, 0, 0.75}}, {{0, 0, -0.5}}});
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->time, -0.5, 1e-16);
  EXPECT_TRUE(contact->overlapping);
  EXPECT_EQ(contact->approach, -0.375);
  // An overlap of one ulp below 1, 2^-53, is seen and lies that little in the past.
  const auto slight = zenosphere::contact(Motion{{{1 - 0x1p-53, 0, 0}}, {{-1, 0, 0}}});
  ASSERT_TRUE(slight);
  EXPECT_TRUE(slight->overlapping);
  EXPECT_NEAR(slight->time, -0x1p-53, 1e-30);
}

TEST(Impact, ReversesTheNormalSpeedByTheRestitution) {
  // Normal (0.6, 0.8, 0); dv = -5 n + 2 t with t = (-0.8, 0.6, 0): (-4.6, -2.8, 0).
  const Motion motion{{{0.6, 0.8, 0}}, {{-4.6, -2.8, 0}}};
  const auto impact = zenosphere::impact(motion, 0.6);
  EXPECT_NEAR(impact.distance, 1, 2e-16);
  EXPECT_NEAR(impact.normal_speed, 5, 2e-15);
  EXPECT_NEAR(impact.impulse, 4, 2e-15);  // (1 + 0.6) 5 / 2
  // j gains 4 n, i loses it: dv + 8 n = 3 n + 2 t.
  const Vec<3, double> after = motion.dv + impact.normal * (2 * impact.impulse);
  EXPECT_NEAR(after[0], 3 * 0.6 - 2 * 0.8, 4e-15);
  EXPECT_NEAR(after[1], 3 * 0.8 + 2 * 0.6, 4e-15);
}

TEST(Impact, NormalisesADistanceThatRoundingLeft) {
  const auto impact = zenosphere::impact(Motion{{{0, -1.25, 0}}, {{0, 2, 0}}}, 1.0);
  EXPECT_EQ(impact.distance, 1.25);
  EXPECT_EQ(impact.normal, (Vec<3, double>{{0, -1, 0}}));
  EXPECT_EQ(impact.impulse, 2);  // elastic: the spheres exchange their normal speeds
}

TEST(Impact, OfAPlasticPairTakesTheWholeNormalSpeed) {
  const auto impact = zenosphere::impact(Motion{{{1, 0, 0}}, {{-3, 0, 0}}}, 0.0);
  EXPECT_EQ(impact.impulse, 1.5);  // -3 + 2 x 1.5 = 0
}

TEST(Impact, GivesARecedingPairNoImpulse) {
  const auto impact = zenosphere::impact(Motion{{{1, 0, 0}}, {{1e-17, 1, 0}}}, 0.9);
  EXPECT_EQ(impact.normal_speed, -1e-17);
  EXPECT_EQ(impact.impulse, 0);
}

}  // namespace
}  // namespace zenosphere
