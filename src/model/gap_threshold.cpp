#include "model/gap_threshold.hpp"

#include <limits>
#include <stdexcept>

#include "model/digits.hpp"

namespace zenosphere {

namespace {

constexpr int double_bits = std::numeric_limits<double>::digits;
constexpr int least_exponent = std::numeric_limits<double>::min_exponent;  // of 0.1..., in frexp
constexpr int most_halvings = 1'000'000;  // 1e-301030: the most digits need 1e-10001

}  // namespace

GapThreshold::GapThreshold(double factor, int halvings) : factor_(factor) {
  int exponent = 0;
  const double rest = std::frexp(factor, &exponent);
  if (exponent - halvings >= least_exponent) {
    factor_ = std::ldexp(factor, -halvings);
    return;
  }
  factor_ = 2 * rest;
  halvings_ = halvings - (exponent - 1);
}

std::optional<GapThreshold> GapThreshold::from_text(const std::string& decimal) {
  const WorkingPrecision of_double(double_bits);
  try {
    const Digits number(decimal);
    if (!(number >= ldexp(Digits(1), -most_halvings)) || isinf(number)) return std::nullopt;
    int exponent = 0;
    const auto rest = static_cast<double>(frexp(number, &exponent));
    if (exponent > std::numeric_limits<double>::max_exponent) return std::nullopt;
    return GapThreshold(rest, -exponent);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

std::string GapThreshold::text() const {
  const WorkingPrecision of_double(double_bits);
  const Digits number = in<Digits>();
  std::string text;
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    text = number.str(digits);
    if (Digits(text) == number) break;
  }
  return text;
}

double GapThreshold::nearest_double() const {
  return std::fmax(std::ldexp(factor_, -halvings_), std::numeric_limits<double>::denorm_min());
}

}  // namespace zenosphere
