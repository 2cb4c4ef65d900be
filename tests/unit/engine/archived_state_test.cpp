#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "engine/list_range.hpp"
#include "engine/simulation.hpp"
#include "engine/start.hpp"
#include "model/archive.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

/// A system in motion: what is archived in the middle of it.
template <int D, class R>
struct Example {
  static constexpr int Dim = D;
  using Real = R;

  static ShearBox<Dim, Real> box(double side, double shear_rate, bool walled) {
    Vec<Dim, Real> sides;
    for (int axis = 0; axis < Dim; ++axis) sides[axis] = Real(side);
    return {sides, Real(shear_rate), 1, walled ? std::optional(Dim - 1) : std::nullopt};
  }

  static Configuration<Dim, Real> start(int spheres, const ShearBox<Dim, Real>& box,
                                        const Real& offset = 0) {
    Random random(3);
    Configuration<Dim, Real> start;
    start.offset = offset;
    const int side = static_cast<int>(box.sides()[0]) - 1;
    for (int i = 0; i < spheres; ++i) {  // on a lattice: many equal times, which must keep order
      Vec<Dim, Real> place, velocity;
      for (int axis = 0, rest = i; axis < Dim; ++axis, rest /= side) {
        place[axis] = Real(0.75 + 1.1 * (rest % side));
        velocity[axis] = Real(random.normal());
      }
      start.positions.push_back(place);
      start.velocities.push_back(velocity);
    }
    return start;
  }
};

template <class Gas>
Bytes archived(const Gas& gas) {
  ArchiveWriter archive;
  gas.archive_to(archive);
  return archive.release();
}

/// Some collisions further, or to the end where a gas comes to rest before.
template <class Gas>
void run(Gas& gas, std::int64_t collisions) {
  const std::int64_t end = gas.collisions() + collisions;
  while (gas.collisions() < end && gas.time() < 300 && !gas.is_at_rest()) gas.next_collision(300);
}

template <class S>
class ArchivedState : public ::testing::Test {
 protected:
  using Real = typename S::Real;
  using Gas = Simulation<S::Dim, Real>;

  void expect_same_future(const ShearBox<S::Dim, Real>& box, OverlapRule rule,
                          const Surroundings<S::Dim, Real>& surroundings, const Real& offset = 0) {
    const ContactRules<Real> rules{Real(0.4), rule};
    Gas gas(box, S::start(S::Dim == 1 ? 6 : 24, box, offset), rules, surroundings);
    for (int part = 0; part < 3; ++part) {
      run(gas, 97);
      const Bytes bytes = archived(gas);
      ArchiveReader archive(bytes);
      Gas again(box, rules, surroundings, archive);
      archive.require_end();
      ASSERT_EQ(archived(again), bytes);
      run(gas, 97);
      run(again, 97);
      ASSERT_EQ(archived(again), archived(gas));
    }
  }
};
using Systems = ::testing::Types<Example<1, double>, Example<2, double>, Example<3, double>,
                                 Example<2, Extended>, Example<3, Quad>, Example<2, Digits>>;
TYPED_TEST_SUITE(ArchivedState, Systems);

TYPED_TEST(ArchivedState, CoolingGasGoesOnBitForBit) {
  for (const auto rule : {OverlapRule::rewind, OverlapRule::immediate, OverlapRule::guarded}) {
    this->expect_same_future(TypeParam::box(8, 0, false), rule, {});
  }
}

TYPED_TEST(ArchivedState, ShearedGasGoesOnBitForBit) {
  if constexpr (TypeParam::Dim > 1) {
    this->expect_same_future(TypeParam::box(8, 1.5, false), OverlapRule::rewind, {});
  }
}

TYPED_TEST(ArchivedState, GasWhoseImagesAreDisplacedGoesOnBitForBit) {
  using Number = typename TypeParam::Real;
  if constexpr (TypeParam::Dim > 1) {
    for (const double shear_rate : {0.0, 1.5}) {
      this->expect_same_future(TypeParam::box(8, shear_rate, false), OverlapRule::rewind, {},
                               Number(-2.7));
    }
  }
}

TYPED_TEST(ArchivedState, SpheresThatFallBetweenWallsGoOnBitForBit) {
  using Number = typename TypeParam::Real;
  constexpr int axis = TypeParam::Dim - 1;
  Surroundings<TypeParam::Dim, Number> surroundings;
  surroundings.acceleration[axis] = Number(-0.3);
  surroundings.walls = Walls<Number>{.axis = axis, .restitution = Number(0.9)};
  this->expect_same_future(TypeParam::box(8, 0, true), OverlapRule::immediate, surroundings);
}

