#include "engine/wide_contacts.hpp"

#include <bit>
#include <limits>

#include "engine/wide_lanes.hpp"

namespace zenosphere {

#ifdef ZENOSPHERE_HAS_WIDE_LANES

namespace {

/// For each set of four lanes the numbers of those in it, first to last: of doubles as pairs of
/// halves, and of 32-bit numbers.
struct Compressions {
  alignas(32) std::int32_t doubles[16][8];
  alignas(16) std::int32_t numbers[16][4];

  constexpr Compressions() : doubles(), numbers() {
    for (int set = 0; set < 16; ++set) {
      int kept = 0;
      for (int lane = 0; lane < 4; ++lane) {
        if ((set >> lane & 1) == 0) continue;
        doubles[set][2 * kept] = 2 * lane;
        doubles[set][2 * kept + 1] = 2 * lane + 1;
        numbers[set][kept++] = lane;
      }
    }
  }
};
constexpr Compressions compressions;

ZENOSPHERE_WIDE inline __m256d compressed(__m256d lanes, unsigned set) {
  const __m256i order =
      _mm256_load_si256(reinterpret_cast<const __m256i*>(compressions.doubles[set]));
  return _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(lanes), order));
}

ZENOSPHERE_WIDE inline __m128i compressed(__m128i lanes, unsigned set) {
  const __m128i order = _mm_load_si128(reinterpret_cast<const __m128i*>(compressions.numbers[set]));
  return _mm_castps_si128(_mm_permutevar_ps(_mm_castsi128_ps(lanes), order));
}

/// The same numbers of four things, side by side.
struct Columns {
  __m256d first, second, third, fourth;
};
ZENOSPHERE_WIDE inline Columns columns(const double* a, const double* b, const double* c,
                                       const double* d) {
  const __m256d low_ab = _mm256_unpacklo_pd(_mm256_loadu_pd(a), _mm256_loadu_pd(b));
  const __m256d high_ab = _mm256_unpackhi_pd(_mm256_loadu_pd(a), _mm256_loadu_pd(b));
  const __m256d low_cd = _mm256_unpacklo_pd(_mm256_loadu_pd(c), _mm256_loadu_pd(d));
  const __m256d high_cd = _mm256_unpackhi_pd(_mm256_loadu_pd(c), _mm256_loadu_pd(d));
  return {
      _mm256_permute2f128_pd(low_ab, low_cd, 0x20), _mm256_permute2f128_pd(high_ab, high_cd, 0x20),
      _mm256_permute2f128_pd(low_ab, low_cd, 0x31), _mm256_permute2f128_pd(high_ab, high_cd, 0x31)};
}

ZENOSPHERE_WIDE inline __m256d dot(__m256d ax, __m256d ay, __m256d az, __m256d bx, __m256d by,
                                   __m256d bz) {
  return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(ax, bx), _mm256_mul_pd(ay, by)),
                       _mm256_mul_pd(az, bz));
}

/// Where they are after their flight, seen from a place.
ZENOSPHERE_WIDE inline __m256d apart(__m256d place, __m256d velocity, __m256d flight, double here) {
  return _mm256_sub_pd(_mm256_add_pd(place, _mm256_mul_pd(velocity, flight)), _mm256_set1_pd(here));
}

/// The least of four, in all lanes.
ZENOSPHERE_WIDE inline __m256d least_of_all(__m256d lanes) {
  lanes = _mm256_min_pd(lanes, _mm256_permute2f128_pd(lanes, lanes, 1));
  return _mm256_min_pd(lanes, _mm256_permute_pd(lanes, 0b0101));
}

}  // namespace

