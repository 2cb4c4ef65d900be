// Collisions per second of the bare loop: one state, one line of JSON.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>

#include "gas.hpp"
#include "process_usage.hpp"

namespace zenosphere::bench {

namespace {

/// What the user typed.
struct Arguments {
  int dimension = 3;
  GasRequest gas{.start = {.granular_temperature = 1}};
  std::int64_t warm_up = 0;
  std::int64_t collisions = 0;
};

/// What the loop has done so far.
struct Counts {
  template <class Gas>
  explicit Counts(const Gas& gas)
      : collisions(gas.collisions()),
        rebuilds(gas.rebuilds()),
        stale(gas.stale_events()),
        time(gas.time()) {}

  std::int64_t collisions;
  std::int64_t rebuilds;
  std::int64_t stale;
  double time;
};

void add_options(CLI::App& program, Arguments& arguments) {
  GasRequest& gas = arguments.gas;
  const std::map<std::string, Arrangement> arrangements{{"fcc", Arrangement::fcc},
                                                        {"random", Arrangement::random}};
  program.add_option("--dimension", arguments.dimension, "3, or 2: disks, from a random start")
      ->check(CLI::Range(2, 3));
  program.add_option("--spheres", gas.start.spheres, "number of spheres; for fcc 4 n^3")
      ->required()
      ->check(CLI::PositiveNumber);
  program.add_option("--fraction", gas.solids_volume_fraction, "solids volume fraction")
      ->required()
      ->check(CLI::Range(0.0, 0.74));
  program.add_option("--large", gas.large.count, "so many of the spheres are larger");
  program.add_option("--large-diameter", gas.large.diameter)->capture_default_str();
  program.add_option("--restitution", gas.restitution)->capture_default_str();
  program.add_option("--shear-rate", gas.shear_rate, "1/time; 0: no shear")->capture_default_str();
  program.add_option("--temperature", gas.start.granular_temperature, "at the start")
      ->capture_default_str();
  program.add_option("--start", gas.start.arrangement, "fcc or random")
      ->transform(CLI::CheckedTransformer(arrangements));
  program.add_option("--seed", gas.start.seed)->capture_default_str();
  program.add_option("--warm-up", arguments.warm_up, "collisions before the measured ones");
  program.add_option("--collisions", arguments.collisions, "collisions that are measured")
      ->required()
      ->check(CLI::PositiveNumber);
}

void print(const Arguments& arguments, const Counts& before, const Counts& after,
           const ProcessUsage& start, const ProcessUsage& end, const ResidentMemory& baseline) {
  const auto collisions = static_cast<double>(after.collisions - before.collisions);
  const auto spheres = static_cast<double>(arguments.gas.start.spheres);
  const ResidentMemory memory = resident_memory();
  const double user = end.user_seconds - start.user_seconds;
  fmt::print(R"({{"dimension": {}, "spheres": {}, "fraction": {}, )"
             R"("restitution": {}, "shear_rate": {}, )"
             R"("collisions": {}, "user_seconds": {:.6f}, "system_seconds": {:.6f}, )"
             R"("wall_seconds": {:.6f}, "collisions_per_second": {:.1f}, )"
             R"("rebuilds_per_collision": {:.4f}, "stale_per_collision": {:.4f}, )"
             R"("start_time": {:.6g}, "end_time": {:.6g}, "setup_user_seconds": {:.3f}, )"
             R"("bytes_per_sphere": {:.1f}, "peak_bytes_per_sphere": {:.1f}, "compiler": "{}"}})"
             "\n",
             arguments.dimension, arguments.gas.start.spheres, arguments.gas.solids_volume_fraction,
             arguments.gas.restitution, arguments.gas.shear_rate,
             after.collisions - before.collisions, user, end.system_seconds - start.system_seconds,
             end.wall_seconds - start.wall_seconds, collisions / user,
             static_cast<double>(after.rebuilds - before.rebuilds) / collisions,
             static_cast<double>(after.stale - before.stale) / collisions, before.time, after.time,
             start.user_seconds, static_cast<double>(memory.now - baseline.now) / spheres,
             static_cast<double>(memory.peak - baseline.now) / spheres, BENCH_COMPILER);
}

template <int Dim>
void measure(const Arguments& arguments) {
  const ResidentMemory baseline = resident_memory();
  auto gas = bench::gas<Dim>(arguments.gas);
  collide(gas, arguments.warm_up);
  const Counts before(gas);
  const ProcessUsage start = process_usage();
  collide(gas, arguments.collisions);
  const ProcessUsage end = process_usage();
  print(arguments, before, Counts(gas), start, end, baseline);
}

}  // namespace

}  // namespace zenosphere::bench

int main(int argc, char** argv) {
  using namespace zenosphere::bench;
  CLI::App program("Measures collisions per second of the bare event loop");
  Arguments arguments;
  add_options(program, arguments);
  CLI11_PARSE(program, argc, argv);
  try {
    arguments.dimension == 2 ? measure<2>(arguments) : measure<3>(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_collisions: {}\n", error.what());
    return 1;
  }
  return 0;
}
