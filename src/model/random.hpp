#pragma once

#include <cmath>
#include <cstdint>
#include <locale>
#include <random>
#include <sstream>
#include <string>

#include "model/archive.hpp"

namespace zenosphere {

/// Natural logarithm from additions, products and one exact decomposition of the exponent.
///
/// The C library picks its version of std::log by processor, and their last bits may differ; a
/// start must be the same on every machine. Good to 2e-16 relative for x away from 1.
///
/// \param x  > 0, finite
/// Source: ln m = 2 artanh((m - 1)/(m + 1)), Abramowitz & Stegun 4.1.27.
inline double portable_log(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);  // in [1/2, 1)
  if (mantissa < 0.70710678118654752) {
    mantissa *= 2;
    --exponent;
  }
  const double z = (mantissa - 1) / (mantissa + 1);  // |z| < 0.172: z^22 < 2^-53
  double sum = 0;
  for (int power = 23; power >= 1; power -= 2) sum = sum * z * z + 1.0 / power;
  return exponent * 0.69314718055994531 + 2 * z * sum;
}

/// A stream of random numbers that is the same on every machine.
///
/// The generator is fixed by the C++ standard; the transforms are our own because the standard's
/// distributions are not fixed.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  /// Uniform in [0, 1), on the grid of 2^-53.
  double uniform() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }

  /// Normal with mean 0 and variance 1.
  /// Source: polar method, Marsaglia & Bray, SIAM Rev. 6 (1964) 260.
  double normal() {
    for (;;) {
      const double u = 2 * uniform() - 1;
      const double v = 2 * uniform() - 1;
      const double s = u * u + v * v;
      if (s > 0 && s < 1) return u * std::sqrt(-2 * portable_log(s) / s);
    }
  }

  /// Uniform in {0, ..., count - 1}; the bias is below count / 2^53.
  std::int64_t below(std::int64_t count) {
    return static_cast<std::int64_t>(uniform() * static_cast<double>(count));
  }

  /// The generator as the text that the C++ standard fixes for it.
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    std::stringstream stream;
    stream.imbue(std::locale::classic());
    std::string text;
    if constexpr (!Archive::reads) {
      stream << self.generator_;
      text = stream.str();
    }
    archive(text);
    if constexpr (Archive::reads) {
      stream.str(text);
      stream >> self.generator_;
      require_archived(!stream.fail() && is_alive(self.generator_), "no random generator");
    }
  }

 private:
  /// Whether numbers other than zero will come. A state of zeros stays one for ever, and whoever
  /// asks it for a number until one suits would wait as long; no seed makes it.
  static bool is_alive(std::mt19937_64 generator) {
    std::uint64_t any = 0;
    for (std::size_t n = 0; n < 2 * std::mt19937_64::state_size; ++n) any |= generator();
    return any != 0;
  }

  std::mt19937_64 generator_;
};

}  // namespace zenosphere
