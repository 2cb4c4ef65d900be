#include "engine/growth.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <string>

#include "engine/growing_spheres.hpp"
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
  return sum * (std::numbers::pi / (Dim == 3 ? 6 : 4)) / box.volume();
}

/// Rods in the order of a shuffle, with gaps as between random points.
std::vector<Vec<1, double>> rods(std::span<const double> lengths, const ShearBox<1, double>& box,
                                 Random& random) {
  const double room = box.sides()[0] - std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (!(room > 0)) throw std::invalid_argument("the rods fill the box");
  std::vector<std::size_t> order(lengths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, random);
  std::vector<double> points(lengths.size());
  for (double& point : points) point = room * random.uniform();
  std::sort(points.begin(), points.end());
  std::vector<Vec<1, double>> places(lengths.size());
  double filled = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double length = lengths[order[k]];
    places[order[k]] = {points[k] + filled + length / 2};
    filled += length;
  }
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
    return rods(diameters, box, random);
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