ZENOSPHERE_WIDE FirstTwo first_two_wide(ContactsAhead<double>& ahead, double now) {
  const __m256d never = _mm256_set1_pd(std::numeric_limits<double>::infinity());
  double* const times = ahead.time.data();
  const std::size_t count = ahead.count;
  FirstTwo two;
  if (count == 0) return two;
  if (count > 60) return first_two(ahead, now);
  _mm256_storeu_pd(times + count, never);
  const __m256d here = _mm256_set1_pd(now);
  __m256d least = never;  // as the second operand of min: a time that is no number does not count
  for (std::size_t k = 0; k < count; k += 4)
    least = _mm256_min_pd(_mm256_add_pd(here, _mm256_loadu_pd(times + k)), least);
  least = least_of_all(least);
  std::uint64_t at = 0;
  __m256d next = never;
  for (std::size_t k = 0; k < count; k += 4) {
    const __m256d t = _mm256_add_pd(here, _mm256_loadu_pd(times + k));
    const __m256d is_least = _mm256_cmp_pd(t, least, _CMP_EQ_OQ);
    at |= static_cast<std::uint64_t>(_mm256_movemask_pd(is_least)) << k;
    two.meetings += __builtin_popcount(
        static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(t, never, _CMP_LT_OQ))));
    next = _mm256_min_pd(_mm256_blendv_pd(t, never, is_least), next);
  }
  if (two.meetings == 0) return two;
  if ((at & (at - 1)) != 0) [[unlikely]]
    return first_two(ahead, now);
  two.first = std::countr_zero(at);
  if (two.meetings == 1) return two;
  next = least_of_all(next);
  std::uint64_t after = 0;
  for (std::size_t k = 0; k < count; k += 4) {
    after |= static_cast<std::uint64_t>(_mm256_movemask_pd(
                 _mm256_cmp_pd(_mm256_add_pd(here, _mm256_loadu_pd(times + k)), next, _CMP_EQ_OQ)))
             << k;
  }
  if ((after & (after - 1)) != 0) [[unlikely]]
    return first_two(ahead, now);
  two.second = std::countr_zero(after);
  return two;
}

namespace {

/// Those that may touch, as may_touch() says of each, behind the contacts already found; with
/// dr.dr where their times will be.
/// @return how many.
ZENOSPHERE_WIDE inline std::size_t add_those_that_may_touch(const Sphere<3, double>* spheres,
                                                            std::span<const Neighbour> neighbours,
                                                            const Image<3, double>* images,
                                                            const Viewpoint<3, double>& from,
                                                            ContactsAhead<double>& ahead) {
  constexpr std::uint32_t numbers = Neighbour::sphere_mask;
  const __m256d when = _mm256_set1_pd(from.when);
  const __m256d limit = _mm256_set1_pd(1 + approach_margin);
  const __m256d zero = _mm256_setzero_pd();
  std::size_t end = ahead.count;
  const auto size = static_cast<std::ptrdiff_t>(neighbours.size());
  const auto* const packed = reinterpret_cast<const std::uint32_t*>(neighbours.data());
  for (std::ptrdiff_t first = 0; first < size; first += 4) {
    const std::uint32_t* const some = packed + first;
    const auto sphere = [&](std::size_t lane) {
      return reinterpret_cast<const double*>(spheres + (some[lane] & numbers));
    };
    const auto image = [&](std::size_t lane) {
      return reinterpret_cast<const double*>(images + (some[lane] >> Neighbour::sphere_bits));
    };
    const auto [x, y, z, vx] = columns(sphere(0), sphere(1), sphere(2), sphere(3));
    const auto [vy, vz, time, rest] =
        columns(sphere(0) + 4, sphere(1) + 4, sphere(2) + 4, sphere(3) + 4);
    const auto [sx, sy, sz, slide] = columns(image(0), image(1), image(2), image(3));
    const __m256d flight = _mm256_sub_pd(when, time);
    const __m256d dx = _mm256_add_pd(apart(x, vx, flight, from.position[0]),
                                     _mm256_add_pd(sx, _mm256_mul_pd(slide, when)));
    const __m256d dy = _mm256_add_pd(apart(y, vy, flight, from.position[1]), sy);
    const __m256d dz = _mm256_add_pd(apart(z, vz, flight, from.position[2]), sz);
    const __m256d du = _mm256_add_pd(_mm256_sub_pd(vx, _mm256_set1_pd(from.velocity[0])), slide);
    const __m256d dv = _mm256_sub_pd(vy, _mm256_set1_pd(from.velocity[1]));
    const __m256d dw = _mm256_sub_pd(vz, _mm256_set1_pd(from.velocity[2]));
    const __m256d b = dot(dx, dy, dz, du, dv, dw);
    const __m256d v2 = dot(du, dv, dw, du, dv, dw);
    const __m256d r2 = dot(dx, dy, dz, dx, dy, dz);
    const __m256d touch =
        _mm256_and_pd(_mm256_cmp_pd(b, zero, _CMP_LT_OQ),
                      _mm256_cmp_pd(_mm256_mul_pd(b, b),
                                    _mm256_mul_pd(v2, _mm256_sub_pd(r2, limit)), _CMP_GE_OQ));
    unsigned set = static_cast<unsigned>(_mm256_movemask_pd(touch));
    if (size - first < 4) set &= (1U << (size - first)) - 1;
    const __m128i partners = _mm_and_si128(_mm_loadu_si128(reinterpret_cast<const __m128i*>(some)),
                                           _mm_set1_epi32(static_cast<int>(numbers)));
    _mm256_storeu_pd(ahead.approach.data() + end, compressed(b, set));
    _mm256_storeu_pd(ahead.speed_squared.data() + end, compressed(v2, set));
    _mm256_storeu_pd(ahead.time.data() + end, compressed(r2, set));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(ahead.partner.data() + end),
                     compressed(partners, set));
    end += static_cast<std::size_t>(__builtin_popcount(set));
  }
  return end - ahead.count;
}

