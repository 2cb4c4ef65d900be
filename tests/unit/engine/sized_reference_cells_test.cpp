#include "engine/sized_reference_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "engine/list_range.hpp"
#include "engine/neighbour_search.hpp"
#include "support/gas.hpp"

namespace zenosphere {
namespace {

/// Radii from `least` to ten times that, few of them large.
std::vector<double> radii_of(int count, double least, support::Dice& dice) {
  std::vector<double> radii;
  for (int i = 0; i < count; ++i) radii.push_back(least * std::pow(10, dice.between(0, 1)));
  return radii;
}

template <int Dim>
class SizedBox {
 public:
  static constexpr double grain = 0.001;
  static constexpr int beyond = 300;  ///< grains

  SizedBox(int count, std::uint64_t seed, int whole_slide)
      : dice_(seed),
        cells_(sides()),
        radii_(radii_of(count, 0.08, dice_)),
        places_before_(cells_, grid(), radii_) {
    cells_.slide_to(whole_slide);
    for (std::int32_t i = 0; i < count; ++i) {
      cell_of_.push_back(dice_.below(cells_.count()));
      reference_of_.push_back(somewhere());
      insert(i);
    }
  }

  std::set<std::int32_t> found_by(std::int32_t i, int slid, int slide) {
    places_before_.remove(i, cell(i), reference(i));
    std::vector<Neighbour> nearby;
    const auto near = places_before_.find(cells_,
                                          {.sphere = i,
                                           .home = cells_.coordinates(cell(i)),
                                           .place = reference(i).place,
                                           .slid = {-slid, 0, slid},
                                           .slide = slide,
                                           .beyond = beyond},
                                          nearby);
    std::set<std::int32_t> found;
    for (const Neighbour neighbour : near) EXPECT_TRUE(found.insert(neighbour.sphere()).second);
    insert(i);
    return found;
  }

  /// The same by a look at all others.
  ///
  /// \param margin  of distances, grains
  std::set<std::int32_t> near(std::int32_t i, int slid, int slide, double margin) const {
    std::set<std::int32_t> found;
    const auto from = cells_.coordinates(cell(i));
    for (std::int32_t j = 0; j < static_cast<std::int32_t>(radii_.size()); ++j) {
      if (j == i) continue;
      const auto [steps, periods] = cells_.reached(from, cells_.coordinates(cell(j)));
      const int layers = SlidingCells<Dim>::layers(steps);
      if (std::abs(layers) > 1) continue;
      double square = 0;
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        double along = steps[axis] * grains + reference(j).place[axis] - reference(i).place[axis];
        if (axis == 0) {
          // The nearest image of a row of seven cells.
          along = std::remainder(along + layers * slid, sides()[0] * grains);
          along = std::max(0.0, std::abs(along) - (layers != 0 ? slide : 0));
        }
        square += along * along;
      }
      const double reach = (radius(i) + radius(j)) / grain + beyond + margin;
      if (square < reach * reach) found.insert(j);
    }
    return found;
  }

  void move(std::int32_t i) {
    places_before_.remove(i, cell(i), reference(i));
    cell_of_[static_cast<std::size_t>(i)] = dice_.below(cells_.count());
    reference_of_[static_cast<std::size_t>(i)] = somewhere();
    insert(i);
  }

 private:
  static constexpr int grains = 2000;

  static Steps<Dim> sides() {
    Steps<Dim> sides;
    sides.fill(4);
    sides[0] = 7;
    return sides;
  }
  static ReferenceGrid<Dim> grid() {
    ReferenceGrid<Dim> grid{.grain = grain, .volume = 1};
    grid.cell_grains.fill(grains);
    for (const int side : sides()) grid.volume *= side * grains * grain;
    return grid;
  }
  ReferencePosition somewhere() {
    ReferencePosition reference;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      reference.place[axis] = static_cast<std::int16_t>(dice_.below(grains + 1));
    }
    return reference;
  }
  void insert(std::int32_t i) { places_before_.insert(i, cell(i), reference(i)); }
  std::int32_t cell(std::int32_t i) const { return cell_of_[static_cast<std::size_t>(i)]; }
  const ReferencePosition& reference(std::int32_t i) const {
    return reference_of_[static_cast<std::size_t>(i)];
  }
  double radius(std::int32_t i) const { return radii_[static_cast<std::size_t>(i)]; }

