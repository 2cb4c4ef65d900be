#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/start.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Box;
using support::Gas;
using support::Record;

/// All numbers of a record, floating-point ones as their bits.
std::vector<std::int64_t> bits(const Record& record) {
  std::vector<std::int64_t> all{record.number,      static_cast<std::int64_t>(record.time.units),
                                record.i,           record.j,
                                record.overlapping, record.absorbed};
  for (const double value :
       {record.time.remainder, record.flight, record.impact.normal[0], record.impact.normal[1],
        record.impact.normal[2], record.impact.distance, record.impact.normal_speed,
        record.impact.impulse, record.gap_before}) {
    all.push_back(std::bit_cast<std::int64_t>(value));
  }
  return all;
}

Gas fresh_gas() {
  const double side = box_side<3>(100, 0.3);
  return Gas(Box({side, side, side}, 1),
             make_start<3>({Arrangement::random, 100, 1, 11}, support::cube(side)), {0.8});
}

TEST(Determinism, TheSameStartGivesTheSameRecordsBitForBit) {
  Gas one = fresh_gas();
  Gas other = fresh_gas();
  for (int n = 0; n < 3000; ++n) {
    ASSERT_EQ(bits(support::next(one)), bits(support::next(other))) << "collision " << n + 1;
  }
  EXPECT_GE(one.now().units, 2);
}

TEST(Determinism, StopsOnTheWayDoNotChangeARecord) {
  Gas straight = fresh_gas();
  Gas halting = fresh_gas();
  double until = 0;
  for (int n = 0; n < 1000; ++n) {
    const Record expected = support::next(straight);
    auto collision = halting.next_collision(until);
    for (; !collision; collision = halting.next_collision(until)) {
      // A look at the state between the events must leave no trace either.
      EXPECT_EQ(halting.configuration().positions.size(), 100u);
      until += 0.0007;
    }
    ASSERT_EQ(bits(*collision), bits(expected)) << "collision " << n + 1;
  }
}

}  // namespace
}  // namespace zenosphere
