#include "engine/neighbour_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "model/archive.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Spheres at their start, and who is near.
template <int Dim>
struct Crowd {
  Crowd(const ShearBox<Dim, double>& box, Configuration<Dim, double> start)
      : spheres(box, std::move(start), {}), search(spheres) {}

  std::span<const Neighbour> neighbours(std::int32_t i) const {
    return search.neighbours(spheres, i);
  }

  Spheres<Dim, double> spheres;
  NeighbourSearch<Dim, double> search;
};

TEST(NeighbourSearch, FindsSpheresAcrossAPeriodicFaceButNotAcrossWalls) {
  const Configuration<1, double> ends{{{0.6}, {3.9}}, {{0}, {0}}};
  const Crowd<1> ring(ShearBox<1, double>({5}, 0, 2.5), ends);
  ASSERT_EQ(ring.neighbours(0).size(), 1u);
  EXPECT_NEAR(ring.spheres.motion(0, ring.neighbours(0)[0], 0).dr[0], -1.7,
              1e-15);  // 3.9 - 5 - 0.6
  const Neighbour other = ring.search.neighbour(ring.spheres, 0, 1, 0);
  EXPECT_NEAR(ring.spheres.motion(0, other, 0).dr[0], -1.7, 1e-15);
  const Crowd<1> line(ShearBox<1, double>({5}, 0, 2, 0), ends);
  EXPECT_EQ(line.neighbours(0).size(), 0u);
}

/// Where the images of a place are in a plain periodic box, the place itself among them.
std::vector<Vec<3, double>> images(const Vec<3, double>& sides) {
  std::vector<Vec<3, double>> all;
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      for (const int z : {-1, 0, 1}) all.push_back({{x * sides[0], y * sides[1], z * sides[2]}});
    }
  }
  return all;
}

/// Every pair whose reference positions are so near that they can touch while their lists last, in
/// every image.
TEST(NeighbourSearch, ListsWhomSpheresCanTouch) {
  for (const double shear_rate : {0.0, 1.0}) {
    for (const double side : {2.1, 3.7, 6.3}) {
      const Vec<3, double> sides{{side, side, side}};
      const ShearBox<3, double> box(sides, shear_rate);
      const int count = static_cast<int>(0.3 * side * side * side);
      const auto start = support::random_gas(count, sides, 1, 3);
      const ListRange list_range = list_range_in(box, count);
      const Crowd<3> crowd(box, start);
      const double distance = 1 + 2 * list_range.reach;
      for (std::int32_t i = 0; i < count; ++i) {
        std::multiset<std::int32_t> expected;
        for (std::int32_t j = 0; j < count; ++j) {
          if (j == i) continue;
          const auto dr = start.positions[static_cast<std::size_t>(j)] -
                          start.positions[static_cast<std::size_t>(i)];
          for (const Vec<3, double>& image : images(sides)) {
            if (std::sqrt(dot(dr + image, dr + image)) < distance) expected.insert(j);
          }
        }
        std::multiset<std::int32_t> listed;
        for (const Neighbour neighbour : crowd.neighbours(i)) listed.insert(neighbour.sphere());
        for (const std::int32_t j : expected) EXPECT_GE(listed.count(j), expected.count(j));
        if (shear_rate == 0) {  // a margin of grains
          EXPECT_LE(listed.size(), expected.size() + 2);
        }
      }
    }
  }
}

/// Whether each sphere sees all that touch it, or nearly so.
void expect_close_ones_seen(const Crowd<3>& crowd, const Configuration<3, double>& start,
                            const Vec<3, double>& sides) {
  for (std::int32_t i = 0; i < crowd.spheres.count(); ++i) {
    std::multiset<std::int32_t> seen;
    for (const Neighbour neighbour : crowd.neighbours(i)) seen.insert(neighbour.sphere());
    for (std::int32_t j = 0; j < crowd.spheres.count(); ++j) {
      const auto dr = start.positions[static_cast<std::size_t>(j)] -
                      start.positions[static_cast<std::size_t>(i)];
      for (const Vec<3, double>& image : images(sides)) {
        if (j == i || !(dot(dr + image, dr + image) < 1.01)) continue;
        EXPECT_EQ(seen.count(j), 1u);
      }
    }
  }
}

TEST(NeighbourSearch, LooksByCellsInADiluteGasUntilItIsACrowd) {
  const double side = 17.4;  // solids volume fraction 0.1
  const Vec<3, double> sides{{side, side, side}};
  const double width = fitting_cell_width({sides.components, 1000});
  const ShearBox<3, double> box(sides, 1, width);
  auto start = support::random_gas(1000, sides, 1, 3);
  start.positions[1] = start.positions[0];  // a pair that is close in any case
  start.positions[1][2] += start.positions[0][2] < side / 2 ? 1 : -1;
  Crowd<3> crowd(box, start);
  EXPECT_TRUE(crowd.search.looks_by_cells());
  expect_close_ones_seen(crowd, start, sides);
  crowd.search.renew_in_crowd(crowd.spheres, 0);
  EXPECT_FALSE(crowd.search.looks_by_cells());
  expect_close_ones_seen(crowd, start, sides);
}

