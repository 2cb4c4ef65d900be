#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "model/random.hpp"

namespace zenosphere {

/// Puts the items of a list in random order.
/// Source: Durstenfeld, Commun. ACM 7 (1964) 420.
template <class Item>
void shuffle(std::vector<Item>& items, Random& random) {
  for (std::size_t left = items.size(); left > 1; --left) {
    const auto chosen = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(left)));
    std::swap(items[left - 1], items[chosen]);
  }
}

}  // namespace zenosphere
