#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/list_range.hpp"
#include "engine/reference_cells.hpp"
#include "engine/reference_position.hpp"
#include "engine/sized_reference_cells.hpp"
#include "engine/sliding_cells.hpp"

namespace zenosphere {

/// The reference positions of all spheres, and which of them are near one: of spheres of one size
/// in one grid of cells, of others in one for each class of sizes.
template <int Dim>
class ReferenceSearch {
 public:
  /// \param radii  of the spheres, diameters; none where all have unit diameter
  ReferenceSearch(const SlidingCells<Dim>& cells, const ReferenceGrid<Dim>& grid,
                  const ListRange& range, std::span<const double> radii);

  /// \param cell  in which the sphere is at home
  void insert(std::int32_t sphere, std::int32_t cell, const ReferencePosition& reference);
  /// \param reference  as it was inserted
  void remove(std::int32_t sphere, std::int32_t cell, const ReferencePosition& reference);

  /// A sphere that looks around.
  struct Viewer {
    std::int32_t sphere;
    Steps<Dim> home;                 ///< its cell
    ReferencePosition::Place place;  ///< of its reference position, from the corner of the cell
    LayerSlides slides;              ///< of the layers beside it now
  };

  /// All spheres whose balls come within a diameter of that of the viewer while one slides past the
  /// other, the viewer not among them where it is not inserted. They hold until the next call, and
  /// there is room behind them.
  ///
  /// \param cells  as they have slid
  std::span<Neighbour> find(const SlidingCells<Dim>& cells, const Viewer& viewer);

  /// Prefetches what find() will read.
  void prefetch(const SlidingCells<Dim>& cells, const Viewer& viewer) const;

 private:
  /// Slides in grains, in the middle of the time for which a list lasts.
  struct SlidGrains {
    std::array<int, 3> layers;  ///< below, beside and above: where they are along x
    int either_way;             ///< how far adjacent ones slide before and after that
  };
  SlidGrains slid_grains(const LayerSlides& slides) const;
  std::span<Neighbour> find_of_one_size(const SlidingCells<Dim>& cells, const Viewer& viewer);
  typename SizedReferenceCells<Dim>::Viewer sized(const Viewer& viewer) const;
  typename SlidingCells<Dim>::Reach columns_within_reach(const Viewer& viewer) const;

  ReferenceGrid<Dim> grid_;
  ListRange range_;
  double largest_ = 1;    ///< diameter
  int slide_grains_ = 0;  ///< by which adjacent layers slide while half of a list's time passes
  ReferenceCells cells_;  ///< of spheres of one size
  std::optional<SizedReferenceCells<Dim>> sized_cells_;  ///< in place of these, or none
  std::vector<Neighbour> nearby_;                        ///< scratch
};

}  // namespace zenosphere