/// When the contacts from `begin` up to `end` come, as contact() says of each, in place of dr.dr.
ZENOSPHERE_WIDE inline void find_when_they_touch(ContactsAhead<double>& ahead, std::size_t begin,
                                                 std::size_t end) {
  const __m256d zero = _mm256_setzero_pd();
  const __m256d one = _mm256_set1_pd(1);
  const __m256d never = _mm256_set1_pd(std::numeric_limits<double>::infinity());
  const __m256d sign = _mm256_set1_pd(-0.0);
  unsigned overlaps = 0;
  for (std::size_t k = begin; k < end; k += 4) {
    double* const times = ahead.time.data() + k;
    const __m256d b = _mm256_loadu_pd(ahead.approach.data() + k);
    const __m256d v2 = _mm256_loadu_pd(ahead.speed_squared.data() + k);
    const __m256d distance = _mm256_sqrt_pd(_mm256_loadu_pd(times));
    const __m256d c = _mm256_mul_pd(_mm256_sub_pd(distance, one), _mm256_add_pd(distance, one));
    const __m256d discriminant = _mm256_sub_pd(_mm256_mul_pd(b, b), _mm256_mul_pd(v2, c));
    const __m256d time =
        _mm256_div_pd(c, _mm256_add_pd(_mm256_xor_pd(b, sign), _mm256_sqrt_pd(discriminant)));
    const __m256d misses = _mm256_cmp_pd(discriminant, zero, _CMP_LT_OQ);
    unsigned over = static_cast<unsigned>(
        _mm256_movemask_pd(_mm256_andnot_pd(misses, _mm256_cmp_pd(c, zero, _CMP_LE_OQ))));
    if (end - k < 4) over &= (1U << (end - k)) - 1;
    overlaps |= over;
    _mm256_storeu_pd(times, _mm256_blendv_pd(time, never, misses));
  }
  ahead.has_overlaps |= overlaps != 0;
}

}  // namespace

ZENOSPHERE_WIDE void find_contacts_wide(const Sphere<3, double>* spheres,
                                        std::span<const Neighbour> neighbours,
                                        const Image<3, double>* images,
                                        const Viewpoint<3, double>& from,
                                        ContactsAhead<double>& ahead) {
  ahead.make_room(neighbours.size());
  const std::size_t begin = ahead.count;
  ahead.count += add_those_that_may_touch(spheres, neighbours, images, from, ahead);
  find_when_they_touch(ahead, begin, ahead.count);
}

#else

void find_contacts_wide(const Sphere<3, double>*, std::span<const Neighbour>,
                        const Image<3, double>*, const Viewpoint<3, double>&,
                        ContactsAhead<double>&) {}
FirstTwo first_two_wide(ContactsAhead<double>& ahead, double now) { return first_two(ahead, now); }

#endif

}  // namespace zenosphere
