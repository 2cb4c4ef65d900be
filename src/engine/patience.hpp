#pragma once

#include <cstdint>

namespace zenosphere {

/// Events without a collision after which a run without run.time is given up.
inline std::int64_t most_idle_events(std::int32_t spheres) {
  constexpr std::int64_t at_least = std::int64_t{1} << 28;  // a minute or two
  constexpr std::int64_t per_sphere = std::int64_t{1} << 20;
  return at_least + per_sphere * spheres;
}

}  // namespace zenosphere