TEST(NeighbourSearch, RefusesArchivedFacesThatThereAreNot) {
  const double side = 17.4;
  const Vec<3, double> sides{{side, side, side}};
  const ShearBox<3, double> box(sides, 1, fitting_cell_width({sides.components, 1000}));
  Crowd<3> crowd(box, support::random_gas(1000, sides, 1, 3));
  ASSERT_TRUE(crowd.search.looks_by_cells());
  for (std::int32_t i = 0; i < 1000; ++i) crowd.search.plan_renewal(crowd.spheres, i, 0, never);
  ArchiveWriter writer;
  crowd.search.archive_to(writer);
  const auto is_refused = [&](const Bytes& bytes) {
    try {
      ArchiveReader archive(bytes);
      const NeighbourSearch<3, double> search(crowd.spheres, archive);
      archive.require_end();
      return false;
    } catch (const ArchiveError&) {
      return true;
    }
  };
  const Bytes bytes = writer.release();
  EXPECT_FALSE(is_refused(bytes));
  for (const int face : {-128, -4, 4, 127}) {
    Bytes changed = bytes;
    changed.back() = static_cast<std::uint8_t>(face);
    EXPECT_TRUE(is_refused(changed));
  }
  Bytes longer = bytes;
  ++longer[1];  // their number begins behind what tells that there are no lists
  longer.push_back(0);
  EXPECT_TRUE(is_refused(longer));
}

/// Rods that fly on together at a speed of 2, so far apart, around a ring.
class FlyingRods {
 public:
  FlyingRods(int count, double apart)
      : box({count * apart}, 0, 3),
        list_range(list_range_in(box, count)),
        rods(box, start(count)) {}

  double renewal_time(std::int32_t i, double when) {
    return rods.search.plan_renewal(rods.spheres, i, when, never);
  }
  void renew(std::int32_t i, double when, double meeting) {
    rods.search.renew(rods.spheres, i, when, meeting);
  }
  double place(std::int32_t i, double when) const { return rods.spheres.position_at(i, when)[0]; }

  const ShearBox<1, double> box;
  const ListRange list_range;
  Crowd<1> rods;

 private:
  Configuration<1, double> start(int count) const {
    Configuration<1, double> start;
    for (int i = 0; i < count; ++i) {
      start.positions.push_back({{1 + i * box.sides()[0] / count}});
      start.velocities.push_back({{2}});
    }
    return start;
  }
};

TEST(NeighbourSearch, RenewsAListWhereItsSphereLeavesItsBall) {
  FlyingRods ring(20, 1.5);
  const double reach = ring.list_range.reach;
  EXPECT_NEAR(ring.renewal_time(0, 0), reach / 2, 1e-3);
  ring.renew(19, 1.2, never);  // 29.5 + 2.4 is through the face
  EXPECT_NEAR(ring.place(19, 1.2), 1.9, 1e-14);
  EXPECT_EQ(ring.rods.spheres[19].position[0], -0.5);  // stored for time 0, as before
  EXPECT_NEAR(ring.renewal_time(19, 1.2), 1.2 + reach / 2, 1e-3);
}

TEST(NeighbourSearch, KeepsAListForLongerWhereSpheresAreManyAndFarApart) {
  FlyingRods ring(100, 6);
  ASSERT_TRUE(ring.list_range.is_dilute);
  const double reach = ring.list_range.reach;
  // Through the middle of the ball, if there is no sphere; else to where they meet, and no further.
  ring.renew(2, 1.2, never);
  EXPECT_NEAR(ring.renewal_time(2, 1.2), 1.2 + 1.9 * reach / 2, 1e-3);
  ring.renew(2, 1.2, 1.3);
  EXPECT_NEAR(ring.renewal_time(2, 1.2), 1.3 + reach / 2, 1e-3);
  ring.renew(2, 1.2, 1.1);  // a meeting that is late by rounding
  EXPECT_NEAR(ring.renewal_time(2, 1.2), 1.2 + reach / 2, 1e-3);
  EXPECT_FALSE(FlyingRods(99, 6).list_range.is_dilute);
  EXPECT_FALSE(FlyingRods(100, 1.5).list_range.is_dilute);
}

TEST(NeighbourSearch, GivesASphereTheCellOfItsReferencePosition) {
  FlyingRods ring(100, 6);
  ring.renew(99, 2.2, never);  // at 599.4, and soon through the face
  EXPECT_EQ(ring.rods.spheres[99].cell, 0);
  EXPECT_NEAR(ring.place(99, 2.2), -0.6, 1e-12);
  EXPECT_NEAR(ring.rods.spheres.configuration(0, 2.2).positions[99][0], 599.4, 1e-12);
}

TEST(NeighbourSearch, RenewsAListHalfAUnitOfShearLater) {
  const ShearBox<2, double> box({20, 20}, 0.5, 2);
  Crowd<2> crowd(box, {{{5, 10}}, {{0, 0}}});
  EXPECT_NEAR(crowd.search.plan_renewal(crowd.spheres, 0, 0, never), box.clock_unit() / 2, 1e-6);
}

TEST(NeighbourSearch, FindsNobodyBeyondTheWallsHoweverNarrowTheBox) {
  // One cell between the walls, seven times narrower than the distance of neighbours.
  const ShearBox<2, double> strip({1.2, 1000}, 0, 9, 0);
  const Configuration<2, double> start{{{0.6, 10}, {0.6, 14}, {0.6, 500}},
                                       {{0, 0}, {0, 0}, {0, 0}}};
  const Crowd<2> crowd(strip, start);
  ASSERT_GT(list_range_in(strip, 3).distance, 7 * strip.cell_width()[0]);
  ASSERT_EQ(crowd.neighbours(0).size(), 1u);
  EXPECT_EQ(crowd.neighbours(0)[0], Neighbour(1, PeriodicImage()));
  EXPECT_EQ(crowd.neighbours(2).size(), 0u);
}

}  // namespace
}  // namespace zenosphere
