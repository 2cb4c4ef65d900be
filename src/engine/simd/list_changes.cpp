#include "engine/simd/list_changes.hpp"

#include <bit>
#include <utility>

#include "engine/simd/wide_lanes.hpp"

namespace zenosphere {

namespace {

#ifdef ZENOSPHERE_HAS_WIDE_LANES

constexpr std::size_t most_in_registers = 24;

/// What changes, where a set can hold the neighbours `before` and registers those `now`: all of
/// these are compared at once with each one of those.
ZENOSPHERE_WIDE NeighbourLists::Changes changes_in_registers(std::span<const Neighbour> before,
                                                             std::span<Neighbour> now) {
  constexpr int registers = most_in_registers / 8;
  const int count = static_cast<int>(now.size());
  __m256i wanted[registers];
  __m256i known[registers];
  for (int r = 0; r < registers; ++r) {
    const __m256i places =
        _mm256_add_epi32(_mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7), _mm256_set1_epi32(8 * r));
    const __m256i is_taken = _mm256_cmpgt_epi32(_mm256_set1_epi32(count), places);
    const auto* const eight = reinterpret_cast<const int*>(now.data()) + 8 * r;
    // At places that are not taken there is the number of no sphere.
    wanted[r] = _mm256_or_si256(_mm256_maskload_epi32(eight, is_taken),
                                _mm256_xor_si256(is_taken, _mm256_set1_epi32(-1)));
    known[r] = _mm256_setzero_si256();
  }
  NeighbourLists::Changes changes{};
  for (std::size_t k = 0; k < before.size(); ++k) {
    const __m256i one = _mm256_set1_epi32(static_cast<int>(before[k].packed()));
    __m256i stays = _mm256_setzero_si256();
    for (int r = 0; r < registers; ++r) {
      const __m256i is_same = _mm256_cmpeq_epi32(wanted[r], one);
      known[r] = _mm256_or_si256(known[r], is_same);
      stays = _mm256_or_si256(stays, is_same);
    }
    changes.kept |= std::uint64_t{_mm256_testz_si256(stays, stays) == 0} << k;
  }
  std::uint64_t fresh = all_of(now.size());
  for (int r = 0; r < registers; ++r) {
    const auto set = static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(known[r])));
    fresh &= ~(std::uint64_t{set} << (8 * r));
  }
  for (; fresh != 0; fresh &= fresh - 1) {
    std::swap(now[changes.fresh++], now[static_cast<std::size_t>(std::countr_zero(fresh))]);
  }
  return changes;
}

#endif

NeighbourLists::Changes changes_one_by_one(std::span<const Neighbour> before,
                                           std::span<Neighbour> now) {
  const std::size_t compared = std::min(before.size(), most_in_a_set);
  NeighbourLists::Changes changes{};
  for (Neighbour& neighbour : now) {
    const std::uint64_t place =
        places_of(before.data(), compared, neighbour.packed(), ~std::uint32_t{0});
    changes.kept |= place;
    // Changes places with the first that is not new, without a branch.
    const bool is_new = place == 0;
    const Neighbour first = now[changes.fresh];
    const Neighbour self = neighbour;
    neighbour = is_new ? first : self;
    now[changes.fresh] = is_new ? self : first;
    changes.fresh += is_new ? 1 : 0;
  }
  return changes;
}

}  // namespace

NeighbourLists::Changes list_changes(std::span<const Neighbour> before, std::span<Neighbour> now) {
#ifdef ZENOSPHERE_HAS_WIDE_LANES
  const bool fits = before.size() <= most_in_a_set && now.size() <= most_in_registers;
  if (fits && has_wide_lanes()) return changes_in_registers(before, now);
#endif
  return changes_one_by_one(before, now);
}

}  // namespace zenosphere
