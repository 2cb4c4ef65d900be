#pragma once

/// Code that handles several numbers at once needs AVX2. It is compiled beside code that does the
/// same one by one, whatever processor the program is built for, and chosen where the program runs.
/// Both do the same operations in the same order: the same bits come out.
#if defined(__x86_64__) && !defined(ZENOSPHERE_NARROW_LANES)
#include <immintrin.h>
#define ZENOSPHERE_HAS_WIDE_LANES 1
#define ZENOSPHERE_WIDE [[gnu::target("avx2,popcnt")]]
#endif

namespace zenosphere {

/// Whether this processor can run what is marked ZENOSPHERE_WIDE.
inline bool has_wide_lanes() {
#ifdef ZENOSPHERE_HAS_WIDE_LANES
  static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt");
  return has;
#else
  return false;
#endif
}

#ifdef ZENOSPHERE_HAS_WIDE_LANES
namespace simd {

/// The highest bit of each lane, as a set of bits.
ZENOSPHERE_WIDE inline unsigned bits(__m256d lanes) {
  return static_cast<unsigned>(_mm256_movemask_pd(lanes));
}
ZENOSPHERE_WIDE inline unsigned bits(__m256i lanes) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(lanes)));
}

/// The least of four, in all lanes.
ZENOSPHERE_WIDE inline __m256d least_of_all(__m256d lanes) {
  lanes = _mm256_min_pd(lanes, _mm256_permute2f128_pd(lanes, lanes, 1));
  return _mm256_min_pd(lanes, _mm256_permute_pd(lanes, 0b0101));
}

}  // namespace simd
#endif

}  // namespace zenosphere
