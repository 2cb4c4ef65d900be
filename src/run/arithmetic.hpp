#pragma once

#include "io/case.hpp"
#include "model/real.hpp"

namespace zenosphere {

/// Calls `action.operator()<Dim, Real>()` for the dimension and the precision of a case: the only
/// place where they are chosen at run time.
template <class Action>
auto in_arithmetic_of(const Case& values, Action action) {
  const auto with = [&]<class Real>(Real) {
    if (values.system.dimension == 1) return action.template operator()<1, Real>();
    if (values.system.dimension == 2) return action.template operator()<2, Real>();
    return action.template operator()<3, Real>();
  };
  switch (values.collision.precision) {
    case Precision::extended:
      return with(Extended());
    case Precision::quad:
      return with(Quad());
    case Precision::digits100:
      return with(Digits100());
    case Precision::double_precision:
      break;
  }
  return with(double());
}

}  // namespace zenosphere
