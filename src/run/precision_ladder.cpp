#include "run/precision_ladder.hpp"

#include <algorithm>
#include <numbers>

namespace zenosphere {
namespace {

constexpr int usual_digits = 100;

int digits_of(Precision precision) {
  return static_cast<int>(precision.bits() * std::numbers::log10e_v<double> * std::numbers::ln2);
}

}  // namespace

Precision first_judge(Precision own) {
  const Precision usual = Precision::digits(usual_digits);
  return own < usual ? usual : doubled(own).value_or(own);
}

std::optional<Precision> doubled(Precision precision) {
  const int digits = 2 * digits_of(precision);
  return digits <= most_digits ? std::optional(Precision::digits(digits)) : std::nullopt;
}

std::vector<Precision> precision_ladder(Precision own, Precision named, Precision highest) {
  std::vector<Precision> ladder{own, Precision::double_precision, Precision::extended,
                                Precision::quad, Precision::digits(usual_digits)};
  for (std::optional<Precision> more = named; more && !(highest < *more); more = doubled(*more)) {
    ladder.push_back(*more);
  }
  std::erase_if(ladder, [&](Precision one) { return one < own || highest < one; });
  std::sort(ladder.begin(), ladder.end());
  ladder.erase(std::unique(ladder.begin(), ladder.end()), ladder.end());
  return ladder;
}

}  // namespace zenosphere
