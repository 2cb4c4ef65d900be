// How neighbour lists begin: at a start, in a crowd, or from an archive.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/search_by_lists.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Of spheres at their start. Where so many are in one cell that lists of all within reach of wide
/// balls would be too long, for a crowd at once.
template <int Dim, class Real>
ListRange range_at_start(const Spheres<Dim, Real>& spheres) {
  const Sizes sizes = sizes_of(spheres.grains());
  const ListRange range = list_range_in(spheres.box(), spheres.count(), sizes);
  if (!range.is_wide) return range;
  std::vector<std::int32_t> in_cells(static_cast<std::size_t>(spheres.cells().count()));
  for (std::int32_t i = 0; i < spheres.count(); ++i) {
    if (++in_cells[static_cast<std::size_t>(spheres[i].cell)] > most_alone)
      return list_range_in_crowd(spheres.box(), spheres.count(), sizes);
  }
  return range;
}

template <int Dim, class Real>
ListRange range_in_crowd(const Spheres<Dim, Real>& spheres) {
  return list_range_in_crowd(spheres.box(), spheres.count(), sizes_of(spheres.grains()));
}

template <int Dim, class Real>
ReferenceGrid<Dim> grid_in(const ShearBox<Dim, Real>& box, double grain) {
  ReferenceGrid<Dim> grid{.grain = grain,
                          .volume = static_cast<double>(box.volume()),
                          .is_closed_along_x = box.is_closed(0),
                          .cell_width = static_cast<double>(box.cell_width()[0])};
  for (int axis = 0; axis < Dim; ++axis) {
    grid.cell_grains[static_cast<std::size_t>(axis)] =
        static_cast<int>(static_cast<double>(box.cell_width()[axis]) / grain + 0.5);
  }
  return grid;
}

template <class Real>
std::vector<double> rounded(const std::vector<Real>& numbers) {
  std::vector<double> rounded;
  for (const Real& number : numbers) rounded.push_back(static_cast<double>(number));
  return rounded;
}

}  // namespace

/// Empty lists of spheres that have no reference positions yet.
template <int Dim, class Real>
SearchByLists<Dim, Real>::SearchByLists(const Spheres<Dim, Real>& spheres, const ListRange& range)
    : range_(range),
      lists_(spheres.count(), range.neighbours),
      references_(spheres.cells(), grid_in(spheres.box(), range.grain), range,
                  rounded(spheres.radii())) {}

template <int Dim, class Real>
SearchByLists<Dim, Real>::SearchByLists(Spheres<Dim, Real>& spheres)
    : SearchByLists(spheres, range_at_start(spheres)) {
  put_references(spheres, 0);
  for (std::int32_t i = 0; i < spheres.count(); ++i) {
    // As if it had been alone until now.
    remove_reference(spheres, i);
    const std::span<Neighbour> neighbours = find_neighbours(spheres, i, 0);
    lists_.replace(i, neighbours, lists_.changes(i, neighbours));
    insert_reference(spheres, i);
    note_crowd(neighbours);
  }
  if (is_crowded_) *this = SearchByLists(spheres, Real(0));
}

template <int Dim, class Real>
SearchByLists<Dim, Real>::SearchByLists(Spheres<Dim, Real>& spheres, const Real& when)
    : SearchByLists(spheres, range_in_crowd(spheres)) {
  put_references(spheres, when);
  for (std::int32_t i = 0; i < spheres.count(); ++i) renew(spheres, i, when, when);
}

template <int Dim, class Real>
void SearchByLists<Dim, Real>::put_references(const Spheres<Dim, Real>& spheres, const Real& when) {
  for (std::int32_t i = 0; i < spheres.count(); ++i) {
    put_reference(spheres, i, when, {});
    insert_reference(spheres, i);
  }
}

/// Of each pair the sphere with the lower number has the other on its list in the archive; the
/// lists are sorted, since their order means nothing.
template <int Dim, class Real>
void SearchByLists<Dim, Real>::archive_to(ArchiveWriter& archive) const {
  const std::int32_t count = lists_.spheres();
  archive(range_.is_wide);
  for (std::int32_t i = 0; i < count; ++i) archive(reference(i));
  std::vector<std::uint32_t> later;
  for (std::int32_t i = 0; i < count; ++i) {
    later.clear();
    for (const Neighbour neighbour : lists_.of(i)) {
      if (neighbour.sphere() > i) later.push_back(neighbour.packed());
    }
    std::sort(later.begin(), later.end());
    archive(later);
  }
}

template <int Dim, class Real>
SearchByLists<Dim, Real>::SearchByLists(const Spheres<Dim, Real>& spheres, ArchiveReader& archive)
    : SearchByLists(spheres, archived_range(spheres, archive)) {
  for (std::int32_t i = 0; i < spheres.count(); ++i) {
    archive(reference(i));
    for (const int place : reference(i).place) {
      require_archived(place >= 0 && place <= ReferenceCells::grains_a_cell,
                       "a reference position outside of its cell");
    }
    insert_reference(spheres, i);
  }
  for (std::int32_t i = 0; i < spheres.count(); ++i) read_list(i, archive);
}

template <int Dim, class Real>
ListRange SearchByLists<Dim, Real>::archived_range(const Spheres<Dim, Real>& spheres,
                                                   ArchiveReader& archive) {
  const bool was_wide = archive.template next<bool>();
  if (!was_wide) return range_in_crowd(spheres);
  const ListRange range = list_range_in(spheres.box(), spheres.count(), sizes_of(spheres.grains()));
  require_archived(range.is_wide, "balls as wide as there are none");
  return range;
}

template <int Dim, class Real>
void SearchByLists<Dim, Real>::read_list(std::int32_t i, ArchiveReader& archive) {
  for (const auto packed : archive.template next<std::vector<std::uint32_t>>()) {
    const auto neighbour = Neighbour::from_packed(packed);
    const std::int32_t j = neighbour.sphere();
    require_archived(j > i && j < lists_.spheres() &&
                         neighbour.periodic_image().code() < PeriodicImage::count &&
                         lists_.of(i).size() < NeighbourLists::most &&
                         lists_.of(j).size() < NeighbourLists::most,
                     "neighbours that there are not");
    lists_.add(i, neighbour);
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                      \
  template SearchByLists<Dim, Real>::SearchByLists(Spheres<Dim, Real>&);                       \
  template SearchByLists<Dim, Real>::SearchByLists(Spheres<Dim, Real>&, const Real&);          \
  template SearchByLists<Dim, Real>::SearchByLists(const Spheres<Dim, Real>&, ArchiveReader&); \
  template void SearchByLists<Dim, Real>::archive_to(ArchiveWriter&) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
