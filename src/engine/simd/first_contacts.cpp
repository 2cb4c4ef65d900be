#include "engine/simd/first_contacts.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "engine/simd/approaches.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

#ifdef ZENOSPHERE_HAS_WIDE_LANES

namespace {

using namespace simd;

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

  /// Stands for no neighbour: two that rest apart never touch.
  static constexpr int no_neighbour = 63;
  void put_no_neighbour() {
    b_[no_neighbour] = v2_[no_neighbour] = 0;
    r2_[no_neighbour] = 4;
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
    sigma_[NumberedApproaches::no_neighbour] = 1;
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

/// What the contact times of neighbours tell, as they are added.
struct FoundContacts {
  FirstTwoInLanes lanes;
  __m256d overlaps;  ///< not zero where there is one
  int meetings = 0;

  ZENOSPHERE_WIDE FoundContacts() : overlaps(_mm256_setzero_pd()) {}

  /// \param time     of four from now; infinity: they miss
  /// \param numbers  which neighbours they are, as integers
  ZENOSPHERE_WIDE void add(__m256d time, __m256d when, __m256i numbers) {
    overlaps = _mm256_or_pd(overlaps, _mm256_cmp_pd(time, _mm256_setzero_pd(), _CMP_NGT_UQ));
    const __m256d then = _mm256_add_pd(when, time);
    meetings += std::popcount(bits(_mm256_cmp_pd(then, _mm256_set1_pd(no_contact), _CMP_LT_OQ)));
    lanes.add(then, _mm256_castsi256_pd(numbers));
  }

  /// The first two; or nothing where one overlaps, or equal times do not tell which they are.
  ZENOSPHERE_WIDE std::optional<FirstContacts<double>> first_two(
      std::span<const Neighbour> neighbours) const {
    if (bits(overlaps) != 0) [[unlikely]]
      return std::nullopt;
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
};

/// Of up to four neighbours.
template <int Dim, class Sigmas>
ZENOSPHERE_WIDE std::optional<FirstContacts<double>> first_of_few(
    const Sphere<Dim, double>* spheres, std::span<const Neighbour> neighbours,
    const Image<Dim, double>* images, const Viewpoint<Dim, double>& from, Sigmas& sigmas) {
  const Approaches four = simd::approaches(spheres, neighbours.data(), images, from);
  const __m256d sigma = sigmas.put(0, neighbours.data());
  const __m256i numbers = _mm256_setr_epi64x(0, 1, 2, 3);
  const __m256i size = _mm256_set1_epi64x(static_cast<std::int64_t>(neighbours.size()));
  const __m256d candidates =
      _mm256_and_pd(may_touch(four, sigma), _mm256_castsi256_pd(_mm256_cmpgt_epi64(size, numbers)));
  FoundContacts found;
  if (bits(candidates) != 0) {
    const __m256d time = contact_times(four, sigma);
    found.add(_mm256_blendv_pd(_mm256_set1_pd(no_contact), time, candidates),
              _mm256_set1_pd(from.when), numbers);
  }
  return found.first_two(neighbours);
}

template <int Dim, class Sigmas>
ZENOSPHERE_WIDE std::optional<FirstContacts<double>> first_contacts(
    const Sphere<Dim, double>* spheres, std::span<const Neighbour> neighbours,
    const Image<Dim, double>* images, const Viewpoint<Dim, double>& from, Sigmas& sigmas) {
  const std::size_t size = neighbours.size();
  if (size == 0) [[unlikely]]
    return FirstContacts<double>{};
  if (size <= 4) return first_of_few(spheres, neighbours, images, from, sigmas);
  if (size > NumberedApproaches::most) return std::nullopt;
  NumberedApproaches approaches;
  std::uint64_t candidates = 0;
  for (std::size_t k = 0; k < size; k += 4) {
    const Approaches four = simd::approaches(spheres, neighbours.data() + k, images, from);
    approaches.put(k, four);
    const __m256d sigma = sigmas.put(k, neighbours.data() + k);
    candidates |= static_cast<std::uint64_t>(bits(may_touch(four, sigma))) << k;
  }
  candidates &= (std::uint64_t{1} << size) - 1;
  approaches.put_no_neighbour();
  const __m256d when = _mm256_set1_pd(from.when);
  FoundContacts found;
  while (candidates != 0) {
    std::array<std::size_t, 4> numbers;
    for (std::size_t& number : numbers) {
      constexpr std::uint64_t no_neighbour = std::uint64_t{1} << NumberedApproaches::no_neighbour;
      number = static_cast<std::size_t>(std::countr_zero(candidates | no_neighbour));
      candidates &= candidates - 1;
    }
    const auto [i, j, k, l] = numbers;
    found.add(contact_times(approaches.of(numbers), sigmas.of(numbers)), when,
              _mm256_set_epi64x(static_cast<std::int64_t>(l), static_cast<std::int64_t>(k),
                                static_cast<std::int64_t>(j), static_cast<std::int64_t>(i)));
  }
  return found.first_two(neighbours);
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
