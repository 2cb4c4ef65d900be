#pragma once

#include <optional>
#include <stdexcept>

#include "case/case.hpp"
#include "model/real.hpp"

namespace zenosphere {

/// While it lives, numbers that this thread makes have the precision of a case.
class CasePrecision {
 public:
  explicit CasePrecision(const Case& values) {
    const Precision precision = values.collision.precision;
    if (precision.is_digits()) digits_.emplace(precision.bits());
  }

 private:
  std::optional<WorkingPrecision> digits_;
};

/// Calls `action.operator()<Dim, Real>()` for the dimension and the precision of a case: the only
/// place where they are chosen at run time. What makes numbers later, on this thread or another,
/// makes them under a CasePrecision of its own.
template <class Action>
auto in_arithmetic_of(const Case& values, Action action) {
  const auto with = [&]<class Real>(Real) {
    if (values.system.dimension == 1) return action.template operator()<1, Real>();
    if (values.system.dimension == 2) return action.template operator()<2, Real>();
    return action.template operator()<3, Real>();
  };
  const Precision precision = values.collision.precision;
#ifdef ZENOSPHERE_DOUBLE_ALONE  // see instantiate.hpp: there is no other engine
  if (precision != Precision::double_precision) throw std::logic_error("built in double alone");
#else
  if (precision.is_digits()) {
    const WorkingPrecision here(precision.bits());
    return with(Digits());
  }
  if (precision == Precision::quad) return with(Quad());
  if (precision == Precision::extended) return with(Extended());
#endif
  return with(double());
}

}  // namespace zenosphere
