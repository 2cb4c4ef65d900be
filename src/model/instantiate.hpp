#pragma once

#include "model/real.hpp"

/// Calls `instantiate(Dim, Real)` for each combination that the program is built with.
///
/// The engine is a template; its code is compiled here and nowhere else. With
/// ZENOSPHERE_DOUBLE_ALONE it is compiled in double only, for tests that compile it once more.
#ifdef ZENOSPHERE_DOUBLE_ALONE
#define ZENOSPHERE_FOR_EACH_ENGINE(instantiate) \
  instantiate(1, double) instantiate(2, double) instantiate(3, double)
#else
#define ZENOSPHERE_FOR_EACH_ENGINE(instantiate)                                                   \
  instantiate(1, double) instantiate(2, double) instantiate(3, double) instantiate(1, Extended)   \
      instantiate(2, Extended) instantiate(3, Extended) instantiate(1, Quad) instantiate(2, Quad) \
          instantiate(3, Quad) instantiate(1, Digits) instantiate(2, Digits)                      \
              instantiate(3, Digits)
#endif

/// Calls `instantiate(Dim)` for each dimension.
#define ZENOSPHERE_FOR_EACH_DIMENSION(instantiate) instantiate(1) instantiate(2) instantiate(3)

/// Calls `instantiate(Real)` for each number type.
#ifdef ZENOSPHERE_DOUBLE_ALONE
#define ZENOSPHERE_FOR_EACH_REAL(instantiate) instantiate(double)
#else
#define ZENOSPHERE_FOR_EACH_REAL(instantiate) \
  instantiate(double) instantiate(Extended) instantiate(Quad) instantiate(Digits)
#endif
