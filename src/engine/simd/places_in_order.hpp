#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace zenosphere {

/// Up to so many numbers are put in order at once.
inline constexpr std::size_t most_in_order = 16;

/// The places of numbers in increasing order.
struct PlacesInOrder {
  std::array<std::int64_t, most_in_order> places;  ///< of infinity: the one behind the last
  std::size_t compared;                            ///< so many have been given a place
  bool all_differ;                                 ///< if not, the places are wrong
};

/// Puts numbers in order by counting for each how many are less. Only where has_wide_lanes().
///
/// Which of two numbers is less, is as good as random: where a sort branches, a processor guesses
/// wrong at every other branch.
///
/// \param numbers  `count` finite ones, and infinity behind them
PlacesInOrder places_in_order_wide(const std::array<double, most_in_order>& numbers,
                                   std::size_t count);

}  // namespace zenosphere
