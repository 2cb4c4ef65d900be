#include "result/uncertain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace zenosphere {
namespace {

/// The power of ten of the last digit that an error leaves.
int last_place(double error) {
  const int first = static_cast<int>(std::floor(std::log10(error)));
  const double digit = error / std::pow(10, first);
  return digit < 1.95 ? first - 1 : first;
}

}  // namespace

std::string with_error(double value, double error, int digits) {
  const bool is_known = std::isfinite(error) && error > 0 && std::isfinite(value);
  if (!is_known) return fmt::format("{:.{}g}", value, digits);
  const int place = last_place(error);
  const double size = std::max(std::abs(value), error);
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  const bool is_plain = exponent >= -4 && exponent < 6 && place <= 0;
  const int shift = is_plain ? 0 : exponent;
  const int decimals = std::max(shift - place, 0);
  const double scale = std::pow(10, shift);
  const auto units = std::llround(error / std::pow(10, shift - decimals));
  const std::string power = shift == 0 ? "" : fmt::format("e{:+03}", shift);
  return fmt::format("{:.{}f}({}){}", value / scale, decimals, units, power);
}

}  // namespace zenosphere
