#pragma once

#include <cstdint>

namespace zenosphere {

/// Of one system. Lists of neighbours hold the number of a sphere in 24 bits.
inline constexpr std::int64_t most_spheres = (1 << 24) - 1;

}  // namespace zenosphere
