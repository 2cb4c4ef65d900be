#pragma once

#include <cstdint>
#include <vector>

namespace zenosphere {

/// Which spheres are in which cell: a list for each, the last one inserted first.
class CellLists {
 public:
  static constexpr std::int32_t none = -1;

  CellLists(std::int32_t cells, std::int32_t spheres)
      : first_(static_cast<std::size_t>(cells), none),
        next_(static_cast<std::size_t>(spheres), none),
        prev_(static_cast<std::size_t>(spheres), none) {}

  /// Spheres of a cell: for (id = first(cell); id != none; id = next(id)).
  std::int32_t first(std::int32_t cell) const { return first_[static_cast<std::size_t>(cell)]; }
  std::int32_t next(std::int32_t sphere) const { return next_[static_cast<std::size_t>(sphere)]; }

  void insert(std::int32_t sphere, std::int32_t cell) {
    std::int32_t& head = first_[static_cast<std::size_t>(cell)];
    next_[static_cast<std::size_t>(sphere)] = head;
    prev_[static_cast<std::size_t>(sphere)] = none;
    if (head != none) prev_[static_cast<std::size_t>(head)] = sphere;
    head = sphere;
  }

  void remove(std::int32_t sphere, std::int32_t cell) {
    const std::int32_t next = next_[static_cast<std::size_t>(sphere)];
    const std::int32_t prev = prev_[static_cast<std::size_t>(sphere)];
    (prev == none ? first_[static_cast<std::size_t>(cell)]
                  : next_[static_cast<std::size_t>(prev)]) = next;
    if (next != none) prev_[static_cast<std::size_t>(next)] = prev;
  }

 private:
  std::vector<std::int32_t> first_;
  std::vector<std::int32_t> next_;
  std::vector<std::int32_t> prev_;
};

}  // namespace zenosphere
