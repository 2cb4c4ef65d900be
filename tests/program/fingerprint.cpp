// Prints a fingerprint of all bits of a run. Compiled several times with other flags: the outputs
// must be the same.

#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>

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

std::uint64_t fingerprint_of(Arrangement arrangement, double restitution) {
  const double side = box_side<3>(500, 0.3);
  const auto start = make_start<3>(
      {.arrangement = arrangement, .spheres = 500, .granular_temperature = 0.1, .seed = 3},
      ShearBox<3, double>({side, side, side}, 0));
  Simulation<3, double> simulation(ShearBox<3, double>({side, side, side}, 1), start,
                                   {restitution});
  Measurements<3, double> measurements(simulation, 0);
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
  std::printf("%016" PRIx64 " %016" PRIx64 "\n", fingerprint_of(Arrangement::random, 0.9),
              fingerprint_of(Arrangement::fcc, 0.4));
  return 0;
}
