#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "model/precision.hpp"

namespace zenosphere {

/// The threshold of the separation criterion, in diameters: a positive number with the digits of a
/// `double` and no limit to how small it is. A thousand digits need one of 1e-1001, while `double`
/// ends at 1e-308.
class GapThreshold {
 public:
  GapThreshold(double diameters) : GapThreshold(diameters, 0) {}  // NOLINT: it is a number

  /// 1e-16 in `double`, and in any other precision smaller by as much as its rounding is.
  explicit GapThreshold(Precision precision) : GapThreshold(1e-16, precision.bits() - 53) {}

  /// Reads a decimal text; nothing if it is no finite number above 0.
  static std::optional<GapThreshold> from_text(const std::string& decimal);

  /// The shortest decimal text that from_text() reads as the same number.
  std::string text() const;

  template <class Real>
  Real in() const {
    using std::ldexp;
    return ldexp(Real(factor_), -halvings_);
  }

  /// As a `double`; 5e-324, the least there is above 0, where it is smaller.
  double nearest_double() const;

  /// Whether it is in the range of `double`.
  bool fits_double() const { return halvings_ == 0; }

  double log10() const { return std::log10(factor_) - halvings_ * std::log10(2.0); }

  friend bool operator==(const GapThreshold&, const GapThreshold&) = default;
  friend bool operator<(const GapThreshold& a, const GapThreshold& b) {
    return a.halvings_ != b.halvings_ ? b.halvings_ < a.halvings_ : a.factor_ < b.factor_;
  }

 private:
  GapThreshold(double factor, int halvings);

  double factor_;     ///< in [1, 2) where halvings_ is not 0
  int halvings_ = 0;  ///< 0 where the number is a `double` with all its digits
};

}  // namespace zenosphere
