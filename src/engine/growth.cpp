#include "engine/growth.hpp"

#include <numeric>
#include <string>

#include "engine/growing_spheres.hpp"
#include "engine/rods.hpp"
#include "model/instantiate.hpp"
#include "model/power.hpp"
#include "model/shuffle.hpp"

namespace zenosphere {

Jammed::Jammed(double reached)
    : std::invalid_argument("the growing spheres jammed at a solids volume fraction of " +
                            std::to_string(reached)),
      reached_(reached) {}

namespace {

/// Clear of touch by more than the rounding of places in a box of a thousand diameters.
constexpr double full_size = 1 + 1e-10;

template <int Dim>
double filled_fraction(std::span<const double> diameters, const ShearBox<Dim, double>& box) {
  double sum = 0;
  for (const double diameter : diameters) sum += power<Dim>(diameter);
  return sum * unit_sphere_volume(Dim) / box.volume();
}

/// Rods in the order of a shuffle.
std::vector<Vec<1, double>> shuffled_rods(std::span<const double> lengths,
                                          const ShearBox<1, double>& box, Random& random) {
  std::vector<std::size_t> order(lengths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, random);
  std::vector<double> in_order;
  for (const std::size_t i : order) in_order.push_back(lengths[i]);
  const auto ordered = rod_places(in_order, box, random);
  std::vector<Vec<1, double>> places(lengths.size());
  for (std::size_t k = 0; k < order.size(); ++k) places[order[k]] = ordered[k];
  return places;
}

/// Lets points grow to spheres of full size. Throws Jammed.
template <int Dim>
void grow(GrowingSpheres<Dim>& spheres, double fraction) {
  // Thin, they need not find their order. Where it is dense, spheres that grow by a fiftieth of a
  // diameter in the time in which they fly one jam at 0.639 (N = 500), by a two-hundredth at 0.647,
  // by a twentieth at 0.633. Disks crystallise at a fiftieth (0.89 and above); at a twentieth they
  // jam at 0.855.
  constexpr double loose = Dim == 3 ? 0.4 : 0.55;
  constexpr double fast = 0.5;
  constexpr double slow = Dim == 3 ? 0.02 : 0.05;
  // Gaps are a hundred-thousandth of a diameter then.
  constexpr double jammed_rate = 1e5;
  double loose_size = full_size;
  while (fraction * power<Dim>(loose_size) > loose) loose_size -= 0x1p-6;
  while (spheres.size() < full_size) {
    const bool is_loose = spheres.size() < loose_size;
    const auto round = spheres.advance(is_loose ? fast : slow, is_loose ? loose_size : full_size);
    if (round.collisions_per_sphere > jammed_rate * round.time) {
      throw Jammed(fraction * power<Dim>(spheres.size()));
    }
  }
}

/// Lets spheres of full size forget how they grew.
template <int Dim>
void mix(GrowingSpheres<Dim>& spheres) {
  constexpr double collisions_per_sphere = 20;
  constexpr double longest = 30;  // a gas too thin to collide is mixed already
  double collisions = 0;
  for (double time = 0; time < longest && collisions < collisions_per_sphere;) {
    const auto round = spheres.advance(0, full_size);
    time += round.time;
    collisions += round.collisions_per_sphere;
  }
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim, double>> grown_places(std::span<const double> diameters,
                                           const ShearBox<Dim, double>& box, Random& random) {
  if constexpr (Dim == 1) {
    return shuffled_rods(diameters, box, random);
  } else {
    GrowingSpheres<Dim> spheres(diameters, box, random);
    grow(spheres, filled_fraction<Dim>(diameters, box));
    mix(spheres);
    return spheres.positions();
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                 \
  template std::vector<Vec<Dim, double>> grown_places<Dim>(std::span<const double>, \
                                                           const ShearBox<Dim, double>&, Random&);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
