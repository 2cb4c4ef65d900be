#include "engine/reference_cells.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <utility>

#include "engine/simd/equal_in_four.hpp"
#include "engine/simd/wide_lanes.hpp"

namespace zenosphere {

namespace {

using Chunk = ReferenceCells::Chunk;

constexpr std::int32_t free_place = -1;
constexpr std::int16_t far_away = std::numeric_limits<std::int16_t>::max();
// A search looks from at most four cells away, and up to one cell and a quarter beside the place.
static_assert(far_away - 4 * ReferenceCells::grains_a_cell > 5 * ReferenceCells::grains_a_cell / 4);

constexpr Chunk empty_chunk() {
  Chunk chunk{};
  for (std::size_t k = 0; k < Chunk::places; ++k) {
    chunk.label[k] = free_place;
    chunk.xy[k][0] = far_away;
  }
  return chunk;
}

/// The first place at which `label` stands, or `places`.
std::size_t place_of(const Chunk& chunk, std::int32_t label) {
  static_assert(Chunk::places == 6);
  const auto wanted = static_cast<std::uint32_t>(label);
  const auto four_from = [&](unsigned first) {
    return equal_in_four(chunk.label + first, wanted, ~std::uint32_t{0}) << first;
  };
  return static_cast<std::size_t>(
      std::countr_zero(four_from(0) | four_from(2) | 1u << Chunk::places));
}

/// Places that are taken: the first so many.
std::size_t taken(const Chunk& chunk) { return place_of(chunk, free_place); }

/// The next chunk of the same cell, or null.
const Chunk* next_of(const Chunk& chunk, const Chunk* further) {
  return chunk.next >= 0 ? further + chunk.next : nullptr;
}

std::span<const Chunk> cells_of(const ReferenceCells::Row& row, const Chunk* chunks) {
  return {chunks + row.first, chunks + row.last + 1};
}

/// Up to which distance a sphere counts, squared: grains^2.
int square_of_reach(const ReferenceCells::Range& range, std::int32_t) { return range.square; }
int square_of_reach(const ReferenceCells::SizedRange& range, std::int32_t label) {
  const int reach = range.reach + ((label >> Neighbour::sphere_bits) << range.shift);
  return reach * reach;
}

/// Writes those in a row of cells that are within range. Chunks that a cell has beside its own are
/// among the `further` ones.
template <class Range>
Neighbour* find_in(const ReferenceCells::Row& row, const Range& range, const Chunk* chunks,
                   const Chunk* further, Neighbour* found) {
  int x = row.place[0];
  for (const Chunk& first : cells_of(row, chunks)) {
    for (const Chunk* chunk = &first; chunk; chunk = next_of(*chunk, further)) {
      for (std::size_t k = 0; k < Chunk::places; ++k) {
        const int dx = std::max(0, std::abs(chunk->xy[k][0] - x) - row.slide);
        const int dy = chunk->xy[k][1] - row.place[1];
        const int dz = chunk->z[k] - row.place[2];
        const std::int32_t label = chunk->label[k];
        if (label == free_place) break;
        if (dx * dx + dy * dy + dz * dz < square_of_reach(range, label)) {
          *found++ = Neighbour(label & Neighbour::sphere_mask, row.periodic_image);
        }
      }
    }
    x -= range.cell_width;
  }
  return found;
}

#ifdef ZENOSPHERE_HAS_WIDE_LANES

/// For each set of lanes the numbers of those in it, first to last.
struct Compressions {
  alignas(32) std::int32_t lanes[256][8];
  constexpr Compressions() : lanes() {
    for (int set = 0; set < 256; ++set) {
      int kept = 0;
      for (int lane = 0; lane < 8; ++lane) {
        if (set >> lane & 1) lanes[set][kept++] = lane;
      }
    }
  }
};
constexpr Compressions compressions;

/// What find_in() compares with, for eight spheres at once.
template <class Range>
class WideLimit;

template <>
class WideLimit<ReferenceCells::Range> {
 public:
  ZENOSPHERE_WIDE explicit WideLimit(const ReferenceCells::Range& range)
      : square_(_mm256_set1_epi32(range.square)) {}
  /// The sign bit of those that are within range.
  ZENOSPHERE_WIDE __m256i exceeds(__m256i square, __m256i) const {
    return _mm256_cmpgt_epi32(square_, square);
  }
  ZENOSPHERE_WIDE __m256i spheres(__m256i labels) const { return labels; }

 private:
  __m256i square_;
};

/// The labels of free places are negative: their codes are none.
template <>
class WideLimit<ReferenceCells::SizedRange> {
 public:
  ZENOSPHERE_WIDE explicit WideLimit(const ReferenceCells::SizedRange& range)
      : reach_(_mm256_set1_epi32(range.reach)), shift_(_mm_cvtsi32_si128(range.shift)) {}
  ZENOSPHERE_WIDE __m256i exceeds(__m256i square, __m256i labels) const {
    const __m256i codes = _mm256_srli_epi32(labels, Neighbour::sphere_bits);
    const __m256i reach = _mm256_add_epi32(reach_, _mm256_sll_epi32(codes, shift_));
    return _mm256_andnot_si256(labels,
                               _mm256_cmpgt_epi32(_mm256_mullo_epi32(reach, reach), square));
  }
  ZENOSPHERE_WIDE __m256i spheres(__m256i labels) const {
    return _mm256_and_si256(labels, _mm256_set1_epi32(Neighbour::sphere_mask));
  }

