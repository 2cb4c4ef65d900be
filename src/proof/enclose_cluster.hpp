#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <span>

#include "proof/certificate.hpp"
#include "proof/exact_sphere.hpp"

namespace zenosphere {

/// How far a cluster is followed.
struct ClusterLimits {
  int decades = 100;  ///< of gap, at which it is enough
  std::int64_t collisions = 20000;
  long bits = 65536;  ///< of a number, at most; begins with 512 and doubles
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  const std::atomic<bool>* interrupt = nullptr;
};

/// Follows the spheres of a cluster, alone, from one moment on in ball arithmetic.
///
/// `enclosed`: the order of all collisions until a gap below 10^-decades is certain, and the last
/// of them is at a time between `lower` and `upper`, since that moment; `word` is the round with
/// which they end. `escapes`: they certainly collide no more. `none`: not even the largest number
/// of bits tells the order (two at one instant), or the gaps do not fall within the limits;
/// `decades` is how far they did. This says what the model does *from the numbers given*: how well
/// those are known is the caller's matter, and so is that no other sphere comes near. Collapse
/// itself it does not prove (docs/decisions/0019).
///
/// \param spheres       two or more, of any sizes and masses, all of one dimension, apart or just
/// in
///                      contact; two that overlap must recede (`none` otherwise)
/// \param restitutions  of each two of them
/// Source: docs/decisions/0019.
Certificate enclose_cluster(std::span<const ExactSphere> spheres,
                            const PairRestitutions& restitutions, const ClusterLimits& limits = {});

/// The same, with one restitution in [0, 1] for all.
Certificate enclose_cluster(std::span<const ExactSphere> spheres, const Rational& restitution,
                            const ClusterLimits& limits = {});

}  // namespace zenosphere
