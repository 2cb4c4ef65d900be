#include "engine/simd/members_in_runs.hpp"

#include <array>
#include <bit>
#include <cstddef>

#include "engine/simd/wide_lanes.hpp"

namespace zenosphere {

namespace {

constexpr unsigned places_in_run = 8;

/// The spheres of a run that have no place.
///
/// \param further  the places of those that they follow, as a set of bits
[[gnu::noinline]] Neighbour* find_further(const MembersOfCells& members, const CellRun& run,
                                          unsigned further, Neighbour* found) {
  const std::uint32_t* const places = members.places + 2 * std::size_t{run.first()};
  for (; further != 0; further &= further - 1) {
    const std::uint32_t seen = places[std::countr_zero(further)] & CellPlace::seen;
    const Neighbour before = Neighbour::from_packed(run.seen() + seen);
    std::int32_t sphere = members.next[before.sphere()];
    for (; sphere >= 0; sphere = members.next[sphere]) {
      *found++ = Neighbour(sphere, before.periodic_image());
    }
  }
  return found;
}

Neighbour* find_one_by_one(const MembersOfCells& members, std::span<const CellRun> runs,
                           Neighbour* found) {
  for (const CellRun& run : runs) {
    unsigned further = 0;
    for (unsigned k = 0; k < places_in_run; ++k) {
      const std::uint32_t place = members.places[2 * std::size_t{run.first()} + k];
      if ((run.left_out >> k & 1U) != 0 || (place & CellPlace::empty) != 0) continue;
      *found++ = Neighbour::from_packed(run.seen() + (place & CellPlace::seen));
      if ((place & CellPlace::more) != 0) further |= 1U << k;
    }
    if (further != 0) found = find_further(members, run, further, found);
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

ZENOSPHERE_WIDE inline unsigned bits(__m256i lanes) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(lanes)));
}

ZENOSPHERE_WIDE Neighbour* find_wide(const MembersOfCells& members, std::span<const CellRun> runs,
                                     Neighbour* found) {
  const std::uint32_t* const all_places = members.places;
  const __m256i what_is_seen = _mm256_set1_epi32(static_cast<int>(CellPlace::seen));
  for (const CellRun& run : runs) {
    const __m256i places = _mm256_loadu_si256(
        reinterpret_cast<const __m256i*>(all_places + 2 * std::size_t{run.first()}));
    const unsigned left_out = bits(places) | run.left_out;
    const __m256i here = _mm256_add_epi32(_mm256_and_si256(places, what_is_seen),
                                          _mm256_set1_epi32(static_cast<int>(run.seen())));
    const __m256i in_front = _mm256_cvtepu8_epi32(
        _mm_loadl_epi64(reinterpret_cast<const __m128i*>(lanes_in_front[left_out].data())));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(found),
                        _mm256_permutevar8x32_epi32(here, in_front));
    found += std::popcount(left_out ^ 0xFFU);
    const unsigned further = bits(_mm256_slli_epi32(places, 1)) & ~left_out;
    if (further != 0) [[unlikely]]
      found = find_further(members, run, further, found);
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

}  // namespace zenosphere