 private:
  __m256i reach_;
  __m128i shift_;
};

/// The same in several rows, a chunk at a time. It is read as if it had eight places; what is read
/// at the last two belongs to its other members and counts for nothing.
template <class Range>
ZENOSPHERE_WIDE Neighbour* find_wide(std::span<const ReferenceCells::Row> rows, const Range& range,
                                     const Chunk* chunks, const Chunk* further, Neighbour* found) {
  const auto pair = [](std::int16_t x, std::int16_t y) {
    return static_cast<int>(static_cast<std::uint16_t>(x) |
                            static_cast<std::uint32_t>(static_cast<std::uint16_t>(y)) << 16);
  };
  const __m256i next_cell = _mm256_set1_epi32(pair(range.cell_width, 0));
  const WideLimit<Range> limit(range);
  constexpr unsigned all_places = (1u << Chunk::places) - 1;
  for (const ReferenceCells::Row& row : rows) {
    __m256i here = _mm256_set1_epi32(pair(row.place[0], row.place[1]));
    const __m128i here_z = _mm_set1_epi16(row.place[2]);
    const __m256i slide = _mm256_set1_epi32(pair(row.slide, 0));
    const __m256i periodic_image =
        _mm256_set1_epi32(static_cast<int>(Neighbour(0, row.periodic_image).packed()));
    for (const Chunk& first : cells_of(row, chunks)) {
      for (const Chunk* chunk = &first; chunk; chunk = next_of(*chunk, further)) {
        const auto at = [](const auto& member) { return reinterpret_cast<const __m256i*>(member); };
        // Saturated, so that free places remain far away.
        const __m256i xy = _mm256_subs_epu16(
            _mm256_abs_epi16(_mm256_subs_epi16(_mm256_load_si256(at(chunk->xy)), here)), slide);
        const __m256i z = _mm256_cvtepi16_epi32(
            _mm_sub_epi16(_mm_load_si128(reinterpret_cast<const __m128i*>(chunk->z)), here_z));
        const __m256i square =
            _mm256_add_epi32(_mm256_madd_epi16(xy, xy), _mm256_mullo_epi32(z, z));
        const __m256i labels = _mm256_loadu_si256(at(chunk->label));
        const auto set = static_cast<unsigned>(_mm256_movemask_ps(
                             _mm256_castsi256_ps(limit.exceeds(square, labels)))) &
                         all_places;
        const __m256i spheres = _mm256_or_si256(limit.spheres(labels), periodic_image);
        const __m256i order =
            _mm256_load_si256(reinterpret_cast<const __m256i*>(compressions.lanes[set]));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(found),
                            _mm256_permutevar8x32_epi32(spheres, order));
        found += __builtin_popcount(set);
      }
      here = _mm256_sub_epi16(here, next_cell);
    }
  }
  return found;
}

#endif

template <class Range>
Neighbour* find_rows(std::span<const ReferenceCells::Row> rows, const Range& range,
                     const Chunk* chunks, const Chunk* further, Neighbour* found) {
#ifdef ZENOSPHERE_HAS_WIDE_LANES
  if (has_wide_lanes()) return find_wide(rows, range, chunks, further, found);
#endif
  for (const ReferenceCells::Row& row : rows) found = find_in(row, range, chunks, further, found);
  return found;
}

}  // namespace

ReferenceCells::ReferenceCells(std::int32_t cells)
    : chunks_(static_cast<std::size_t>(cells), empty_chunk()) {}

Neighbour* ReferenceCells::find(std::span<const Row> rows, const Range& range,
                                Neighbour* found) const {
  return find_rows(rows, range, chunks_.data(), further_.data(), found);
}

Neighbour* ReferenceCells::find(std::span<const Row> rows, const SizedRange& range,
                                Neighbour* found) const {
  return find_rows(rows, range, chunks_.data(), further_.data(), found);
}

void ReferenceCells::insert(std::int32_t label, std::int32_t cell,
                            const ReferencePosition& reference) {
  Chunk* last = &chunk(cell);
  std::size_t chunks = 1;
  for (; last->next >= 0; ++chunks) last = &further_[static_cast<std::size_t>(last->next)];
  std::size_t k = taken(*last);
  if (k == Chunk::places) {
    last = &append_to(*last);
    k = 0;
    longest_ = std::max(longest_, chunks + 1);
  }
  last->label[k] = label;
  last->xy[k][0] = reference.place[0];
  last->xy[k][1] = reference.place[1];
  last->z[k] = reference.place[2];
}

/// The last sphere of the cell takes the free place.
void ReferenceCells::remove(std::int32_t label, std::int32_t cell) {
  Chunk* holder = nullptr;
  std::size_t place = 0;
  Chunk* before_last = nullptr;
  Chunk* last = &chunk(cell);
  for (;;) {
    if (const std::size_t k = place_of(*last, label); k < Chunk::places) {
      holder = last;
      place = k;
    }
    if (last->next < 0) break;
    before_last = last;
    last = &further_[static_cast<std::size_t>(last->next)];
  }
  assert(holder);
  const std::size_t k = taken(*last) - 1;
  holder->label[place] = last->label[k];
  std::copy_n(last->xy[k], 2, holder->xy[place]);
  holder->z[place] = last->z[k];
  last->label[k] = free_place;
  last->xy[k][0] = far_away;
  last->xy[k][1] = last->z[k] = 0;
  if (k == 0 && before_last) {
    unused_.push_back(std::exchange(before_last->next, Chunk::none));
  }
}

/// Gives a cell, whose last chunk this is, one more.
ReferenceCells::Chunk& ReferenceCells::append_to(Chunk& last) {
  std::int32_t number = 0;
  if (unused_.empty()) {
    number = static_cast<std::int32_t>(further_.size());
    last.next = number;  // before further_ moves, and `last` with it
    further_.push_back(empty_chunk());
  } else {
    number = unused_.back();
    last.next = number;
    unused_.pop_back();
  }
  return further_[static_cast<std::size_t>(number)];
}

}  // namespace zenosphere
