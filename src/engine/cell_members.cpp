#include "engine/cell_members.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace zenosphere {

CellMembers::CellMembers(std::int32_t cells) : chunks_(static_cast<std::size_t>(cells)) {}

void CellMembers::insert(std::int32_t sphere, std::int32_t cell) {
  Chunk* last = &chunks_[static_cast<std::size_t>(cell)];
  std::size_t chunks = 1;
  for (; last->next != none; ++chunks) last = &further(last->next);
  if (last->count == places) {
    last = &append_to(*last);
    longest_ = std::max(longest_, chunks + 1);
  }
  last->spheres[last->count++] = static_cast<std::uint32_t>(sphere);
}

/// The last sphere of the cell takes the free place.
void CellMembers::remove(std::int32_t sphere, std::int32_t cell) {
  std::uint32_t* place = nullptr;
  Chunk* before_last = nullptr;
  Chunk* last = &chunks_[static_cast<std::size_t>(cell)];
  for (;;) {
    const auto end = last->spheres.begin() + last->count;
    const auto found = std::find(last->spheres.begin(), end, static_cast<std::uint32_t>(sphere));
    if (found != end) place = &*found;
    if (last->next == none) break;
    before_last = last;
    last = &further(last->next);
  }
  assert(place);
  *place = last->spheres[--last->count];
  if (last->count == 0 && before_last) {
    unused_.push_back(std::exchange(before_last->next, none));
  }
}

Neighbour* CellMembers::find_further(const Chunk& first, std::uint32_t seen,
                                     Neighbour* found) const {
  for (std::int32_t next = first.next; next != none;) {
    const Chunk& chunk = further_[static_cast<std::size_t>(next)];
    found = copy(chunk, seen, found);
    next = chunk.next;
  }
  return found;
}

/// Gives a cell, whose last chunk this is, one more.
CellMembers::Chunk& CellMembers::append_to(Chunk& last) {
  if (unused_.empty()) {
    last.next = static_cast<std::int32_t>(further_.size());  // before further_ moves, and `last`
    return further_.emplace_back();
  }
  last.next = unused_.back();
  unused_.pop_back();
  return further(last.next);
}

}  // namespace zenosphere