  support::Dice dice_;
  SlidingCells<Dim> cells_;
  std::vector<double> radii_;
  SizedReferenceCells<Dim> places_before_;
  std::vector<std::int32_t> cell_of_;
  std::vector<ReferencePosition> reference_of_;
};

/// No sphere that is near is missed, and only what rounding lets seem so is taken besides.
template <int Dim>
void expect_same_found(int count, int whole_slide, int slid, int slide) {
  SizedBox<Dim> box(count, 7, whole_slide);
  std::size_t pairs = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    box.move((i * 37) % count);
    const auto found = box.found_by(i, slid, slide);
    const auto surely = box.near(i, slid, slide, 0);
    const auto perhaps = box.near(i, slid, slide, 20);  // two codes of 8 grains, and rounding
    EXPECT_TRUE(std::includes(found.begin(), found.end(), surely.begin(), surely.end()));
    EXPECT_TRUE(std::includes(perhaps.begin(), perhaps.end(), found.begin(), found.end()));
    pairs += surely.size();
  }
  EXPECT_GT(pairs, static_cast<std::size_t>(count));
}

TEST(SizedReferenceCells, FindWhoIsNearInSpace) { expect_same_found<3>(4000, 0, 0, 0); }

TEST(SizedReferenceCells, FindWhoIsNearInLayersThatSlide) {
  expect_same_found<3>(1000, 0, 1300, 300);
  expect_same_found<3>(1000, 3, 250, 250);
  expect_same_found<2>(300, 5, 1900, 400);
}

TEST(SizedReferenceCells, FindWhoIsNearInThePlaneAndOnALine) {
  expect_same_found<2>(500, 0, 0, 0);
  expect_same_found<1>(60, 0, 0, 0);
}

/// Spheres of ten to one, whose lists are those of the start: which can be touched while these
/// last.
template <int Dim>
void expect_all_on_lists(double side, double shear_rate) {
  support::Dice dice(3);
  Vec<Dim, double> sides;
  for (int axis = 0; axis < Dim; ++axis) sides[axis] = side;
  Configuration<Dim, double> start;
  const std::int32_t count = 300;
  for (const double radius : radii_of(count, 0.07, dice))
    start.grains.diameters.push_back(2 * radius);
  for (std::int32_t i = 0; i < count; ++i) {
    Vec<Dim, double> place;
    for (int axis = 0; axis < Dim; ++axis) place[axis] = dice.between(0, side);
    start.positions.push_back(place);
    start.velocities.push_back({});
  }
  const ShearBox<Dim, double> box(sides, shear_rate, 1.6);
  Spheres<Dim, double> spheres(box, start, {});
  const NeighbourSearch<Dim, double> search(spheres);
  for (std::int32_t i = 0; i < count; ++i) {
    std::set<std::int32_t> listed;
    for (const Neighbour neighbour : search.neighbours(spheres, i)) {
      listed.insert(neighbour.sphere());
    }
    for (std::int32_t j = 0; j < count; ++j) {
      if (j == i) continue;
      double square = 0;
      for (int axis = 0; axis < Dim; ++axis) {
        const double along = std::remainder(start.positions[static_cast<std::size_t>(j)][axis] -
                                                start.positions[static_cast<std::size_t>(i)][axis],
                                            side);
        square += along * along;
      }
      const double reach = spheres.sigma(i, j) + 2 * search.reach();
      if (square < reach * reach) {
        EXPECT_TRUE(listed.contains(j)) << i << " and " << j;
      }
      // Not much more: a code of size, and grains.
      if (shear_rate == 0 && square > (reach + 0.05) * (reach + 0.05)) {
        EXPECT_FALSE(listed.contains(j)) << i << " and " << j;
      }
    }
  }
}

TEST(SizedReferenceCells, PutOnListsWhomSpheresCanTouch) {
  for (const double shear_rate : {0.0, 1.0}) {
    expect_all_on_lists<3>(5.2, shear_rate);
    expect_all_on_lists<2>(12, shear_rate);
  }
  expect_all_on_lists<1>(90, 0);
}

}  // namespace
}  // namespace zenosphere
