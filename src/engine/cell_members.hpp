#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "engine/huge_page_vector.hpp"
#include "engine/neighbour_lists.hpp"
#include "engine/periodic_image.hpp"
#include "engine/prefetching.hpp"

namespace zenosphere {

/// Which spheres are in which cell, side by side as a search for neighbours reads them.
class CellMembers {
 public:
  explicit CellMembers(std::int32_t cells);

  void insert(std::int32_t sphere, std::int32_t cell);
  void remove(std::int32_t sphere, std::int32_t cell);

  /// Writes the spheres of the cells `first` to `last`, in one periodic image, to `found`.
  ///
  /// \param found  with room for room() of each cell and `slack` more
  /// \return       the end of what has been written
  Neighbour* find(std::int32_t first, std::int32_t last, PeriodicImage periodic_image,
                  Neighbour* found) const {
    const std::uint32_t seen = Neighbour(0, periodic_image).packed();
    for (std::int32_t cell = first; cell <= last; ++cell) {
      const Chunk& chunk = chunks_[static_cast<std::size_t>(cell)];
      found = copy(chunk, seen, found);
      if (chunk.next != none) [[unlikely]]
        found = find_further(chunk, seen, found);
    }
    return found;
  }

  /// No cell has had more spheres, or few more.
  std::size_t room() const { return longest_ * places; }

  /// So many Neighbours behind those that are found may be overwritten.
  static constexpr std::size_t slack = 8;

  /// Prefetches the cells `first` to `last`.
  void prefetch(std::int32_t first, std::int32_t last) const {
    for (std::int32_t cell = first; cell <= last; ++cell) {
      prefetch_line(&chunks_[static_cast<std::size_t>(cell)]);
    }
  }

 private:
  static constexpr std::size_t places = 6;
  static constexpr std::int32_t none = -1;

  /// Places for six spheres, half a line of the cache; the first `count` are taken.
  struct alignas(32) Chunk {
    std::array<std::uint32_t, places> spheres{};
    std::uint32_t count = 0;
    std::int32_t next = none;  ///< further spheres of the cell
  };
  static_assert(sizeof(Chunk) == 32);

  /// Copies the whole chunk at once: behind the places that are taken goes what comes next.
  static Neighbour* copy(const Chunk& chunk, std::uint32_t seen, Neighbour* found) {
    std::array<std::uint32_t, slack> words;
    std::memcpy(words.data(), &chunk, sizeof words);
    for (std::uint32_t& word : words) word |= seen;
    std::memcpy(static_cast<void*>(found), words.data(), sizeof words);
    return found + chunk.count;
  }
  Neighbour* find_further(const Chunk& first, std::uint32_t seen, Neighbour* found) const;
  Chunk& further(std::int32_t number) { return further_[static_cast<std::size_t>(number)]; }
  Chunk& append_to(Chunk& last);

  HugePageVector<Chunk> chunks_;      ///< the first of each cell
  std::vector<Chunk> further_;        ///< of cells in which spheres crowd together
  std::vector<std::int32_t> unused_;  ///< of the further ones
  std::size_t longest_ = 1;
};

}  // namespace zenosphere
