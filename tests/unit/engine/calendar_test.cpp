#include "engine/calendar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::int32_t no_sphere = Calendar<double>::none;

/// The same calendar the simple way.
class Reference {
 public:
  explicit Reference(std::int32_t size) : times_(static_cast<std::size_t>(size), never) {}

  void schedule(std::int32_t id, double time) {
    auto& old = times_[static_cast<std::size_t>(id)];
    const auto [begin, end] = events_.equal_range(old);
    for (auto event = begin; event != end; ++event) {
      if (event->second == id) {
        events_.erase(event);
        break;
      }
    }
    old = time;
    if (time < never) events_.emplace(time, id);
  }

  /// Of equal times, the lowest number.
  std::int32_t earliest() const {
    if (events_.empty()) return no_sphere;
    std::int32_t lowest = std::numeric_limits<std::int32_t>::max();
    const auto [begin, end] = events_.equal_range(events_.begin()->first);
    for (auto event = begin; event != end; ++event) lowest = std::min(lowest, event->second);
    return lowest;
  }

  void shift_times(double span) {
    events_.clear();
    for (std::size_t id = 0; id < times_.size(); ++id) {
      times_[id] -= span;
      if (times_[id] < never) events_.emplace(times_[id], static_cast<std::int32_t>(id));
    }
  }

  double time(std::int32_t id) const { return times_[static_cast<std::size_t>(id)]; }

 private:
  std::vector<double> times_;
  std::multimap<double, std::int32_t> events_;
};

/// A new time for an event, seen from `now`, of every kind that a run can bring.
double some_time(support::Dice& dice, double now) {
  switch (dice.below(12)) {
    case 0:
      return never;
    case 1:
      return now;  // at once
    case 2:
      return now - dice.between(0, 1e-12);  // slightly in the past
    case 3:
      return now - dice.between(0, 1);  // far in the past
    case 4:
      return now + 0.25 * dice.below(8);  // equal times
    case 5:
      return std::ceil(now) + 1;  // a cluster of many equal times
    case 6:
      return now + dice.between(0, 1e-9);  // a crowd in one bin
    case 7:
      return now + 1e12 * dice.between(0.5, 1);  // huge outliers
    default:
      return now + dice.between(0, 1);
  }
}

void compare_random_operations(std::int32_t size, int operations, std::uint64_t seed) {
  support::Dice dice(seed);
  Calendar<double> calendar(size);
  Reference reference(size);
  double now = 0;
  for (int n = 0; n < operations; ++n) {
    const std::int32_t id = dice.below(size);
    const double time = some_time(dice, now);
    calendar.schedule(id, time);
    reference.schedule(id, time);
    if (dice.below(1000) == 0) {
      calendar.shift_times(0.75);
      reference.shift_times(0.75);
      now -= 0.75;
    }
    if (dice.below(3) == 0) continue;
    // As a run does: the earliest event is done and replaced.
    const std::int32_t next = calendar.earliest();
    ASSERT_EQ(next, reference.earliest()) << "operation " << n;
    if (next == no_sphere) continue;
    ASSERT_EQ(calendar.time(next), reference.time(next));
    now = std::min(std::max(now, calendar.time(next)), 1e9);
    const double later = some_time(dice, now);
    calendar.schedule(next, later);
    reference.schedule(next, later);
  }
  // Empties it, so that every event comes out, the outliers too.
  for (std::int32_t left = calendar.earliest(); left != no_sphere; left = calendar.earliest()) {
    ASSERT_EQ(left, reference.earliest());
    calendar.schedule(left, never);
    reference.schedule(left, never);
  }
  EXPECT_EQ(reference.earliest(), no_sphere);
}

TEST(Calendar, AgreesWithASortedMapOverRandomOperations) {
  compare_random_operations(1000, 100000, 1);
  compare_random_operations(64, 100000, 2);
}

TEST(Calendar, AgreesWithASortedMapWhereBinsAreInGroups) {
  compare_random_operations(25'000, 200'000, 4);
}

TEST(Calendar, AgreesWithASortedMapForFewSpheres) {
  for (const std::int32_t size : {1, 2, 3, 5}) compare_random_operations(size, 20000, 3);
}

