#include "engine/time_apart_sheared.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace zenosphere {
namespace {

/// The first moment at which an image is nearer than a diameter, by small steps through all images
/// that may be; infinity where none is up to `longest`.
template <int Dim>
double first_contact(const ShearedFlight<Dim>& flight, double longest) {
  constexpr double step = 1e-3;
  for (double time = 0; time < longest; time += step) {
    Vec<Dim, double> place = flight.displacement + flight.velocity * time;
    const double boxes = std::round(place[1] / flight.sides[1]);
    place[1] -= boxes * flight.sides[1];
    place[0] -= boxes * (flight.offset + flight.slide * time);
    for (int axis = 0; axis < Dim; ++axis) {
      if (axis != 1)
        place[axis] = std::remainder(place[axis], flight.sides[static_cast<std::size_t>(axis)]);
    }
    if (dot(place, place) < 1) return time;
  }
  return std::numeric_limits<double>::infinity();
}

template <int Dim>
ShearedFlight<Dim> random_flight(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  ShearedFlight<Dim> flight{};
  for (int axis = 0; axis < Dim; ++axis) {
    const double side = 6 + 6 * unit(random);
    flight.sides[static_cast<std::size_t>(axis)] = side;
    flight.displacement[axis] = side * (unit(random) - 0.5);
    flight.velocity[axis] = 2 * unit(random) - 1;
  }
  flight.offset = flight.sides[0] * (unit(random) - 0.5);
  flight.slide = 0.3 * unit(random);
  return flight;
}

template <int Dim>
void expect_agreement() {
  std::mt19937_64 random(3);
  constexpr double longest = 60;
  int contacts = 0, misses = 0, told = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto flight = random_flight<Dim>(random);
    if (dot(flight.displacement, flight.displacement) < 1.2) continue;
    const double expected = first_contact(flight, longest);
    const double apart = time_apart_sheared(flight, longest);
    EXPECT_LE(apart, expected) << trial;
    contacts += expected < longest;
    misses += !(expected < longest);
    told += !(expected < longest) && apart == longest;
  }
  EXPECT_GE(contacts, 5);
  EXPECT_GE(misses, 5);
  EXPECT_GE(told, misses / 4);  // what is near, but not a diameter, is not told apart
}

TEST(TimeApartSheared, IsNeverLaterThanTheFirstContact) {
  expect_agreement<2>();
  expect_agreement<3>();
}

TEST(TimeApartSheared, LastsUntilTheNextImageIsAsHigh) {
  // 4 below, at 1e-6: less the diameter of 1 + 2^-20.
  EXPECT_NEAR((time_apart_sheared<2>({{3, -4}, {0.5, 1e-6}, {10, 10}, 0, 10}, 1e9)), 3e6, 1e4);
  EXPECT_NEAR((time_apart_sheared<2>({{3, -4}, {0.5, -1e-6}, {10, 10}, 0, 10}, 1e9)), 5e6, 1e4);
  EXPECT_EQ((time_apart_sheared<2>({{3, -4}, {0.5, 0}, {10, 10}, 0, 10}, 1e9)), 1e9);
}

TEST(TimeApartSheared, TellsAtOneHeightWhoMeetsAlongTheFlow) {
  // 3 - 1 at the speed 0.5, the other way 10 - 3 - 1; in space past each other at 2 along z.
  EXPECT_NEAR((time_apart_sheared<2>({{3, 0.5}, {-0.5, 0}, {10, 10}, 0, 10}, 1e9)), 4, 1e-4);
  EXPECT_NEAR((time_apart_sheared<2>({{3, 0.5}, {0.5, 0}, {10, 10}, 0, 10}, 1e9)), 12, 1e-4);
  EXPECT_EQ((time_apart_sheared<2>({{3, 0.5}, {0, 0}, {10, 10}, 0, 10}, 1e9)), 1e9);
  EXPECT_EQ((time_apart_sheared<3>({{3, 0.5, 2}, {-0.5, 0, 0}, {10, 10, 10}, 0, 10}, 1e9)), 1e9);
}

TEST(TimeApartSheared, FollowsImagesThatPassInStep) {
  // One box higher every 10, and half a box further along z: all pass at 2.5 or -2.5, to a half.
  EXPECT_EQ((time_apart_sheared<3>({{3, 0, 2.5}, {0, -1, 0.5}, {10, 10, 10}, 0, 10}, 5e3)), 5e3);
  EXPECT_LT((time_apart_sheared<3>({{3, 0, 2.5}, {0, -1, 0.51}, {10, 10, 10}, 0, 10}, 5e3)), 2e3);
}

TEST(TimeApartSheared, EndsWhereTwoAreAbreastAndOneRises) {
  // Above each other in every image along the flow: a diameter less 2^-20 below is touched.
  EXPECT_NEAR((time_apart_sheared<3>({{0, -4, 0}, {0, 1, 0}, {10, 10, 10}, 0, 0}, 1e9)), 3, 1e-4);
}

}  // namespace
}  // namespace zenosphere
