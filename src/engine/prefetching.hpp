#pragma once

#include <cstdint>

namespace zenosphere {

/// Of more spheres than this, what the next events need is prefetched.
constexpr std::int32_t most_spheres_in_cache = 20000;

/// Prefetches a line of memory that is wanted soon.
inline void prefetch_line(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");  // GCC leaves out calls of a function that only prefetches: it has no effect
}

}  // namespace zenosphere
