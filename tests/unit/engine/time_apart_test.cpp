#include "engine/time_apart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace zenosphere {
namespace {

constexpr double open = std::numeric_limits<double>::infinity();

/// The first contact up to `longest`, from all images that come near, one after the other.
template <int Dim>
double first_contact(const StraightFlight<Dim>& flight, double longest) {
  const double v2 = dot(flight.velocity, flight.velocity);
  double first = open;
  const double step = 0.4 / std::sqrt(v2);
  for (double time = 0; time < longest && first == open; time += step) {
    Vec<Dim, double> place = flight.displacement + flight.velocity * time;
    for (int axis = 0; axis < Dim; ++axis) {
      const double period = flight.periods[static_cast<std::size_t>(axis)];
      if (std::isfinite(period)) place[axis] -= period * std::round(place[axis] / period);
    }
    const double b = dot(place, flight.velocity);
    const double root = b * b - v2 * (dot(place, place) - 1);
    if (b >= 0 || root < 0) continue;
    const double contact = time + (-b - std::sqrt(root)) / v2;
    if (contact < time + step) first = std::max(contact, 0.0);
  }
  return first;
}

template <int Dim>
StraightFlight<Dim> random_flight(std::mt19937_64& random, double slant, bool is_closed) {
  std::uniform_real_distribution<double> unit(0, 1);
  StraightFlight<Dim> flight{};
  do {
    for (int axis = 0; axis < Dim; ++axis) {
      const double side = 5 + 10 * unit(random);
      flight.periods[static_cast<std::size_t>(axis)] = side;
      flight.displacement[axis] = side * (unit(random) - 0.5);
      flight.velocity[axis] = (unit(random) - 0.5) * (axis > 0 ? slant : 1);
    }
  } while (dot(flight.displacement, flight.displacement) < 1.1);
  if (is_closed) flight.periods[Dim - 1] = open;
  flight.speed = std::sqrt(dot(flight.velocity, flight.velocity));
  return flight;
}

template <int Dim>
void expect_agreement(double slant, bool is_closed) {
  std::mt19937_64 random(7);
  int contacts = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const auto flight = random_flight<Dim>(random, slant, is_closed);
    const double longest = 2e3 / std::sqrt(dot(flight.velocity, flight.velocity));
    const double expected = first_contact(flight, longest);
    const double apart = time_apart(flight, open, 1000);
    EXPECT_LE(apart, expected * (1 + 1e-9)) << trial;
    if (!(expected < longest)) {
      EXPECT_GE(apart, longest * (1 - 1e-9)) << trial;
      continue;
    }
    ++contacts;
    // The margin is below 1e-7 in a flight as short: a contact that grazes begins 5e-4 before.
    EXPECT_GE(apart, expected - 1e-3 * longest / 2e3) << trial;
  }
  EXPECT_GE(contacts, is_closed ? 20 : 100);
}

TEST(TimeApart, AgreesWithLookingAtEveryImage) {
  for (const double slant : {1.0, 0.1, 0.001}) {
    expect_agreement<2>(slant, false);
    expect_agreement<2>(slant, true);
    expect_agreement<3>(slant, true);
  }
  expect_agreement<3>(1, false);
  expect_agreement<1>(1, false);
}

TEST(TimeApart, CrossesMillionsOfBoxesInOneStep) {
  // Across by 5 less a diameter at 1e-7: 40 000 000, when the image is touched from behind; the
  // plane is that of a multiple of 10.
  const double time = time_apart<2>({{5, 5}, {-1, -1e-7}, 1, {10, 10}}, open, 100);
  EXPECT_NEAR(time, 4e7, 10);
  // The last of the distance is told from a miss by fewer diameters: 4e12 in steps.
  EXPECT_GT(time_apart<2>({{5, 1 + 1e-4}, {-1, -1e-12}, 1, {10, 10}}, open, 100), 1e6);
  // Across by 4 along z for good.
  EXPECT_GT(time_apart<3>({{5, 5, 4}, {1, 1e-8, 0}, 1, {10, 10, 10}}, open, 100), 1e11);
}

TEST(TimeApart, CountsThePlanesOfALongSideWhereThoseOfAShortOneTellNothing) {
  // A box along y is crossed in 3.5, one along x in 2.5, while 2.5e8 diameters pass along y: what
  // comes near within two diameters along x could be anywhere. At 1 they are as high as each other,
  // and 6 + 4 along x.
  EXPECT_NEAR((time_apart<2>({{6, -1e8}, {4, 1e8}, 1e8, {10, 3.5e8}}, 10, 100)), 1, 1e-6);
}

TEST(TimeApart, NeverEndsWhereAllImagesAreAcross) {
  EXPECT_GE(time_apart<2>({{3, 1.5}, {1, 0}, 1, {8, 8}}, open, 100), 0.9 * longest_foreseen);
  EXPECT_EQ(time_apart<2>({{3, 1.5}, {0, 0}, 1, {8, 8}}, open, 100), open);
  EXPECT_LT(time_apart<2>({{3, 0.5}, {-1, 0}, 1, {8, 8}}, open, 100), 3);
}

TEST(TimeApart, SaysNothingOfNarrowBoxes) {
  EXPECT_EQ(time_apart<2>({{1.2, 1.2}, {1, 0.3}, 1, {2.5, 2.5}}, open, 100), 0);
}

}  // namespace
}  // namespace zenosphere
