#pragma once

#include <cstring>

namespace zenosphere::support {

/// Same bits: -0 differs from 0.
inline bool are_same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace zenosphere::support
