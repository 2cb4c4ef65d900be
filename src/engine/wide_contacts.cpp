#include "engine/wide_contacts.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "engine/wide_lanes.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

#ifdef ZENOSPHERE_HAS_WIDE_LANES

namespace {

constexpr double no_contact = std::numeric_limits<double>::infinity();

/// Reads four numbers of each of four things, and puts the same number of all side by side.
ZENOSPHERE_WIDE inline void read_columns(const double* a, const double* b, const double* c,
                                         const double* d, __m256d* columns) {
  const __m256d low_ab = _mm256_unpacklo_pd(_mm256_loadu_pd(a), _mm256_loadu_pd(b));
  const __m256d high_ab = _mm256_unpackhi_pd(_mm256_loadu_pd(a), _mm256_loadu_pd(b));
  const __m256d low_cd = _mm256_unpacklo_pd(_mm256_loadu_pd(c), _mm256_loadu_pd(d));
  const __m256d high_cd = _mm256_unpackhi_pd(_mm256_loadu_pd(c), _mm256_loadu_pd(d));
  columns[0] = _mm256_permute2f128_pd(low_ab, low_cd, 0x20);
  columns[1] = _mm256_permute2f128_pd(high_ab, high_cd, 0x20);
  columns[2] = _mm256_permute2f128_pd(low_ab, low_cd, 0x31);
  columns[3] = _mm256_permute2f128_pd(high_ab, high_cd, 0x31);
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

/// The least of four, in all lanes.
ZENOSPHERE_WIDE inline __m256d least_of_all(__m256d lanes) {
  lanes = _mm256_min_pd(lanes, _mm256_permute2f128_pd(lanes, lanes, 1));
  return _mm256_min_pd(lanes, _mm256_permute_pd(lanes, 0b0101));
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
    return reinterpret_cast<const double*>(images + neighbours[lane].way().code());
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

/// The approaches of up to `most` neighbours, by their numbers.
class NumberedApproaches {
 public:
  static constexpr std::size_t most = most_first_contacts;

  ZENOSPHERE_WIDE void put(std::size_t number, const Approaches& four) {
    _mm256_store_pd(b_ + number, four.b);
    _mm256_store_pd(v2_ + number, four.v2);
    _mm256_store_pd(r2_ + number, four.r2);
  }
  ZENOSPHERE_WIDE Approaches of(const std::array<std::size_t, 4>& numbers) const {
    const auto [i, j, k, l] = numbers;
    return {_mm256_set_pd(b_[l], b_[k], b_[j], b_[i]),
            _mm256_set_pd(v2_[l], v2_[k], v2_[j], v2_[i]),
            _mm256_set_pd(r2_[l], r2_[k], r2_[j], r2_[i])};
  }

  /// Stands for nobody: two that rest apart never touch.
  static constexpr int nobody = 63;
  void put_nobody() {
    b_[nobody] = v2_[nobody] = 0;
    r2_[nobody] = 4;
  }

 private:
  alignas(32) double b_[64];
  alignas(32) double v2_[64];
  alignas(32) double r2_[64];
};

/// Mean diameters of unit spheres, which cost nothing.
struct UnitSigmas {
  ZENOSPHERE_WIDE __m256d put(std::size_t, const Neighbour*) { return _mm256_set1_pd(1); }
  ZENOSPHERE_WIDE __m256d of(const std::array<std::size_t, 4>&) const { return _mm256_set1_pd(1); }
};

/// Mean diameters of one sphere and each of up to NumberedApproaches::most neighbours.
class NumberedSigmas {
 public:
  NumberedSigmas(const double* radii, std::int32_t own) : radii_(radii), own_(radii[own]) {
    sigma_[NumberedApproaches::nobody] = 1;
  }
  ZENOSPHERE_WIDE __m256d put(std::size_t number, const Neighbour* neighbours) {
    const __m256d sigma = _mm256_add_pd(_mm256_set1_pd(own_), radii_of(radii_, neighbours));
    _mm256_store_pd(sigma_ + number, sigma);
    return sigma;
  }
  ZENOSPHERE_WIDE __m256d of(const std::array<std::size_t, 4>& numbers) const {
    const auto [i, j, k, l] = numbers;
    return _mm256_set_pd(sigma_[l], sigma_[k], sigma_[j], sigma_[i]);
  }

 private:
  const double* radii_;
  double own_;
  alignas(32) double sigma_[64];
};

/// The first two in each lane, and the numbers they go by.
struct FirstTwoInLanes {
  __m256d first, second;        ///< times
  __m256d first_is, second_is;  ///< integers
  __m256d ties;                 ///< not zero where two had one time

  ZENOSPHERE_WIDE FirstTwoInLanes()
      : first(_mm256_set1_pd(no_contact)),
        second(first),
        first_is(_mm256_setzero_pd()),
        second_is(first_is),
        ties(first_is) {}

  ZENOSPHERE_WIDE void add(__m256d time, __m256d number) {
    ties = _mm256_or_pd(ties,
                        _mm256_and_pd(_mm256_cmp_pd(time, _mm256_set1_pd(no_contact), _CMP_LT_OQ),
                                      _mm256_or_pd(_mm256_cmp_pd(time, first, _CMP_EQ_OQ),
                                                   _mm256_cmp_pd(time, second, _CMP_EQ_OQ))));
    const __m256d is_first = _mm256_cmp_pd(time, first, _CMP_LT_OQ);
    const __m256d later = _mm256_blendv_pd(time, first, is_first);
    const __m256d later_is = _mm256_blendv_pd(number, first_is, is_first);
    first = _mm256_blendv_pd(first, time, is_first);
    first_is = _mm256_blendv_pd(first_is, number, is_first);
    const __m256d is_second = _mm256_cmp_pd(later, second, _CMP_LT_OQ);
    second = _mm256_blendv_pd(second, later, is_second);
    second_is = _mm256_blendv_pd(second_is, later_is, is_second);
  }
};

/// The one number of those in four lanes at which a bit is set.
ZENOSPHERE_WIDE inline std::size_t number_at(__m256d numbers, unsigned bit) {
  alignas(32) std::int64_t four[4];
  _mm256_store_si256(reinterpret_cast<__m256i*>(four), _mm256_castpd_si256(numbers));
  return static_cast<std::size_t>(four[std::countr_zero(bit)]);
}

ZENOSPHERE_WIDE inline unsigned bits(__m256d lanes) {
  return static_cast<unsigned>(_mm256_movemask_pd(lanes));
}

/// The first two of all lanes; or nothing where equal times do not tell which they are.
ZENOSPHERE_WIDE inline std::optional<FirstContacts<double>> first_of_all(
    const FirstTwoInLanes& lanes, int meetings, std::span<const Neighbour> neighbours) {
  FirstContacts<double> two;
  two.meetings = meetings;
  if (meetings == 0) return two;
  const __m256d first = least_of_all(lanes.first);
  const __m256d is_first = _mm256_cmp_pd(lanes.first, first, _CMP_EQ_OQ);
  two.first_time = _mm256_cvtsd_f64(first);
  two.first = neighbours[number_at(lanes.first_is, bits(is_first))].sphere();
  if (meetings == 1) return two;
  const __m256d rest = _mm256_blendv_pd(lanes.first, lanes.second, is_first);
  const __m256d rest_is = _mm256_blendv_pd(lanes.first_is, lanes.second_is, is_first);
  const __m256d second = least_of_all(rest);
  const unsigned is_second = bits(_mm256_cmp_pd(rest, second, _CMP_EQ_OQ));
  two.second_time = _mm256_cvtsd_f64(second);
  two.second = neighbours[number_at(rest_is, is_second)].sphere();
  const bool is_tied = bits(lanes.ties) != 0 || !std::has_single_bit(bits(is_first)) ||
                       !std::has_single_bit(is_second);
  if (is_tied) [[unlikely]]
    return std::nullopt;
  return two;
}

template <int Dim, class Sigmas>
ZENOSPHERE_WIDE std::optional<FirstContacts<double>> first_contacts(
    const Sphere<Dim, double>* spheres, std::span<const Neighbour> neighbours,
    const Image<Dim, double>* images, const Viewpoint<Dim, double>& from, Sigmas& sigmas) {
  const std::size_t size = neighbours.size();
  if (size > NumberedApproaches::most) return std::nullopt;
  NumberedApproaches approaches;
  std::uint64_t candidates = 0;
  for (std::size_t k = 0; k < size; k += 4) {
    const Approaches four = zenosphere::approaches(spheres, neighbours.data() + k, images, from);
    approaches.put(k, four);
    const __m256d sigma = sigmas.put(k, neighbours.data() + k);
    candidates |= static_cast<std::uint64_t>(bits(may_touch(four, sigma))) << k;
  }
  candidates &= (std::uint64_t{1} << size) - 1;
  approaches.put_nobody();
  const __m256d when = _mm256_set1_pd(from.when);
  FirstTwoInLanes lanes;
  __m256d overlaps = _mm256_setzero_pd();
  int meetings = 0;
  while (candidates != 0) {
    std::array<std::size_t, 4> numbers;
    for (std::size_t& number : numbers) {
      constexpr std::uint64_t nobody = std::uint64_t{1} << NumberedApproaches::nobody;
      number = static_cast<std::size_t>(std::countr_zero(candidates | nobody));
      candidates &= candidates - 1;
    }
    const __m256d time = contact_times(approaches.of(numbers), sigmas.of(numbers));
    overlaps = _mm256_or_pd(overlaps, _mm256_cmp_pd(time, _mm256_setzero_pd(), _CMP_NGT_UQ));
    const __m256d then = _mm256_add_pd(when, time);
    meetings += std::popcount(bits(_mm256_cmp_pd(then, _mm256_set1_pd(no_contact), _CMP_LT_OQ)));
    const auto [i, j, k, l] = numbers;
    lanes.add(then, _mm256_castsi256_pd(_mm256_set_epi64x(
                        static_cast<std::int64_t>(l), static_cast<std::int64_t>(k),
                        static_cast<std::int64_t>(j), static_cast<std::int64_t>(i))));
  }
  if (bits(overlaps) != 0) [[unlikely]]
    return std::nullopt;
  return first_of_all(lanes, meetings, neighbours);
}

}  // namespace

#else

namespace {

/// Not called: there are no wide lanes.
std::optional<FirstContacts<double>> first_contacts(const auto&...) { return std::nullopt; }
struct UnitSigmas {};
struct NumberedSigmas {
  NumberedSigmas(const double*, std::int32_t) {}
};

}  // namespace

#endif

template <int Dim>
std::optional<FirstContacts<double>> first_contacts_wide(const Sphere<Dim, double>* spheres,
                                                         std::span<const Neighbour> neighbours,
                                                         const Image<Dim, double>* images,
                                                         const Viewpoint<Dim, double>& viewpoint) {
  UnitSigmas sigmas;
  return first_contacts(spheres, neighbours, images, viewpoint, sigmas);
}

template <int Dim>
std::optional<FirstContacts<double>> first_contacts_wide(const Sphere<Dim, double>* spheres,
                                                         std::span<const Neighbour> neighbours,
                                                         const Image<Dim, double>* images,
                                                         const Viewpoint<Dim, double>& viewpoint,
                                                         const double* radii, std::int32_t own) {
  NumberedSigmas sigmas(radii, own);
  return first_contacts(spheres, neighbours, images, viewpoint, sigmas);
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                      \
  template std::optional<FirstContacts<double>> first_contacts_wide(                     \
      const Sphere<Dim, double>*, std::span<const Neighbour>, const Image<Dim, double>*, \
      const Viewpoint<Dim, double>&);                                                    \
  template std::optional<FirstContacts<double>> first_contacts_wide(                     \
      const Sphere<Dim, double>*, std::span<const Neighbour>, const Image<Dim, double>*, \
      const Viewpoint<Dim, double>&, const double*, std::int32_t);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
