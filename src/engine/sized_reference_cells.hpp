#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/reference_cells.hpp"
#include "engine/reference_position.hpp"
#include "engine/sliding_cells.hpp"

namespace zenosphere {

/// The cells of a box, as a search for reference positions sees them.
template <int Dim>
struct ReferenceGrid {
  std::array<int, Dim> cell_grains{};  ///< sides of a cell, rounded
  double grain = 0;                    ///< diameters
  double volume = 0;                   ///< of the box, diameters^Dim
  bool is_closed_along_x = false;
  double cell_width = 0;  ///< along x, diameters
};

/// The reference positions of spheres that differ in size: in one grid for each class of sizes.
///
/// The cells in which spheres are at home have room for the largest. In the grid of a class each of
/// them is divided into smaller ones, as many as suit the number of spheres in the class. So the
/// layers slide by the same whole cells in all grids. Sizes within a class are at most as 1 to 2,
/// and a search takes each pair by its own distance.
///
/// Source: Ogarko & Luding, Comput. Phys. Commun. 183 (2012) 931, with one grid for each class.
/// That one cell of the coarsest grid is divided by whole numbers is ours.
template <int Dim>
class SizedReferenceCells {
 public:
  /// \param radii  of the spheres, diameters; at least one
  SizedReferenceCells(const SlidingCells<Dim>& cells, const ReferenceGrid<Dim>& grid,
                      std::span<const double> radii);

  /// \param cell  in which the sphere is at home
  void insert(std::int32_t sphere, std::int32_t cell, const ReferencePosition& reference);
  /// \param reference position  as it was inserted
  void remove(std::int32_t sphere, std::int32_t cell, const ReferencePosition& reference);

  /// A sphere that looks around.
  struct Viewer {
    std::int32_t sphere;
    Steps<Dim> home;  ///< its cell
    ReferencePosition::Place
        place;  ///< of its reference position, from the lower corner of the cell, grains
    std::array<int, 3> slid;  ///< layers below, beside and above along x, grains
    int slide;                ///< and how far adjacent ones slide either way of that
    int beyond;  ///< distance of surfaces up to which reference positions count, grains
  };

  /// Those around whose surfaces come near while adjacent layers slide, the viewer not among them.
  ///
  /// \param cells   as they have slid
  /// \param nearby  takes them, with room behind them
  std::span<Neighbour> find(const SlidingCells<Dim>& cells, const Viewer& viewer,
                            std::vector<Neighbour>& nearby) const;

  /// Prefetches what find() will read.
  void prefetch(const SlidingCells<Dim>& cells, const Viewer& viewer) const;

 private:
  using Row = ReferenceCells::Row;

  /// Spheres of similar size, and the parts of cells in which their reference positions are.
  struct Class {
    int least = 0;                    ///< radius, grains
    int most = 0;                     ///< the same, rounded up as codes of size tell
    int shift = 0;                    ///< a code of size counts 2^shift grains of radius
    std::array<int, Dim> parts{};     ///< of a cell along each axis
    std::array<double, Dim> scale{};  ///< parts a grain
    ReferenceCells cells{0};

    int parts_of_a_cell() const;
    bool is_undivided() const { return parts_of_a_cell() == 1; }
    /// Grains from one part in a row to the next: within a cell places count from its corner.
    std::int16_t row_step(int cell_grains) const {
      return static_cast<std::int16_t>(is_undivided() ? cell_grains : 0);
    }
    /// The part of a cell at a place, or the nearest one.
    int part_along(std::size_t axis, int place) const {
      const int part = place > 0 ? static_cast<int>(place * scale[axis]) : 0;
      return part < parts[axis] ? part : parts[axis] - 1;
    }
    std::int32_t part_of(std::int32_t cell, const ReferencePosition& reference) const;
  };
  struct Size {
    std::uint8_t number;  ///< of its class
    std::uint8_t code;    ///< of the radius beyond the least in the class
  };

  Class class_of(const SlidingCells<Dim>& cells, std::span<const double> radii) const;
  Size size_of(double radius) const;
  Size size(std::int32_t sphere) const { return sizes_[static_cast<std::size_t>(sphere)]; }
  int radius(std::int32_t sphere) const;
  std::int32_t label(std::int32_t sphere) const;
  void find_rows(const SlidingCells<Dim>& cells, const Viewer& viewer, const Class& sizes) const;
  void add_parts(std::int32_t cell, Row row, int distance, const Class& sizes) const;

  ReferenceGrid<Dim> grid_;
  std::vector<Class> classes_;     ///< the largest spheres first
  std::vector<Size> sizes_;        ///< of each sphere
  mutable std::vector<Row> rows_;  ///< scratch
};

}  // namespace zenosphere
