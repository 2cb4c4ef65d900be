#pragma once

#include <bit>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace zenosphere {

/// Which of four numbers in a row, of which only the bits in `mask` count, are `wanted`: a set of
/// four bits.
template <class Number>
unsigned equal_in_four(const Number* four, std::uint32_t wanted, std::uint32_t mask) {
  static_assert(sizeof(Number) == sizeof(std::uint32_t));
#ifdef __SSE2__
  const __m128i numbers = _mm_loadu_si128(reinterpret_cast<const __m128i*>(four));
  const __m128i bits = _mm_set1_epi32(static_cast<int>(mask));
  const __m128i pattern = _mm_set1_epi32(static_cast<int>(wanted));
  const __m128i equal = _mm_cmpeq_epi32(_mm_and_si128(numbers, bits), pattern);
  return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(equal)));
#else
  unsigned set = 0;
  for (int k = 0; k < 4; ++k) {
    set |= static_cast<unsigned>((std::bit_cast<std::uint32_t>(four[k]) & mask) == wanted) << k;
  }
  return set;
#endif
}

}  // namespace zenosphere
