#pragma once

#include <bit>
#include <cstdint>

namespace zenosphere {

/// Intervals from one regular moment to the next where no time ends the run: a clock that leaps
/// ahead of what cools would have no end of them. 1, but twice as many after each thousand.
///
/// \param multiple  intervals from the start to the moment
inline std::int64_t intervals_to_next(std::int64_t multiple) {
  constexpr std::int64_t alike = 1000;
  return static_cast<std::int64_t>(
      std::bit_floor(static_cast<std::uint64_t>(multiple / alike + 1)));
}

}  // namespace zenosphere
