#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "storage/records.hpp"

namespace zenosphere {

/// A pair of spheres, or of a sphere and a wall, and how many collisions of a log are its own.
struct PairCount {
  std::int32_t i = 0, j = 0;
  std::int64_t collisions = 0;

  bool operator==(const PairCount&) const = default;
};

/// Finds the pairs that collide most often, in memory that does not grow with the log.
///
/// Exact for logs of at most `counters` different pairs. Of longer ones with K rows a count is too
/// small by at most K / counters, and so pairs may change places that are as near to each other.
/// Source: J. Misra, D. Gries, Sci. Comput. Program. 2 (1982) 143.
class FrequentPairs {
 public:
  /// \param counters  kept at once; those of the default take 2 MB
  explicit FrequentPairs(std::size_t counters = 65536);

  void observe(const CollisionRow& row);

  /// At most `most` pairs, the most frequent first, and of equal ones the one with smaller numbers.
  std::vector<PairCount> most_frequent(std::size_t most) const;

 private:
  /// A counter of a pair, i in the upper half of the key; no collisions: free.
  struct Counter {
    std::uint64_t key = 0;
    std::int64_t collisions = 0;
  };

  Counter& counter(std::uint64_t key);
  void lose_one_of_each();

  std::size_t counters_, kept_ = 0;
  std::vector<Counter> table_;  ///< at most half full, places by a hash of the key
};

/// Which of some pairs collide in each bin of a log, and in which bins they hit.
class PairRaster {
 public:
  static constexpr std::size_t most_pairs = 10;

  /// \param pairs  at most `most_pairs`
  /// \param width  rows of the log a bin
  PairRaster(std::vector<PairCount> pairs, std::int64_t width);

  void observe(const CollisionRow& row);

  /// The pairs with the number of collisions seen here.
  const std::vector<PairCount>& pairs() const { return pairs_; }

  /// For each bin a number: bit n says that pair n collides in it, bit `most_pairs` that another
  /// pair does, and the bits from `most_pairs` + 1 on say the same of hits.
  const std::vector<std::int32_t>& bins() const { return bins_; }

 private:
  std::vector<PairCount> pairs_;
  std::vector<std::int32_t> bins_;
  std::int64_t width_;
  std::int64_t in_bin_ = 0;
};

}  // namespace zenosphere
