// Prints a fingerprint of all bits of a run. Compiled several times with other flags: the outputs
// must be the same.

#include <array>
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>

#include "engine/list_range.hpp"
#include "engine/simulation.hpp"
#include "engine/start.hpp"
#include "flow/measurements.hpp"

namespace {

using namespace zenosphere;

/// FNV-1a over 64-bit words.
class Fingerprint {
 public:
  void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3; }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

template <int Dim>
std::uint64_t fingerprint_of(Arrangement arrangement, double restitution, double fraction = 0.3) {
  Vec<Dim, double> sides;
  std::array<double, Dim> filled;
  filled.fill(box_side<Dim>(500, fraction));
  for (int axis = 0; axis < Dim; ++axis) sides[axis] = filled[0];
  const double width = fitting_cell_width({filled, 500});
  const auto start = make_start<Dim>(
      {.arrangement = arrangement, .spheres = 500, .granular_temperature = 0.1, .seed = 3},
      ShearBox<Dim, double>(sides, 0, width));
  const double shear_rate = Dim > 1 ? 1 : 0;
  Simulation<Dim, double> simulation(ShearBox<Dim, double>(sides, shear_rate, width), start,
                                     {restitution});
  Measurements<Dim, double> measurements(simulation, 0);
  Fingerprint fingerprint;
  while (simulation.collisions() < 20000) {
    const auto collision = simulation.next_collision(1e9);
    if (!collision) continue;
    measurements.observe(*collision, simulation);
    fingerprint.add(collision->time.remainder);
    fingerprint.add(static_cast<std::uint64_t>(collision->i));
    fingerprint.add(static_cast<std::uint64_t>(collision->j));
    fingerprint.add(collision->gap_before);
    fingerprint.add(collision->impact.normal_speed);
  }
  fingerprint.add(measurements.averages(simulation)->pressure);
  return fingerprint.hash();
}

}  // namespace

int main() {
  for (const std::uint64_t fingerprint :
       {fingerprint_of<3>(Arrangement::random, 0.9), fingerprint_of<3>(Arrangement::fcc, 0.4),
        fingerprint_of<3>(Arrangement::random, 0.9, 0.1),  // by cells, without lists
        fingerprint_of<2>(Arrangement::random, 0.9), fingerprint_of<1>(Arrangement::random, 1)}) {
    std::printf("%016" PRIx64 "\n", fingerprint);
  }
  return 0;
}
