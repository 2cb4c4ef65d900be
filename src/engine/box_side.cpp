#include "engine/box_side.hpp"

#include <cmath>

#include "model/instantiate.hpp"
#include "model/power.hpp"

namespace zenosphere {

namespace {

/// Cube root by Newton's method: the C library's may differ between machines in the last bit.
double cube_root(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  double root = std::ldexp(1.0, exponent / 3 + 1);  // above the root, below four times it
  for (;;) {
    const double next = root - (root * root * root - value) / (3 * root * root);
    if (!(next < root)) return root;  // falls monotonically from above until rounding
    root = next;
  }
}

}  // namespace

template <int Dim>
double box_side(std::int64_t spheres, double solids_volume_fraction) {
  const double volume =
      static_cast<double>(spheres) * unit_sphere_volume(Dim) / solids_volume_fraction;
  return Dim == 1 ? volume : Dim == 2 ? std::sqrt(volume) : cube_root(volume);
}

#define ZENOSPHERE_INSTANTIATE(Dim) template double box_side<Dim>(std::int64_t, double);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
