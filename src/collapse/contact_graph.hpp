#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace zenosphere {

/// Which spheres touch: spheres are nodes, contacts are edges, and walls are left out.
class ContactGraph {
 public:
  void connect(std::int32_t i, std::int32_t j);
  void add(std::int32_t sphere) { neighbours_[sphere]; }

  /// The spheres that can be reached from one, itself among them, ascending.
  std::vector<std::int32_t> component(std::int32_t sphere) const;

  /// The backbone of a component: the longest of the shortest ways between two of its spheres.
  ///
  /// Of ways of one length the first that is found; a single sphere is a way by itself. A ring, as
  /// a row that closes through a periodic boundary, is opened at its first sphere and gone around.
  std::vector<std::int32_t> longest_way(std::int32_t sphere) const;

  const std::vector<std::int32_t>& neighbours(std::int32_t sphere) const {
    return neighbours_.at(sphere);
  }

  /// Every sphere that is reached from `root`, with the one from which it is reached in the fewest
  /// steps, nearest first; the root comes with itself.
  std::vector<std::pair<std::int32_t, std::int32_t>> breadth_first(std::int32_t root) const;

 private:
  bool is_ring(const std::vector<std::int32_t>& spheres) const;
  std::vector<std::int32_t> way_around(std::int32_t first) const;

  std::map<std::int32_t, std::vector<std::int32_t>> neighbours_;
};

}  // namespace zenosphere