TEST(Calendar, IsEmptyAtFirstAndAfterItsEventsAreTakenBack) {
  Calendar<double> calendar(3);
  EXPECT_EQ(calendar.earliest(), no_sphere);
  EXPECT_EQ(calendar.time(1), never);
  calendar.schedule(1, 4);
  EXPECT_EQ(calendar.earliest(), 1);
  calendar.schedule(1, never);
  EXPECT_EQ(calendar.earliest(), no_sphere);
}

TEST(Calendar, GivesEqualTimesInTheOrderOfTheNumbers) {
  Calendar<double> calendar(100);
  for (std::int32_t id = 99; id >= 0; --id) calendar.schedule((id * 37) % 100, 2.5);
  for (std::int32_t id = 0; id < 100; ++id) {
    ASSERT_EQ(calendar.earliest(), id);
    calendar.schedule(id, never);
  }
}

TEST(Calendar, TakesAnEventBeforeTheOneThatJustCame) {
  Calendar<double> calendar(3);
  calendar.schedule(0, 1);
  calendar.schedule(1, 2);
  EXPECT_EQ(calendar.earliest(), 0);
  calendar.schedule(2, -5);
  EXPECT_EQ(calendar.earliest(), 2);
}

TEST(Calendar, TakesMoreEventsThanABinHasRoomFor) {
  constexpr std::int32_t size = 1000;
  support::Dice dice(6);
  Calendar<double> calendar(size);
  std::vector<double> times;
  for (std::int32_t id = 0; id < size; ++id) {
    times.push_back(id % 2 == 0 ? dice.between(0, 10) : 4 + dice.between(0, 1e-9));
    calendar.schedule(id, times.back());
  }
  std::sort(times.begin(), times.end());
  for (const double time : times) {
    const std::int32_t next = calendar.earliest();
    ASSERT_EQ(calendar.time(next), time);
    calendar.schedule(next, never);
  }
  EXPECT_EQ(calendar.earliest(), Calendar<double>::none);
}

TEST(Calendar, LinesUpTheNextEventsInOrder) {
  constexpr std::int32_t size = 25'000;
  support::Dice dice(5);
  Calendar<double> calendar(size);
  std::vector<double> times;
  for (std::int32_t id = 0; id < size; ++id) {
    times.push_back(dice.between(0, 1));
    calendar.schedule(id, times.back());
  }
  std::sort(times.begin(), times.end());
  for (std::size_t done = 0; done < 1000; ++done) {
    const std::int32_t next = calendar.earliest();
    calendar.line_up(40);
    ASSERT_GE(calendar.line().size(), 40u);
    ASSERT_EQ(calendar.passed(), static_cast<std::int64_t>(done));
    for (std::size_t k = 0; k < 40; ++k) ASSERT_EQ(calendar.line()[k].time, times[done + k]);
    calendar.schedule(next, never);
  }
}

TEST(Calendar, FindsTheCrowdBehindAHugeOutlierAndTheOutlierBehindTheCrowd) {
  Calendar<double> calendar(200);
  calendar.schedule(0, 1e300);
  for (std::int32_t id = 1; id < 200; ++id) calendar.schedule(id, 1e-9 * id);
  for (std::int32_t id = 1; id < 200; ++id) {
    ASSERT_EQ(calendar.earliest(), id);
    calendar.schedule(id, never);
  }
  EXPECT_EQ(calendar.earliest(), 0);
}

TEST(Calendar, SetBackMovesEveryEventAndNoInfinity) {
  Calendar<double> calendar(3);
  calendar.schedule(0, 1.5);
  calendar.schedule(1, 1.25);
  EXPECT_EQ(calendar.earliest(), 1);
  calendar.shift_times(1);
  EXPECT_EQ(calendar.time(0), 0.5);
  EXPECT_EQ(calendar.time(1), 0.25);
  EXPECT_EQ(calendar.time(2), never);
  EXPECT_EQ(calendar.earliest(), 1);
  calendar.schedule(2, 0.125);  // before the times that were current when they were shifted
  EXPECT_EQ(calendar.earliest(), 2);
}

}  // namespace
}  // namespace zenosphere
