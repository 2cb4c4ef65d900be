#include "engine/simd/places_in_order.hpp"

#include "engine/simd/wide_lanes.hpp"

namespace zenosphere {

#ifdef ZENOSPHERE_HAS_WIDE_LANES

namespace {

/// \tparam Fours  so many times four numbers are compared
/// \return        the sum of all places
template <std::size_t Fours>
ZENOSPHERE_WIDE inline std::int64_t count_less(const double* numbers, std::int64_t* places) {
  __m256d all[Fours];
  __m256i less[Fours];
  for (std::size_t k = 0; k < Fours; ++k) {
    all[k] = _mm256_loadu_pd(numbers + 4 * k);
    less[k] = _mm256_setzero_si256();
  }
  for (std::size_t k = 0; k < 4 * Fours; ++k) {
    const __m256d one = _mm256_broadcast_sd(numbers + k);
    for (std::size_t four = 0; four < Fours; ++four) {
      const __m256d is_less = _mm256_cmp_pd(one, all[four], _CMP_LT_OQ);  // -1, as an integer
      less[four] = _mm256_sub_epi64(less[four], _mm256_castpd_si256(is_less));
    }
  }
  __m256i sum = _mm256_setzero_si256();
  for (std::size_t k = 0; k < Fours; ++k) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(places + 4 * k), less[k]);
    sum = _mm256_add_epi64(sum, less[k]);
  }
  const __m128i halves =
      _mm_add_epi64(_mm256_castsi256_si128(sum), _mm256_extracti128_si256(sum, 1));
  return _mm_cvtsi128_si64(_mm_add_epi64(halves, _mm_unpackhi_epi64(halves, halves)));
}

ZENOSPHERE_WIDE PlacesInOrder find_places(const std::array<double, most_in_order>& numbers,
                                          std::size_t count) {
  PlacesInOrder found;
  const bool are_few = count <= most_in_order / 2;
  const std::int64_t sum = are_few ? count_less<2>(numbers.data(), found.places.data())
                                   : count_less<4>(numbers.data(), found.places.data());
  found.compared = are_few ? most_in_order / 2 : most_in_order;
  // Of two that differ one is less.
  const std::size_t pairs = count * (count - 1) / 2 + count * (found.compared - count);
  found.all_differ = static_cast<std::size_t>(sum) == pairs;
  return found;
}

}  // namespace

#else

namespace {

/// Not called: there are no wide lanes.
PlacesInOrder find_places(const auto&...) { return {}; }

}  // namespace

#endif

PlacesInOrder places_in_order_wide(const std::array<double, most_in_order>& numbers,
                                   std::size_t count) {
  return find_places(numbers, count);
}

}  // namespace zenosphere
