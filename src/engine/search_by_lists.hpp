#pragma once

#include <cstdint>
#include <span>

#include "engine/list_range.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/reference_position.hpp"
#include "engine/reference_search.hpp"
#include "engine/spheres.hpp"
#include "model/archive.hpp"

namespace zenosphere {

/// Neighbour lists, and when each of them is renewed.
///
/// A sphere whose list is renewed gets a reference position where it is, or somewhat ahead, the
/// cell of that position, and a list of all that can touch it while both stay within reach of
/// theirs. When it leaves that ball, or the layers have slid on by half a cell or less, its list
/// has to be renewed. Until then cell and frame stay, also where the sphere is a little outside.
///
/// Source: neighbour lists in event-driven dynamics: Donev, Torquato & Stillinger, J. Comput. Phys.
/// 202 (2005) 737. That each is renewed alone, and the frames that slide, are ours.
template <int Dim, class Real>
class SearchByLists {
 public:
  using Vector = Vec<Dim, Real>;

  /// Lists of spheres at their start, at remainder 0.
  explicit SearchByLists(Spheres<Dim, Real>& spheres);
  /// Lists for a crowd: of spheres that had others at `when`, or none.
  SearchByLists(Spheres<Dim, Real>& spheres, const Real& when);

  /// Lists that an archive holds. Throws ArchiveError where they cannot be.
  SearchByLists(const Spheres<Dim, Real>& spheres, ArchiveReader& archive);
  void archive_to(ArchiveWriter& archive) const;

  std::span<const Neighbour> neighbours(const Spheres<Dim, Real>&, std::int32_t i) const {
    return lists_.of(i);
  }
  Neighbour neighbour(const Spheres<Dim, Real>& spheres, std::int32_t i, std::int32_t j,
                      const Real& when) const;

  Real plan_renewal(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when,
                    const Real& until) const;
  /// \param meeting  the next one, as far as is known: where its reference position should be
  std::span<const Neighbour> renew(Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when,
                                   const Real& meeting);
  void place_anew(Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) {
    renew(spheres, i, when, when);
  }

  /// Lists hold all that layers bring near while they last.
  bool slide_near(const Spheres<Dim, Real>&) const { return false; }
  std::span<const Neighbour> slid_near(const Spheres<Dim, Real>&, std::int32_t) const { return {}; }
  void shift_times(const Spheres<Dim, Real>& spheres, const Real& span);

  void prefetch(std::int32_t i) const { lists_.prefetch(i); }
  void prefetch_around(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) const;

  /// Of a ball, diameters.
  double reach() const { return range_.reach; }
  /// A place of a sphere from its reference position.
  [[gnu::always_inline]] Vector from_middle(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                            const Vector& place) const {
    const ReferencePosition& reference = this->reference(i);
    const Vector corner = spheres.sliding_box().corner(spheres[i].cell);
    Vector away;
    for (int axis = 0; axis < Dim; ++axis) {
      const Real middle = reference.place[static_cast<std::size_t>(axis)] * Real(range_.grain);
      away[axis] = (place[axis] - corner[axis]) - middle;
    }
    return away;
  }
  bool is_crowded() const { return is_crowded_; }

 private:
  SearchByLists(const Spheres<Dim, Real>& spheres, const ListRange& range);
  void put_reference(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when,
                     const Vector& ahead);
  void put_references(const Spheres<Dim, Real>& spheres, const Real& when);
  void insert_reference(const Spheres<Dim, Real>& spheres, std::int32_t i) {
    references_.insert(i, spheres[i].cell, reference(i));
  }
  void remove_reference(const Spheres<Dim, Real>& spheres, std::int32_t i) {
    references_.remove(i, spheres[i].cell, reference(i));
  }
  ReferencePosition::Place place_in_cell(const Spheres<Dim, Real>& spheres, std::int32_t cell,
                                         const Vector& place) const;
  Vector displacement_of_reference(const Spheres<Dim, Real>& spheres, const Vector& velocity,
                                   const Real& flight) const;
  std::span<Neighbour> find_neighbours(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                       const Real& when);
  Neighbour not_listed_first(const Spheres<Dim, Real>& spheres, std::int32_t i, std::int32_t j,
                             const Real& when) const;
  void note_crowd(std::span<const Neighbour> neighbours) {
    is_crowded_ = is_crowded_ || (range_.is_wide && neighbours.size() > most_alone);
  }
  Real time_in_ball(const Vector& away, const Vector& velocity) const;
  Real time_in_cube(const Vector& away, const Vector& velocity, const Vector& pull) const;
  double reach_along_axes() const;
  static ListRange archived_range(const Spheres<Dim, Real>& spheres, ArchiveReader& archive);
  void read_list(std::int32_t i, ArchiveReader& archive);
  ReferencePosition& reference(std::int32_t i) { return lists_.reference(i); }
  const ReferencePosition& reference(std::int32_t i) const { return lists_.reference(i); }

  ListRange range_;
  bool is_crowded_ = false;  ///< and the balls are still wide
  NeighbourLists lists_;
  ReferenceSearch<Dim> references_;
};

}  // namespace zenosphere
