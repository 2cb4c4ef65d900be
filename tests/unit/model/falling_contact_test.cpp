#include "model/falling_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/random.hpp"
#include "model/real.hpp"

namespace zenosphere {
namespace {

double any(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

template <class Real>
class FallingContact : public testing::Test {};
using Numbers = testing::Types<double, Extended, Quad, Digits>;
TYPED_TEST_SUITE(FallingContact, Numbers);

TYPED_TEST(FallingContact, OfADroppedSphereIsAfterTheTimeOfItsFall) {
  using Real = TypeParam;
  using std::abs;
  const WorkingPrecision digits(200);
  // Dropped from 2 above the top of a sphere at rest, gravity 1: after sqrt(2 x 2) = 2.
  const auto contact = falling_contact<2, Real>({{{0, 3}}, {{0, 0}}}, {{0, -1}}, Real(1));
  ASSERT_TRUE(contact);
  EXPECT_LE(abs(Real(contact->time - 2)), 8 * std::numeric_limits<Real>::epsilon());
  EXPECT_FALSE(contact->overlapping);
}

TYPED_TEST(FallingContact, EndsAHopOfAnyHeightWhenItShould) {
  using Real = TypeParam;
  using std::abs;
  const WorkingPrecision digits(200);
  // Up from the top at the speed v: back after 2 v. Also from a place that rounding has put inside.
  for (const double inside : {0.0, 1e-16, 1e-14}) {
    for (const double v : {1.0, 1e-6, 1e-12, 1e-40}) {
      const auto contact =
          falling_contact<2, Real>({{{0, 1 - Real(inside)}}, {{0, Real(v)}}}, {{0, -1}}, Real(1));
      ASSERT_TRUE(contact) << v;
      const Real flight = 2 * Real(v);
      EXPECT_LE(abs(Real(contact->time - flight)), Real(2 * inside + 1e-15) * flight) << v;
      EXPECT_FALSE(contact->overlapping);
    }
  }
}

TEST(FallingContact, OfASphereThatIsPressedOnAnotherIsNow) {
  const auto contact = falling_contact<2, double>({{{0, 1}}, {{0, 0}}}, {{0, -1}}, 1);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->time, 0);
}

TEST(FallingContact, IsNeverWhereASphereIsThrownOffAnother) {
  // On the top with a speed along it: the sphere leaves the other where v^2 > gravity x sigma.
  for (const double v : {0.99, 1.01}) {
    const auto contact = falling_contact<2, double>({{{0, 1}}, {{v, 0}}}, {{0, -1}}, 1);
    EXPECT_EQ(contact.has_value(), v < 1);
  }
}

TEST(FallingContact, OfOneThatOverlapsWhileItClosesIsThatOfAStraightFlight) {
  const RelativeMotion<2, double> motion{{{0, 1 - 1e-12}}, {{0.1, -1}}};
  const auto falling = falling_contact<2, double>(motion, {{0, -1}}, 1);
  const auto straight = contact(motion);
  ASSERT_TRUE(falling && straight);
  EXPECT_EQ(falling->time, straight->time);
  EXPECT_TRUE(falling->overlapping);
}

/// First time, up to `until`, at which small steps see the distance get below sigma.
double stepped(const RelativeMotion<3, double>& motion, const Vec<3, double>& pull, double sigma,
               double step, double until) {
  for (double t = step; t < until; t += step) {
    const auto r = motion.dr + motion.dv * t + pull * (t * t / 2);
    if (dot(r, r) < sigma * sigma) return t;
  }
  return until;
}

TEST(FallingContact, IsMissedByNoFlight) {
  constexpr double step = 1e-3;
  constexpr double until = 20;
  Random random(21);
  int contacts = 0, passes = 0;
  for (int n = 0; n < 4000; ++n) {
    Vec<3, double> dr, dv, pull;
    for (int axis = 0; axis < 3; ++axis) {
      dr[axis] = any(random, -2, 2);
      dv[axis] = any(random, -2, 2);
      pull[axis] = any(random, -1, 1);
    }
    const double sigma = any(random, 0.5, 2);
    if (dot(dr, dr) < sigma * sigma) continue;
    const RelativeMotion<3, double> motion{dr, dv};
    const double seen = stepped(motion, pull, sigma, step, until);
    const auto found = falling_contact(motion, pull, sigma);
    if (seen < until) {
      ASSERT_TRUE(found) << n;
      EXPECT_LE(found->time, seen) << n;
      ++contacts;
    }
    if (!found) {
      ++passes;
      continue;
    }
    const double t = found->time;
    const auto r = dr + dv * t + pull * (t * t / 2);
    EXPECT_NEAR(std::sqrt(dot(r, r)), sigma, 1e-12) << n;
    EXPECT_LE(dot(r, dv + pull * t), 1e-6) << n;  // they approach, or graze
    // No contact before: steps see nothing there.
    EXPECT_GE(seen, t - 1e-9) << n;
  }
  EXPECT_GT(contacts, 300);
  EXPECT_GT(passes, 300);
}

TEST(FallingContact, MissesNoGrazeAndMakesNone) {
  // Thrown past the top of the other: x = v t, y = 1 + h - t^2/2. The square of the distance has
  // its least value 2 v^2 (1 + h) - v^4 where v^2 < 1 + h, at t^2 = 2 (1 + h - v^2); from the left.
  Random random(22);
  for (int n = 0; n < 1000; ++n) {
    const double v = any(random, 0.1, 0.9);
    const double touching = (1 + v * v * v * v) / (2 * v * v) - 1;  // h of the least distance 1
    if (!(v * v < 1 + touching)) continue;
    for (const double over : {-1e-8, 1e-8}) {
      const double y = 1 + touching + over;
      const double back = 4;  // it comes from here, and has its apex above the other
      const RelativeMotion<2, double> motion{{{-v * back, y - back * back / 2}}, {{v, back}}};
      const auto r2 = dot(motion.dr, motion.dr);
      if (r2 < 1) continue;
      const auto contact = falling_contact<2, double>(motion, {{0, -1}}, 1);
      EXPECT_EQ(contact.has_value(), over < 0) << v;
    }
  }
}

}  // namespace
}  // namespace zenosphere
