#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/search_by_cells.hpp"
#include "engine/search_by_lists.hpp"
#include "engine/spheres.hpp"
#include "model/archive.hpp"

namespace zenosphere {

/// Which spheres are near each one: all that it can touch before its neighbours are renewed.
///
/// One of two ways suits a system: lists, each renewed when its sphere has moved far or layers have
/// slid far, or in dilute ones the cells alone, where a sphere that crosses a face of its cell sees
/// new ones. This is the only place that knows of both. The spheres are handed to each call: they
/// are those that it was made of.
template <int Dim, class Real>
class NeighbourSearch {
 public:
  /// The neighbours of spheres at their start, at remainder 0.
  explicit NeighbourSearch(Spheres<Dim, Real>& spheres);

  /// Those that an archive holds. Throws ArchiveError where they cannot be.
  NeighbourSearch(const Spheres<Dim, Real>& spheres, ArchiveReader& archive);
  void archive_to(ArchiveWriter& archive) const;

  // Compiled once, like those of a simulation.
  NeighbourSearch(const NeighbourSearch&);
  NeighbourSearch(NeighbourSearch&&) noexcept;
  ~NeighbourSearch();

  /// Whether spheres are looked for cell by cell, without lists.
  bool looks_by_cells() const { return cells_.has_value(); }

  /// The neighbours of i; perhaps i itself, which it never approaches. They hold until the next
  /// call, and up to three more may be read behind them.
  std::span<const Neighbour> neighbours(const Spheres<Dim, Real>& spheres, std::int32_t i) const {
    return ask([&](const auto& search) { return search.neighbours(spheres, i); });
  }

  /// How i sees j, a neighbour; in a narrow box, where several images of it are near, the nearest
  /// one.
  Neighbour neighbour(const Spheres<Dim, Real>& spheres, std::int32_t i, std::int32_t j,
                      const Real& when) const {
    return ask([&](const auto& search) { return search.neighbour(spheres, i, j, when); });
  }

  /// Plans when the neighbours of a sphere have to be renewed, as foreseen at `when`; of a time
  /// after `until` only that it is after it. Whenever a sphere has another velocity or cell.
  Real plan_renewal(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when,
                    const Real& until) {
    return ask([&](auto& search) { return search.plan_renewal(spheres, i, when, until); });
  }

  /// Renews the neighbours of a sphere at `when`. It may get another cell and frame.
  ///
  /// \param meeting  the next one, as far as is known
  /// \return  those that are new
  std::span<const Neighbour> renew(Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when,
                                   const Real& meeting) {
    return ask([&](auto& search) { return search.renew(spheres, i, when, meeting); });
  }

  /// Finds the neighbours of a sphere that has not been followed for a while, wherever it is.
  void place_anew(Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) {
    ask([&](auto& search) { search.place_anew(spheres, i, when); });
  }

  /// Follows spheres whose times have just been shifted by `span`.
  void shift_times(const Spheres<Dim, Real>& spheres, const Real& span) {
    ask([&](auto& search) { search.shift_times(spheres, span); });
  }
  /// Whether spheres come near by that: new neighbours, which have to be looked at.
  bool slide_near(const Spheres<Dim, Real>& spheres) const {
    return ask([&](const auto& search) { return search.slide_near(spheres); });
  }
  /// Those that i has to look at then; of each pair one is told.
  std::span<const Neighbour> slid_near(const Spheres<Dim, Real>& spheres, std::int32_t i) const {
    return ask([&](const auto& search) { return search.slid_near(spheres, i); });
  }

  /// Prefetches what is kept of a sphere.
  void prefetch(std::int32_t i) const {
    ask([&](const auto& search) { search.prefetch(i); });
  }
  /// Prefetches the cells around it, where its neighbours will be renewed at `when`.
  void prefetch_around(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) const {
    ask([&](const auto& search) { search.prefetch_around(spheres, i, when); });
  }

  /// How far a sphere goes from its reference position, or from the middle of its cell, diameters.
  double reach() const {
    return ask([](const auto& search) { return search.reach(); });
  }
  /// Whether a sphere is far outside of its ball: it was known that it would meet no other there.
  bool is_far_out(const Spheres<Dim, Real>& spheres, std::int32_t i, const Real& when) const;

  /// Whether more spheres are near one than suits.
  bool is_crowded() const {
    return ask([](const auto& search) { return search.is_crowded(); });
  }
  /// Renews the neighbours of all, in a way that suits a crowd from now on.
  void renew_in_crowd(Spheres<Dim, Real>& spheres, const Real& when);

 private:
  using Lists = SearchByLists<Dim, Real>;
  using Cells = SearchByCells<Dim, Real>;

  template <class Action>
  decltype(auto) ask(Action action) const {
    if (cells_) return action(*cells_);
    return action(*lists_);
  }
  template <class Action>
  decltype(auto) ask(Action action) {
    if (cells_) return action(*cells_);
    return action(*lists_);
  }

  // One of the two. A variant would be tested twice.
  std::optional<Lists> lists_;
  std::optional<Cells> cells_;
};

}  // namespace zenosphere
