#include "proof/exact_rods.hpp"

#include <gtest/gtest.h>

#include "model/errors.hpp"
#include "proof/round_of_contacts.hpp"

namespace zenosphere {
namespace {

RodsStart start_of_five() {
  return {.positions = {"0", "1.25", "2.5", "4", "5.3"},
          .velocities = {"1", "0.5", "-0.25", "0", "-2"},
          .restitution = "0.3"};
}

/// The plain way, without c and u: gaps and velocities in fractions, moved from contact to contact.
struct PlainRods {
  RationalVector x, v;
  Rational e, now = 0;

  int next_contact() {
    int next = -1;
    Rational first;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const Rational speed = v[i] - v[i + 1];
      if (speed <= 0) continue;
      const Rational flight = (x[i + 1] - x[i] - 1) / speed;
      if (next < 0 || flight < first) {
        first = flight;
        next = static_cast<int>(i);
      }
    }
    if (next < 0) return next;
    now += first;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += first * v[i];
    const Rational impulse = (1 + e) / 2 * (v[next] - v[next + 1]);
    v[next] -= impulse;
    v[next + 1] += impulse;
    return next;
  }
};

TEST(ExactRods, MeetAsInTheirEquationsOfMotion) {
  ExactRods rods(start_of_five());
  PlainRods plain{{}, {}, exact_number("0.3")};
  for (const auto& text : start_of_five().positions) plain.x.push_back(exact_number(text));
  for (const auto& text : start_of_five().velocities) plain.v.push_back(exact_number(text));
  int contacts = 0;
  for (int next = plain.next_contact(); next >= 0; next = plain.next_contact(), ++contacts) {
    ASSERT_EQ(rods.next_event(), ExactRods::Event::contact);
    ASSERT_EQ(rods.letter(), next);
    ASSERT_EQ(rods.now(), plain.now);
    for (int i = 0; i < 4; ++i) ASSERT_EQ(rods.gap(i), plain.x[i + 1] - plain.x[i] - 1);
  }
  EXPECT_GT(contacts, 8);
  EXPECT_EQ(rods.next_event(), ExactRods::Event::none_left);
}

TEST(ExactRods, FollowTheMapOfARoundUpToOneFactor) {
  ExactRods rods({.positions = {"0", "1.4", "2.9", "4.1"},
                  .velocities = {"1", "0.2", "-0.3", "-1.1"},
                  .restitution = "0.15"});
  const auto state = [&rods] {
    return RowState{{rods.constants().begin(), rods.constants().end()},
                    {rods.slopes().begin(), rods.slopes().end()}};
  };
  for (int k = 0; k < 40; ++k) rods.next_event();
  const RowState before = state();
  std::vector<int> word;
  for (int k = 0; k < 8; ++k) {
    rods.next_event();
    word.push_back(rods.letter());
  }
  const RowState mapped = RoundOfContacts(word, 3, rods.restitution()).after(before, 1);
  const RowState after = state();
  const Rational factor = after.u[0] / mapped.u[0];
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(after.u[i], factor * mapped.u[i]);
    EXPECT_EQ(after.c[i], factor * mapped.c[i]);
  }
  EXPECT_EQ(mapped.contact_time(word.back()), rods.now());
}

TEST(ExactRods, TakeTheShorterOfTwoTimesThatDoubleCannotTellApart) {
  // Gaps of 1 and of 1 - 1e-40, both closing at 1: the second pair meets first.
  ExactRods rods({.positions = {"0", "2", "5", "6." + std::string(40, '9')},
                  .velocities = {"1", "0", "1", "0"},
                  .restitution = "0.5"});
  ASSERT_EQ(rods.next_event(), ExactRods::Event::contact);
  EXPECT_EQ(rods.letter(), 2);
  EXPECT_EQ(rods.now(), 1 - exact_number("1e-40"));
  EXPECT_FALSE(rods.has_simultaneous_contacts());
}

// Masses 3 and 1 at speed 1 and e = 1/2: the impulse is 3/2 x 3/4, speeds are 5/8 and 9/8 then.
TEST(ExactRods, OfDifferentMassKeepTheMomentum) {
  ExactRods rods({.positions = {"0", "2", "5"},
                  .velocities = {"1", "0", "0"},
                  .restitution = "0.5",
                  .masses = {"3", "1", "7"}});
  ASSERT_EQ(rods.next_event(), ExactRods::Event::contact);
  const std::vector<Integer>& u = rods.slopes();
  EXPECT_EQ(Rational(u[1], u[0]), Rational(-9, 4));  // -9/8 over 1/2
  EXPECT_EQ(rods.now(), 1);
}

// Twice the energy in the frame of the centre of mass is 3 - 9/11 = 24/11.
TEST(ExactRods, OfDifferentMassBoundVelocitiesByEnergy) {
  ExactRods rods({.positions = {"0", "2", "5"},
                  .velocities = {"1", "0", "0"},
                  .restitution = "1",
                  .masses = {"3", "1", "7"}});
  EXPECT_GE(rods.velocity_range() * rods.velocity_range(), 4 * Rational(24, 11));
  ASSERT_EQ(rods.next_event(), ExactRods::Event::contact);  // the light one flies off at 3/2
}

TEST(ExactRods, RefuseWhatIsNoStart) {
  const auto refused = [](const RodsStart& start) { EXPECT_THROW(ExactRods{start}, InputError); };
  refused({.positions = {"0", "0.999"}, .velocities = {"0", "0"}, .restitution = "0.5"});
  refused({.positions = {"0", "2"}, .velocities = {"0"}, .restitution = "0.5"});
  refused({.positions = {"0"}, .velocities = {"0"}, .restitution = "0.5"});
  refused({.positions = {"0", "2"}, .velocities = {"0", "0"}, .restitution = "1.01"});
  refused({.positions = {"0", "two"}, .velocities = {"0", "0"}, .restitution = "1"});
}

TEST(ExactNumber, IsWhatTheTextMeans) {
  EXPECT_EQ(exact_number("0.05"), Rational(1, 20));
  EXPECT_EQ(exact_number("-1.5e-3"), Rational(-3, 2000));
  EXPECT_EQ(exact_number("+2E2"), 200);
  EXPECT_EQ(exact_number("40/11"), Rational(40, 11));
  EXPECT_EQ(exact_number("-40/10"), -4);
  EXPECT_EQ(exact_number(".5"), Rational(1, 2));
  EXPECT_EQ(exact_number("1e-400") * exact_number("1e400"), 1);
  for (const std::string text :
       {"", "-", ".", "1.2.3", "1e", "e5", "1/0", "1/", "nan", "1e999999999", "--1"}) {
    EXPECT_THROW(exact_number(text), InputError) << text;
  }
}

TEST(ExactNumber, DecimalsRoundToTheSideThatIsAsked) {
  EXPECT_EQ(decimal_below(Rational(40, 11), 4), "3.6363");
  EXPECT_EQ(decimal_above(Rational(40, 11), 4), "3.6364");
  EXPECT_EQ(decimal_below(Rational(-1, 3), 2), "-0.34");
  EXPECT_EQ(decimal_above(Rational(-1, 3), 2), "-0.33");
  EXPECT_EQ(decimal_below(Rational(7), 0), "7");
  EXPECT_EQ(decimal_above(Rational(1, 20), 2), "0.05");
}

}  // namespace
}  // namespace zenosphere
