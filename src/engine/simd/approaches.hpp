#pragma once

#include <cstddef>
#include <limits>

#include "engine/contacts_ahead.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/simd/wide_lanes.hpp"
#include "engine/sphere.hpp"
#include "model/contact.hpp"
#include "model/shear_box.hpp"

#ifdef ZENOSPHERE_HAS_WIDE_LANES

/// What contact() works out for one neighbour (model/contact.hpp), for four at a time: the same
/// operations in the same order.
namespace zenosphere::simd {

inline constexpr double no_contact = std::numeric_limits<double>::infinity();

/// Two numbers that stand at `low`, and two that stand at `high`.
ZENOSPHERE_WIDE inline __m256d read_halves(const double* low, const double* high) {
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(low)), _mm_loadu_pd(high), 1);
}

/// Reads four numbers of each of four things, and puts the same number of all side by side. A
/// processor can read halves of a register faster than it can move them.
ZENOSPHERE_WIDE inline void read_columns(const double* a, const double* b, const double* c,
                                         const double* d, __m256d* columns) {
  const __m256d first_ac = read_halves(a, c);
  const __m256d first_bd = read_halves(b, d);
  const __m256d last_ac = read_halves(a + 2, c + 2);
  const __m256d last_bd = read_halves(b + 2, d + 2);
  columns[0] = _mm256_unpacklo_pd(first_ac, first_bd);
  columns[1] = _mm256_unpackhi_pd(first_ac, first_bd);
  columns[2] = _mm256_unpacklo_pd(last_ac, last_bd);
  columns[3] = _mm256_unpackhi_pd(last_ac, last_bd);
}

/// The numbers of four spheres: positions, velocities and times.
template <int Dim>
struct FourSpheres {
  static constexpr int numbers = 2 * Dim + 1;
  __m256d columns[(numbers + 3) / 4 * 4];  // read four at a time; those behind count for nothing

  ZENOSPHERE_WIDE __m256d position(int axis) const { return columns[axis]; }
  ZENOSPHERE_WIDE __m256d velocity(int axis) const { return columns[Dim + axis]; }
  ZENOSPHERE_WIDE __m256d time() const { return columns[2 * Dim]; }
};

/// Four dot products, each added up as dot() does.
template <int Dim>
ZENOSPHERE_WIDE inline __m256d dot(const __m256d (&a)[Dim], const __m256d (&b)[Dim]) {
  __m256d sum = _mm256_mul_pd(a[0], b[0]);
  for (int axis = 1; axis < Dim; ++axis) {
    sum = _mm256_add_pd(sum, _mm256_mul_pd(a[axis], b[axis]));
  }
  return sum;
}

/// dr.dv, dv.dv and dr.dr of four neighbours.
struct Approaches {
  __m256d b, v2, r2;
};

template <int Dim>
ZENOSPHERE_WIDE inline Approaches approaches(const Sphere<Dim, double>* spheres,
                                             const Neighbour* neighbours,
                                             const Image<Dim, double>* images,
                                             const Viewpoint<Dim, double>& from) {
  const auto sphere = [&](std::size_t lane) {
    return reinterpret_cast<const double*>(spheres + neighbours[lane].sphere());
  };
  const auto image = [&](std::size_t lane) {
    return reinterpret_cast<const double*>(images + neighbours[lane].periodic_image().code());
  };
  FourSpheres<Dim> four;
  for (int k = 0; k < FourSpheres<Dim>::numbers; k += 4) {
    read_columns(sphere(0) + k, sphere(1) + k, sphere(2) + k, sphere(3) + k, four.columns + k);
  }
  __m256d shift[4];  // along each axis, and behind them the velocity
  read_columns(image(0), image(1), image(2), image(3), shift);
  const __m256d slide = shift[Dim];
  const __m256d when = _mm256_set1_pd(from.when);
  const __m256d flight = _mm256_sub_pd(when, four.time());
  shift[0] = _mm256_add_pd(shift[0], _mm256_mul_pd(slide, when));
  __m256d dr[Dim];
  __m256d dv[Dim];
  for (int axis = 0; axis < Dim; ++axis) {
    const __m256d velocity = four.velocity(axis);
    const __m256d place = _mm256_add_pd(four.position(axis), _mm256_mul_pd(velocity, flight));
    dr[axis] =
        _mm256_add_pd(_mm256_sub_pd(place, _mm256_set1_pd(from.position[axis])), shift[axis]);
    dv[axis] = _mm256_sub_pd(velocity, _mm256_set1_pd(from.velocity[axis]));
  }
  dv[0] = _mm256_add_pd(dv[0], slide);
  return {dot(dr, dv), dot(dv, dv), dot(dr, dr)};
}

/// Radii of four neighbours.
ZENOSPHERE_WIDE inline __m256d radii_of(const double* radii, const Neighbour* neighbours) {
  const auto radius = [&](std::size_t lane) { return radii[neighbours[lane].sphere()]; };
  return _mm256_set_pd(radius(3), radius(2), radius(1), radius(0));
}

/// What may_touch() says of four: all bits of a lane, or none.
ZENOSPHERE_WIDE inline __m256d may_touch(const Approaches& four, __m256d sigma) {
  const auto& [b, v2, r2] = four;
  const __m256d limit = _mm256_add_pd(_mm256_mul_pd(sigma, sigma), _mm256_set1_pd(approach_margin));
  return _mm256_and_pd(
      _mm256_cmp_pd(b, _mm256_setzero_pd(), _CMP_LT_OQ),
      _mm256_cmp_pd(_mm256_mul_pd(b, b), _mm256_mul_pd(v2, _mm256_sub_pd(r2, limit)), _CMP_GE_OQ));
}

/// When contact() lets four touch, of which it is known that they may; infinity: they miss.
ZENOSPHERE_WIDE inline __m256d contact_times(const Approaches& four, __m256d sigma) {
  const auto& [b, v2, r2] = four;
  const __m256d distance = _mm256_sqrt_pd(r2);
  const __m256d c = _mm256_mul_pd(_mm256_sub_pd(distance, sigma), _mm256_add_pd(distance, sigma));
  const __m256d discriminant = _mm256_sub_pd(_mm256_mul_pd(b, b), _mm256_mul_pd(v2, c));
  const __m256d time = _mm256_div_pd(
      c, _mm256_add_pd(_mm256_xor_pd(b, _mm256_set1_pd(-0.0)), _mm256_sqrt_pd(discriminant)));
  const __m256d misses = _mm256_cmp_pd(discriminant, _mm256_setzero_pd(), _CMP_LT_OQ);
  return _mm256_blendv_pd(time, _mm256_set1_pd(no_contact), misses);
}

}  // namespace zenosphere::simd

#endif
