#pragma once

#include <cstdint>
#include <span>

#include "engine/cell_search.hpp"
#include "engine/spheres.hpp"

namespace zenosphere {

/// The search for neighbours without lists, in dilute systems of spheres that fly straight: a
/// sphere is put into the next cell when it crosses a face of its own (see CellSearch).
///
/// Its members are those of SearchByLists.
template <int Dim, class Real>
class SearchByCells {
 public:
  using Vector = Vec<Dim, Real>;

  explicit SearchByCells(const Spheres<Dim, Real>& spheres);

  std::span<const Neighbour> neighbours(const Spheres<Dim, Real>& spheres, std::int32_t i) const {
    return search_.around(spheres.cells(), spheres.home(i));
  }
  Neighbour neighbour(const Spheres<Dim, Real>& spheres, std::int32_t i, std::int32_t j,
                      const Real& when) const;

  /// When a sphere leaves its cell: of a time after `until` only that it is after it.
  Real renewal_time(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when,
                    const Real& until) const;
  /// Lets a sphere cross the face that it has come to.
  ///
  /// \return  those that it has not seen before
  std::span<const Neighbour> renew(Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when,
                                   const Real& meeting);
  void place_anew(Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when);

  /// Layers that have slid bring spheres near that have not been seen before.
  bool slide_near(const Spheres<Dim, Real>& spheres) const { return spheres.box().is_sheared(); }
  std::span<const Neighbour> slid_near(const Spheres<Dim, Real>& spheres, std::int32_t i) const {
    return search_.slid_near(spheres.cells(), spheres.home(i));
  }
  void shift_times(const Spheres<Dim, Real>&, const Real&) {}

  void prefetch(std::int32_t) const {}
  void prefetch_around(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) const;

  /// Half the width of a cell, diameters.
  double reach() const { return reach_; }
  /// The place of a sphere from the middle of its cell.
  Vector from_middle(const Spheres<Dim, Real>& spheres, std::int32_t i, const Vector& place) const;
  bool is_crowded() const { return is_crowded_; }

 private:
  /// Through which face a sphere leaves its cell.
  struct Exit {
    Real time;  ///< from now
    int axis;
    int direction;  ///< 0: it stays
  };
  Vector place_in_cell(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) const;
  Exit exit(const Spheres<Dim, Real>& spheres, std::int32_t i, const Vector& in_cell) const;
  int column_beyond(const Spheres<Dim, Real>& spheres, std::int32_t i, int layers, int periods,
                    const Real& when) const;

  CellSearch<Dim> search_;
  double reach_ = 0;
  bool is_crowded_ = false;
};

}  // namespace zenosphere
