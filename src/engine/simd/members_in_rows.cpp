#include "engine/simd/members_in_rows.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "engine/simd/wide_lanes.hpp"

namespace zenosphere {

namespace {

/// The spheres that follow one in its cell.
[[gnu::noinline]] Neighbour* find_further(const MembersOfCells& members, Neighbour before,
                                          Neighbour* found) {
  std::int32_t sphere = members.next[before.sphere()];
  for (; sphere >= 0; sphere = members.next[sphere]) {
    *found++ = Neighbour(sphere, before.periodic_image());
  }
  return found;
}

/// \param counted  which of eight places are those of cells that are looked at, as a set of bits
Neighbour* find_one_by_one(const MembersOfCells& members, SeenCell first, std::uint32_t counted,
                           Neighbour* found) {
  const std::uint32_t* const places = members.places + 2 * std::size_t{first.cell()};
  for (; counted != 0; counted &= counted - 1) {
    const std::uint32_t place = places[std::countr_zero(counted)];
    if ((place & CellPlace::taken) == 0) continue;
    *found++ = Neighbour::from_packed(first.image() + (place & CellPlace::seen));
    if ((place & CellPlace::more) != 0) found = find_further(members, found[-1], found);
  }
  return found;
}

#ifdef ZENOSPHERE_HAS_WIDE_LANES

/// For each set of eight lanes: those in it, one after the other.
constexpr auto lanes_in_front = [] {
  std::array<std::array<std::uint8_t, 8>, 256> lanes{};
  for (std::size_t set = 0; set < lanes.size(); ++set) {
    std::size_t front = 0;
    for (std::uint8_t lane = 0; lane < 8; ++lane) {
      if ((set >> lane & 1) != 0) lanes[set][front++] = lane;
    }
  }
  return lanes;
}();

/// Writes the spheres that have one of eight places, and then those that follow them.
///
/// \param images   in which they are seen, as a Neighbour has it
/// \param counted  which places are those of cells that are looked at, as a set of bits
ZENOSPHERE_WIDE inline Neighbour* find_in_eight(const MembersOfCells& members, __m256i places,
                                                __m256i images, std::uint32_t counted,
                                                Neighbour* found) {
  const unsigned taken = simd::bits(places) & counted;
  const __m256i seen = _mm256_add_epi32(
      _mm256_and_si256(places, _mm256_set1_epi32(static_cast<int>(CellPlace::seen))), images);
  const __m256i in_front = _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(lanes_in_front[taken].data())));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(found),
                      _mm256_permutevar8x32_epi32(seen, in_front));
  found += std::popcount(taken);
  unsigned further = simd::bits(_mm256_slli_epi32(places, 1)) & taken;
  if (further != 0) [[unlikely]] {
    alignas(32) std::array<std::uint32_t, 8> eight;
    _mm256_store_si256(reinterpret_cast<__m256i*>(eight.data()), seen);
    for (; further != 0; further &= further - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(further));
      found = find_further(members, Neighbour::from_packed(eight[k]), found);
    }
  }
  return found;
}

ZENOSPHERE_WIDE inline Neighbour* find_in_run(const MembersOfCells& members, SeenCell first,
                                              std::uint32_t counted, Neighbour* found) {
  const auto* const places =
      reinterpret_cast<const __m256i*>(members.places + 2 * std::size_t{first.cell()});
  return find_in_eight(members, _mm256_loadu_si256(places),
                       _mm256_set1_epi32(static_cast<int>(first.image())), counted, found);
}

ZENOSPHERE_WIDE Neighbour* find_wide(const MembersOfCells members, const CellBlock& cells,
                                     Neighbour* found) {
  for (std::size_t k = 0; k < cells.run_count; ++k) {
    const auto& [first, places] = cells.runs[k];
    found = find_in_run(members, first + cells.rows[0], places, found);
    if (cells.row_count == 1) continue;
    found = find_in_run(members, first + cells.rows[1], places, found);
    found = find_in_run(members, first + cells.rows[2], places, found);
  }
  return found;
}

ZENOSPHERE_WIDE Neighbour* find_wide(const MembersOfCells members, const ScatteredCells& cells,
                                     Neighbour* found) {
  const auto places_in = [&](std::size_t k) {
    return _mm_loadl_epi64(
        reinterpret_cast<const __m128i*>(members.places + 2 * std::size_t{cells.cells[k].cell()}));
  };
  for (std::size_t k = 0; k < cells.count; k += 4) {
    const __m128i low = _mm_unpacklo_epi64(places_in(k), places_in(k + 1));
    const __m128i high = _mm_unpacklo_epi64(places_in(k + 2), places_in(k + 3));
    const __m256i four =
        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(cells.cells.data() + k));
    const __m256i images = _mm256_shuffle_epi32(four, 0b11'11'01'01);
    found = find_in_eight(members, _mm256_set_m128i(high, low), images,
                          places_of(std::min(cells.count - k, std::size_t{4})), found);
  }
  return found;
}

#endif

}  // namespace

Neighbour* find_members(const MembersOfCells& members, const CellBlock& cells, Neighbour* found) {
#ifdef ZENOSPHERE_HAS_WIDE_LANES
  if (has_wide_lanes()) return find_wide(members, cells, found);
#endif
  for (std::size_t k = 0; k < cells.run_count; ++k) {
    const auto& [first, places] = cells.runs[k];
    for (std::size_t row = 0; row < cells.row_count; ++row) {
      found = find_one_by_one(members, first + cells.rows[row], places, found);
    }
  }
  return found;
}

Neighbour* find_members(const MembersOfCells& members, ScatteredCells& cells, Neighbour* found) {
#ifdef ZENOSPHERE_HAS_WIDE_LANES
  if (has_wide_lanes()) {
    // Four are read at once: those beyond the last count for nothing, but have to be cells.
    for (std::size_t k = cells.count; k % 4 != 0; ++k) cells.cells[k] = cells.cells[k - 1];
    return find_wide(members, cells, found);
  }
#endif
  for (std::size_t k = 0; k < cells.count; ++k) {
    found = find_one_by_one(members, cells.cells[k], places_of(1), found);
  }
  return found;
}

}  // namespace zenosphere