// One that goes on from an archive has prefetched nothing yet, and is asked to prefetch more.
TEST(DiluteGas, GoesOnBitForBit) {
  const double side = 17.4;  // solids volume fraction 0.1: spheres are looked for by cells
  const Vec<3, double> sides{{side, side, side}};
  for (const double shear_rate : {0.0, 1.0}) {
    const double width = fitting_cell_width({sides.components, 1000});
    const ShearBox<3, double> box(sides, shear_rate, width);
    const ContactRules<double> rules{0.9};
    Simulation<3, double> gas(box, support::random_gas(1000, sides, 1, 3), rules);
    run(gas, 1500);
    const Bytes bytes = archived(gas);
    ArchiveReader archive(bytes);
    Simulation<3, double> again(box, rules, {}, archive);
    archive.require_end();
    ASSERT_EQ(archived(again), bytes);
    run(gas, 1500);
    run(again, 1500);
    ASSERT_EQ(archived(again), archived(gas));
    EXPECT_EQ(again.rebuilds(), gas.rebuilds());
  }
}

TEST(LargeSystem, WhatIsFetchedAheadLeavesNoTrace) {
  using Gas = Simulation<3, double>;
  constexpr std::int32_t spheres = 4 * 18 * 18 * 18;
  static_assert(spheres > most_spheres_in_cache);
  const double side = box_side<3>(spheres, 0.3);
  const ShearBox<3, double> box({side, side, side}, 1);
  const ContactRules<double> rules{.restitution = 0.9};
  Gas gas(box, make_start<3>({.spheres = spheres, .granular_temperature = 1}, box), rules);
  run(gas, 2 * spheres);
  const Bytes bytes = archived(gas);
  ArchiveReader archive(bytes);
  Gas again(box, rules, {}, archive);
  const std::vector<double> observed(spheres);
  again.prefetch_too(observed.data(), sizeof observed.front());
  run(gas, 2 * spheres);
  run(again, 2 * spheres);
  EXPECT_EQ(archived(again), archived(gas));
}

class HostileState : public ::testing::Test {
 protected:
  using Gas = Simulation<2, double>;
  using Setting = Example<2, double>;

  /// Whether the bytes are refused; where not, the state must at least be safe to go on with.
  bool is_refused(const Bytes& other) const {
    try {
      ArchiveReader archive(other);
      Gas gas(box, {}, {}, archive);
      archive.require_end();
      for (int call = 0; call < 20; ++call) gas.next_collision(5);
      return false;
    } catch (const ArchiveError&) {
      return true;
    }
  }

  ShearBox<2, double> box = Setting::box(8, 1, false);
  Bytes bytes = archived(Gas(box, Setting::start(24, box), {}));
};

TEST_F(HostileState, EveryTruncationIsRefused) {
  ASSERT_FALSE(is_refused(bytes));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_TRUE(is_refused({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}));
  }
}

TEST_F(HostileState, NoChangedByteDoesHarm) {
  int refused = 0;
  for (std::size_t place = 0; place < bytes.size(); ++place) {
    for (const int change : {0x01, 0x80, 0xff}) {
      Bytes changed = bytes;
      changed[place] = static_cast<std::uint8_t>(int{changed[place]} ^ change);
      refused += is_refused(changed);
    }
  }
  EXPECT_GT(refused, 100);  // cells, partners, exponents, lengths
}

TEST_F(HostileState, CountsAndPairsThatCannotBeAreRefused) {
  // Last come the number of overlaps ignored, the pair before which the run was stopped (none),
  // whether it is at rest, of rewinds two speeds, the collision of the next look, the earliest
  // time and the largest change (none yet), the stride of the clock, the events without a
  // collision, and the frame, which does not move.
  const auto with = [&](std::int64_t count, const std::optional<Gas::NextPair>& pair,
                        double fastest = 0, std::int64_t next_look = 0) {
    ArchiveWriter end;
    end(count, pair, false, fastest, 0.0, next_look, -std::numeric_limits<double>::infinity(), 0.0,
        1.0, std::int64_t{0}, Gas::Vector{}, Gas::Vector{}, Gas::Vector{}, Instant<double>{});
    const std::size_t replaced = end.bytes().size() - (pair ? sizeof(*pair) : 0);
    Bytes all(bytes.begin(), bytes.end() - static_cast<std::ptrdiff_t>(replaced));
    all.insert(all.end(), end.bytes().begin(), end.bytes().end());
    return all;
  };
  EXPECT_EQ(with(0, std::nullopt), bytes);
  EXPECT_TRUE(is_refused(with(std::numeric_limits<std::int64_t>::max(), std::nullopt)));
  EXPECT_FALSE(is_refused(with(0, Gas::NextPair{22, 23, 0})));
  EXPECT_TRUE(is_refused(with(0, Gas::NextPair{23, 24, 0})));  // there is no wall
  EXPECT_TRUE(is_refused(with(0, Gas::NextPair{-1, 1, 0})));
  EXPECT_TRUE(is_refused(with(0, std::nullopt, -1)));
  EXPECT_TRUE(is_refused(with(0, std::nullopt, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(is_refused(with(0, std::nullopt, 0, -1)));
}

}  // namespace
}  // namespace zenosphere
