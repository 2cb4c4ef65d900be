#include "report/frequent_pairs.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

namespace zenosphere {
namespace {

/// A pair as one number: i above, j below.
std::uint64_t key(std::int32_t i, std::int32_t j) {
  return std::uint64_t{static_cast<std::uint32_t>(i)} << 32 | static_cast<std::uint32_t>(j);
}

PairCount pair_of(std::uint64_t key, std::int64_t collisions) {
  return {static_cast<std::int32_t>(static_cast<std::uint32_t>(key >> 32)),
          static_cast<std::int32_t>(static_cast<std::uint32_t>(key)), collisions};
}

}  // namespace

FrequentPairs::FrequentPairs(std::size_t counters)
    : counters_(counters), table_(std::bit_ceil(2 * counters)) {}

/// That of a pair, or the free one that it would take.
FrequentPairs::Counter& FrequentPairs::counter(std::uint64_t key) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio (Knuth, TAOCP 3, 6.4)
  const std::size_t last = table_.size() - 1;
  std::size_t place = static_cast<std::size_t>((key * golden) >> 32) & last;
  while (table_[place].collisions != 0 && table_[place].key != key) place = (place + 1) & last;
  return table_[place];
}

void FrequentPairs::observe(const CollisionRow& row) {
  const std::uint64_t pair = key(row.i, row.j);
  Counter& found = counter(pair);
  if (found.collisions != 0) {
    ++found.collisions;
  } else if (kept_ < counters_) {
    found = {pair, 1};
    ++kept_;
  } else {
    lose_one_of_each();
  }
}

void FrequentPairs::lose_one_of_each() {
  const std::vector<Counter> before = std::exchange(table_, std::vector<Counter>(table_.size()));
  kept_ = 0;
  for (const auto& [pair, collisions] : before) {
    if (collisions < 2) continue;
    counter(pair) = {pair, collisions - 1};
    ++kept_;
  }
}

std::vector<PairCount> FrequentPairs::most_frequent(std::size_t most) const {
  std::vector<PairCount> pairs;
  pairs.reserve(kept_);
  for (const auto& [pair, collisions] : table_) {
    if (collisions != 0) pairs.push_back(pair_of(pair, collisions));
  }
  const auto middle = pairs.begin() + static_cast<std::ptrdiff_t>(std::min(most, pairs.size()));
  std::partial_sort(pairs.begin(), middle, pairs.end(), [](const auto& a, const auto& b) {
    return std::tuple(-a.collisions, a.i, a.j) < std::tuple(-b.collisions, b.i, b.j);
  });
  pairs.erase(middle, pairs.end());
  return pairs;
}

PairRaster::PairRaster(std::vector<PairCount> pairs, std::int64_t width)
    : pairs_(std::move(pairs)), width_(width) {
  for (PairCount& pair : pairs_) pair.collisions = 0;
}

void PairRaster::observe(const CollisionRow& row) {
  if (in_bin_ == 0) bins_.push_back(0);
  in_bin_ = (in_bin_ + 1) % width_;
  const auto found = std::ranges::find_if(
      pairs_, [&](const PairCount& pair) { return pair.i == row.i && pair.j == row.j; });
  std::size_t bit = most_pairs;
  if (found != pairs_.end()) {
    bit = static_cast<std::size_t>(found - pairs_.begin());
    ++found->collisions;
  }
  bins_.back() |= 1 << bit;
  if ((row.flags & collision_flag::hit) != 0) bins_.back() |= 1 << (bit + most_pairs + 1);
}

}  // namespace zenosphere
