#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/cell_search.hpp"
#include "engine/prefetching.hpp"
#include "engine/simd/next_face.hpp"
#include "engine/simd/wide_lanes.hpp"
#include "engine/spheres.hpp"
#include "model/archive.hpp"

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
  /// As an archive has it. Throws ArchiveError where it cannot be.
  SearchByCells(const Spheres<Dim, Real>& spheres, ArchiveReader& archive);
  void archive_to(ArchiveWriter& archive) const { archive(exits_); }

  std::span<const Neighbour> neighbours(const Spheres<Dim, Real>& spheres, std::int32_t i) const {
    return search_.around(spheres.cells(), spheres.home(i));
  }
  Neighbour neighbour(const Spheres<Dim, Real>& spheres, std::int32_t i, std::int32_t j,
                      const Real& when) const;

  /// Notes through which face a sphere leaves its cell, and tells when: of a time after `until`
  /// only that it is after it.
  Real plan_renewal(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when,
                    const Real& until);
  /// Lets a sphere cross the face that it has come to, as planned.
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

  void prefetch(std::int32_t i) const { prefetch_line(&exits_[static_cast<std::size_t>(i)]); }
  void prefetch_around(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) const;

  /// Half the width of a cell, diameters.
  double reach() const { return reach_; }
  /// The place of a sphere from the middle of its cell.
  Vector from_middle(const Spheres<Dim, Real>& spheres, std::int32_t i, const Vector& place) const;
  bool is_crowded() const { return is_crowded_; }

 private:
  NextFace<Real> next_face(const Spheres<Dim, Real>& spheres, std::int32_t i,
                           const Real& when) const;
  int column_beyond(const Spheres<Dim, Real>& spheres, std::int32_t i, int layers, int periods,
                    const Real& when) const;

  CellSearch<Dim> search_;
  /// Through which face each sphere leaves its cell: 1 + its axis, below zero towards smaller
  /// coordinates; 0: it stays.
  std::vector<std::int8_t> exits_;
  CellWidths<Real> widths_{};
  bool lanes_are_wide_ = has_wide_lanes();  ///< faces of all axes are looked at at once
  double reach_ = 0;
  bool is_crowded_ = false;
};

}  // namespace zenosphere
