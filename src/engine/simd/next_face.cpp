#include "engine/simd/next_face.hpp"

#include <bit>

#include "engine/simd/wide_lanes.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

#ifdef ZENOSPHERE_HAS_WIDE_LANES

namespace {

/// The coordinates of a cell; 0 beyond the last axis.
template <int Dim>
ZENOSPHERE_WIDE inline __m256d coordinates(const Steps<Dim>& cell) {
  return _mm256_cvtepi32_pd(
      _mm_setr_epi32(cell[0], Dim > 1 ? cell[Dim > 1 ? 1 : 0] : 0, Dim > 2 ? cell[Dim - 1] : 0, 0));
}

template <int Dim>
ZENOSPHERE_WIDE NextFace<double> find_next_face(const Sphere<Dim, double>& sphere,
                                                const Steps<Dim>& cell,
                                                const CellWidths<double>& widths, double when) {
  constexpr int axes = (1 << Dim) - 1;
  const __m256d never = _mm256_set1_pd(std::numeric_limits<double>::infinity());
  const __m256d zero = _mm256_setzero_pd();
  // Four numbers are read, of which the first are coordinates: the line of a sphere is long enough.
  const auto* const numbers = reinterpret_cast<const double*>(&sphere);
  const __m256d velocity = _mm256_loadu_pd(numbers + Dim);
  const __m256d width = _mm256_loadu_pd(widths.data());
  const __m256d flight = _mm256_set1_pd(when - sphere.time);
  const __m256d place = _mm256_add_pd(_mm256_loadu_pd(numbers), _mm256_mul_pd(velocity, flight));
  const __m256d in_cell = _mm256_sub_pd(place, _mm256_mul_pd(coordinates<Dim>(cell), width));
  const __m256d is_forward = _mm256_cmp_pd(velocity, zero, _CMP_GT_OQ);
  const __m256d face = _mm256_and_pd(width, is_forward);
  const __m256d time = _mm256_div_pd(_mm256_sub_pd(face, in_cell), velocity);
  const __m256d is_none = _mm256_or_pd(_mm256_cmp_pd(velocity, zero, _CMP_EQ_OQ),
                                       _mm256_cmp_pd(time, time, _CMP_UNORD_Q));
  const __m256d of_axes = _mm256_blend_pd(never, _mm256_blendv_pd(time, never, is_none), axes);
  const __m256d first = simd::least_of_all(of_axes);
  const int axis = std::countr_zero(simd::bits(_mm256_cmp_pd(of_axes, first, _CMP_EQ_OQ)));
  const double time_of_first = _mm256_cvtsd_f64(_mm256_max_pd(first, zero));
  const int leaves = static_cast<int>(time_of_first < std::numeric_limits<double>::infinity());
  const int sign = static_cast<int>(simd::bits(is_forward) >> axis & 1U) * 2 - 1;
  return {time_of_first, axis * leaves, sign * leaves};
}

}  // namespace

#else

namespace {

/// Not called: there are no wide lanes.
template <int Dim>
NextFace<double> find_next_face(const Sphere<Dim, double>& sphere, const Steps<Dim>& cell,
                                const CellWidths<double>& widths, double when) {
  return next_face<Dim>(sphere, cell, widths, when);
}

}  // namespace

#endif

template <int Dim>
NextFace<double> next_face_wide(const Sphere<Dim, double>& sphere, const Steps<Dim>& cell,
                                const CellWidths<double>& widths, double when) {
  return find_next_face<Dim>(sphere, cell, widths, when);
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                            \
  template NextFace<double> next_face_wide<Dim>(const Sphere<Dim, double>&, const Steps<Dim>&, \
                                                const CellWidths<double>&, double);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
