#pragma once

#include <array>
#include <string_view>

#include "model/case_key.hpp"
#include "model/real.hpp"

namespace zenosphere {

/// Coefficient of restitution of two spheres that has one value below a speed and another one from
/// there on.
///
/// Source: Kikuchi, Kobayashi & Takada, arXiv 2603.19605 (2026).
template <class Real>
struct TwoValuedRestitution {
  Real slow;       ///< in [0, 1]
  Real fast;       ///< in [0, 1]
  Real threshold;  ///< > 0, diameters/time

  /// At which `check` shows it: its keys say it all.
  static constexpr std::array<double, 0> shown_speeds{};

  /// \param normal_speed  closing speed > 0, diameters/time
  Real operator()(const Real& normal_speed) const { return normal_speed < threshold ? slow : fast; }
};

/// That law as a case has it.
struct TwoValuedLaw {
  static constexpr std::string_view word = "two-valued";
  double slow_restitution = 0;  ///< below the threshold
  double fast_restitution = 0;  ///< from the threshold on
  double threshold_speed = 0;   ///< diameters/time

  template <class Visitor>
  void keys(Visitor&& visit) {
    using namespace case_format;
    visit(CaseKey{"slow_restitution", required, from_to(0, 1, "1 is elastic"),
                  "normal speed after a collision / before, below the threshold"},
          slow_restitution);
    visit(CaseKey{"fast_restitution", required, from_to(0, 1, "1 is elastic"),
                  "the same from the threshold on"},
          fast_restitution);
    visit(CaseKey{"threshold_speed", required, above(0),
                  "closing speed along the normal at which the restitution changes "
                  "[diameters/time]"},
          threshold_speed);
  }

  template <class Real>
  TwoValuedRestitution<Real> in() const {
    return {from_decimal<Real>(slow_restitution), from_decimal<Real>(fast_restitution),
            from_decimal<Real>(threshold_speed)};
  }
};

}  // namespace zenosphere
