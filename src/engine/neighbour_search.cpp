#include "engine/neighbour_search.hpp"

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Whether spheres find each other by the cells of their box alone.
template <int Dim, class Real>
bool cells_alone_suffice(const Spheres<Dim, Real>& spheres) {
  return spheres.fly_straight() &&
         cells_suffice(spheres.box(), spheres.count(), sizes_of(spheres.grains()));
}

}  // namespace

template <int Dim, class Real>
NeighbourSearch<Dim, Real>::NeighbourSearch(Spheres<Dim, Real>& spheres) {
  if (cells_alone_suffice(spheres)) {
    cells_.emplace(spheres);
  } else {
    lists_.emplace(spheres);
  }
}

template <int Dim, class Real>
void NeighbourSearch<Dim, Real>::renew_in_crowd(Spheres<Dim, Real>& spheres, const Real& when) {
  cells_.reset();
  lists_.emplace(spheres, when);
}

template <int Dim, class Real>
bool NeighbourSearch<Dim, Real>::is_far_out(const Spheres<Dim, Real>& spheres, std::int32_t i,
                                            const Real& when) const {
  const Vec<Dim, Real> place = spheres.position_at(i, when);
  const Vec<Dim, Real> away =
      ask([&](const auto& search) { return search.from_middle(spheres, i, place); });
  const Real limit = 2 * Real(reach());
  return dot(away, away) > limit * limit;
}

template <int Dim, class Real>
NeighbourSearch<Dim, Real>::NeighbourSearch(const Spheres<Dim, Real>& spheres,
                                            ArchiveReader& archive) {
  const bool had_lists = archive.template next<bool>();
  if (had_lists) {
    lists_.emplace(spheres, archive);
    return;
  }
  require_archived(cells_alone_suffice(spheres), "cells that are too wide to look in them");
  cells_.emplace(spheres, archive);
}

template <int Dim, class Real>
void NeighbourSearch<Dim, Real>::archive_to(ArchiveWriter& archive) const {
  archive(lists_.has_value());
  ask([&](const auto& search) { search.archive_to(archive); });
}

template <int Dim, class Real>
NeighbourSearch<Dim, Real>::NeighbourSearch(const NeighbourSearch&) = default;
template <int Dim, class Real>
NeighbourSearch<Dim, Real>::NeighbourSearch(NeighbourSearch&&) noexcept = default;
template <int Dim, class Real>
NeighbourSearch<Dim, Real>::~NeighbourSearch() = default;

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class NeighbourSearch<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
