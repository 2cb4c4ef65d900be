#pragma once

#include <cstdint>

namespace zenosphere {

/// `start.seed` of one run of a sweep: output number `run` (from 0) of the generator SplitMix64
/// begun at `master_seed`, without its last 11 bits.
///
/// The result is below 2^53, so that TOML, JSON, SQLite and a double hold it exactly. Runs far from
/// each other and near ones are equally unlike.
///
/// Source: Steele, Lea & Flood, OOPSLA 2014, Figure 17; constants of variant 13 of Stafford's
/// mixer.
constexpr std::uint64_t run_seed(std::uint64_t master_seed, std::uint64_t run) {
  std::uint64_t z = master_seed + (run + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  return (z ^ (z >> 31)) >> 11;
}

}  // namespace zenosphere
