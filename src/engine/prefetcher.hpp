#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/predictor.hpp"
#include "engine/prefetching.hpp"
#include "engine/system.hpp"

namespace zenosphere {

/// Prefetches into the cache what the next events of a large system need. Only the speed depends on
/// it.
template <int Dim, class Real>
class Prefetcher {
 public:
  /// Has what an observer keeps of each sphere, in a row from `first` on, prefetched too: nothing
  /// there is read, and it may be gone.
  ///
  /// \param bytes  that it keeps of one sphere
  void include(const void* first, std::size_t bytes) {
    observed_ = static_cast<const std::byte*>(first);
    observed_bytes_ = bytes;
  }

  /// To be called at each event, of which the earliest stands first in the line of the calendar.
  void look_ahead(const System<Dim, Real>& system, Predictor<Dim, Real>& predictor) {
    if (system.count() > most_spheres_in_cache) prefetch(system, predictor);
  }

 private:
  struct Ahead;
  void prefetch(const System<Dim, Real>& system, Predictor<Dim, Real>& predictor);

  std::int64_t prefetched_ = 0;  ///< for so many of the calendar's line
  const std::byte* observed_ = nullptr;
  std::size_t observed_bytes_ = 0;
};

}  // namespace zenosphere
