#include "engine/simd/members_in_runs.hpp"

#include <array>
#include <bit>
#include <cstddef>

#include "engine/simd/wide_lanes.hpp"

namespace zenosphere {

namespace {

constexpr unsigned places_in_run = 8;

/// The spheres that follow the one at a place.
///
/// \param seen  the periodic image of the cell, as a Neighbour without a number
[[gnu::noinline]] Neighbour* find_further(const MembersOfCells& members, std::uint32_t place,
                                          std::uint32_t seen, Neighbour* found) {
  const Neighbour before = Neighbour::from_packed(seen + (place & CellPlace::seen));
  std::int32_t sphere = members.next[before.sphere()];
  for (; sphere >= 0; sphere = members.next[sphere]) {
    *found++ = Neighbour(sphere, before.periodic_image());
  }
  return found;
}

Neighbour* find_one_by_one(const MembersOfCells& members, std::span<const CellRun> runs,
                           Neighbour* found) {
  for (const CellRun& run : runs) {
    for (unsigned k = 0; k < places_in_run; ++k) {
      const std::uint32_t place = members.places[2 * std::size_t{run.first()} + k];
      if ((run.left_out >> k & 1U) != 0 || (place & CellPlace::empty) != 0) continue;
      *found++ = Neighbour::from_packed(run.seen() + (place & CellPlace::seen));
      if ((place & CellPlace::more) != 0) found = find_further(members, place, run.seen(), found);
    }
  }
  return found;
}

#ifdef ZENOSPHERE_HAS_WIDE_LANES

/// For each set of eight lanes: those that are not in it, one after the other.
constexpr auto lanes_in_front = [] {
  std::array<std::array<std::uint8_t, 8>, 256> lanes{};
  for (std::size_t left_out = 0; left_out < lanes.size(); ++left_out) {
    std::size_t front = 0;
    for (std::uint8_t lane = 0; lane < 8; ++lane) {
      if ((left_out >> lane & 1) == 0) lanes[left_out][front++] = lane;
    }
  }
  return lanes;
}();

/// Writes the spheres that have one of eight places, and then those that follow them.
///
/// \param seen      the periodic image of each place, as a Neighbour without a number
/// \param left_out  which places count for nothing, as a set of bits
ZENOSPHERE_WIDE inline Neighbour* find_in_eight(const MembersOfCells& members, __m256i places,
                                                __m256i seen, unsigned left_out, Neighbour* found) {
  left_out |= simd::bits(places);
  const __m256i what_is_seen = _mm256_set1_epi32(static_cast<int>(CellPlace::seen));
  const __m256i here = _mm256_add_epi32(_mm256_and_si256(places, what_is_seen), seen);
  const __m256i in_front = _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(lanes_in_front[left_out].data())));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(found),
                      _mm256_permutevar8x32_epi32(here, in_front));
  found += std::popcount(left_out ^ 0xFFU);
  unsigned further = simd::bits(_mm256_slli_epi32(places, 1)) & ~left_out;
  if (further != 0) [[unlikely]] {
    alignas(32) std::array<std::uint32_t, 8> eight;
    alignas(32) std::array<std::uint32_t, 8> images;
    _mm256_store_si256(reinterpret_cast<__m256i*>(eight.data()), places);
    _mm256_store_si256(reinterpret_cast<__m256i*>(images.data()), seen);
    for (; further != 0; further &= further - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(further));
      found = find_further(members, eight[k], images[k], found);
    }
  }
  return found;
}

ZENOSPHERE_WIDE Neighbour* find_wide(const MembersOfCells& members, std::span<const CellRun> runs,
                                     Neighbour* found) {
  const std::uint32_t* const all_places = members.places;
  for (const CellRun& run : runs) {
    const __m256i places = _mm256_loadu_si256(
        reinterpret_cast<const __m256i*>(all_places + 2 * std::size_t{run.first()}));
    found = find_in_eight(members, places, _mm256_set1_epi32(static_cast<int>(run.seen())),
                          run.left_out, found);
  }
  return found;
}

ZENOSPHERE_WIDE Neighbour* find_wide(const MembersOfCells& members, const ScatteredCells& cells,
                                     Neighbour* found) {
  const auto places_of = [&](std::size_t k) {
    return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(
        members.places + 2 * std::size_t{static_cast<std::uint32_t>(cells.places[k])}));
  };
  for (std::size_t k = 0; k < cells.count; k += 4) {
    const __m128i low = _mm_unpacklo_epi64(places_of(k), places_of(k + 1));
    const __m128i high = _mm_unpacklo_epi64(places_of(k + 2), places_of(k + 3));
    const __m256i four =
        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(cells.places.data() + k));
    const __m256i seen = _mm256_shuffle_epi32(four, 0b11'11'01'01);
    found = find_in_eight(members, _mm256_set_m128i(high, low), seen,
                          places_beyond(cells.count - k), found);
  }
  return found;
}

#endif

}  // namespace

Neighbour* find_members(const MembersOfCells& members, std::span<const CellRun> runs,
                        Neighbour* found) {
#ifdef ZENOSPHERE_HAS_WIDE_LANES
  if (has_wide_lanes()) return find_wide(members, runs, found);
#endif
  return find_one_by_one(members, runs, found);
}

Neighbour* find_members(const MembersOfCells& members, ScatteredCells& cells, Neighbour* found) {
#ifdef ZENOSPHERE_HAS_WIDE_LANES
  if (has_wide_lanes()) {
    // Four are read at once: those beyond the last count for nothing, but have to be cells.
    for (std::size_t k = cells.count; k % 4 != 0; ++k) cells.places[k] = cells.places[k - 1];
    return find_wide(members, cells, found);
  }
#endif
  for (std::size_t k = 0; k < cells.count; ++k) {
    const CellRun run = CellRun::of(cells.places[k], 1);
    found = find_one_by_one(members, {&run, 1}, found);
  }
  return found;
}

}  // namespace zenosphere
