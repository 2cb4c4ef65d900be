#include "engine/neighbour_lists.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/simd/list_changes.hpp"

namespace zenosphere {

namespace {

/// Where `wanted` stands first, behind the entries that a set can tell apart; or the end.
Neighbour* behind_a_set(Neighbour* entries, std::size_t count, std::uint32_t wanted) {
  for (std::size_t first = most_in_a_set; first < count; first += most_in_a_set) {
    const std::uint64_t places =
        places_of(entries + first, count - first, wanted, ~std::uint32_t{0});
    if (places != 0) return entries + first + std::countr_zero(places);
  }
  return entries + count;
}

/// What may be read behind the end of a list, since entries are read four at a time.
constexpr std::size_t slack = 3;

/// Bytes for a head and nearly all lists, where their lengths scatter as in a fluid; as many as lie
/// within few lines of the cache.
std::size_t fitting_record(std::size_t head, double mean) {
  constexpr double spare = 5;
  constexpr double most = 4000;
  constexpr std::size_t half_a_line = 32;
  const auto fours = static_cast<std::size_t>(std::ceil(std::min(mean + spare, most) / 4));
  const std::size_t bytes = head + 4 * fours * sizeof(Neighbour);
  return (bytes + half_a_line - 1) / half_a_line * half_a_line;
}

/// Those of a list of which a set of bits does not say that they are kept.
template <class Action>
void for_each_gone(std::span<const Neighbour> list, std::uint64_t kept, Action action) {
  for (std::uint64_t gone = all_of(list.size()) & ~kept; gone != 0; gone &= gone - 1) {
    action(list[static_cast<std::size_t>(std::countr_zero(gone))]);
  }
  for (std::size_t k = most_in_a_set; k < list.size(); ++k) action(list[k]);
}

}  // namespace

NeighbourLists::NeighbourLists(std::int32_t spheres, double mean)
    : spheres_(spheres),
      record_size_(fitting_record(sizeof(Head), mean)),
      room_((record_size_ - sizeof(Head)) / sizeof(Neighbour)),
      records_(static_cast<std::size_t>(spheres) * record_size_) {}

std::uint64_t NeighbourLists::places(std::int32_t i, std::int32_t j) const {
  const auto list = of(i);
  return places_of(list.data(), list.size(), static_cast<std::uint32_t>(j), Neighbour::sphere_mask);
}

void NeighbourLists::add_one_way(std::int32_t i, Neighbour neighbour) {
  const std::size_t count = this->count(i);
  resize(i, count + 1)[count] = neighbour;
}

void NeighbourLists::drop(std::int32_t i, Neighbour neighbour) {
  Neighbour* const list = entries(i);
  const std::size_t count = this->count(i);
  const std::uint64_t places = places_of(list, count, neighbour.packed(), ~std::uint32_t{0});
  Neighbour* const place =
      places != 0 ? list + std::countr_zero(places) : behind_a_set(list, count, neighbour.packed());
  if (place == list + count) return;  // only in a state that has been made up
  *place = list[count - 1];
  resize(i, count - 1);
}

/// Lets the list of i have `count` entries, of which those that there are stay. Returns the list.
Neighbour* NeighbourLists::resize(std::int32_t i, std::size_t count) {
  if (count <= room_ && !is_long(i)) [[likely]] {
    head(i).count = static_cast<std::uint32_t>(count);
    return usual(i);
  }
  return resize_long(i, count);
}

/// The same, of a list that is long before or after.
Neighbour* NeighbourLists::resize_long(std::int32_t i, std::size_t count) {
  if (count > most) throw std::length_error("more neighbours than a sphere can have");
  Neighbour* const usual = this->usual(i);
  const std::size_t before = this->count(i);
  const bool was_long = is_long(i);
  head(i).count = static_cast<std::uint32_t>(count);
  const std::uint32_t number = was_long ? usual->packed() : take_long_list();
  std::vector<Neighbour>& list = long_[number];
  if (list.size() < count + slack) list.resize(count + count / 2 + slack);
  if (!was_long) {
    std::copy_n(usual, before, list.begin());
    *usual = Neighbour::from_packed(number);
  }
  if (is_long(i)) return list.data();
  std::copy_n(list.begin(), count, usual);
  unused_.push_back(number);
  return usual;
}

std::uint32_t NeighbourLists::take_long_list() {
  if (unused_.empty()) {
    long_.emplace_back();
    return static_cast<std::uint32_t>(long_.size() - 1);
  }
  const std::uint32_t number = unused_.back();
  unused_.pop_back();
  return number;
}

NeighbourLists::Changes NeighbourLists::changes(std::int32_t i, std::span<Neighbour> now) const {
  return list_changes(of(i), now);
}

void NeighbourLists::prefetch(std::int32_t i, std::span<const Neighbour> now,
                              const Changes& changes) const {
  const auto prefetch_list = [this](Neighbour neighbour) { prefetch(neighbour.sphere()); };
  std::for_each_n(now.begin(), changes.fresh, prefetch_list);
  for_each_gone(of(i), changes.kept, prefetch_list);
}

void NeighbourLists::replace(std::int32_t i, std::span<const Neighbour> now,
                             const Changes& changes) {
  for_each_gone(of(i), changes.kept,
                [&](Neighbour neighbour) { drop(neighbour.sphere(), neighbour.reversed(i)); });
  std::copy(now.begin(), now.end(), resize(i, now.size()));
  for (const Neighbour neighbour : now.first(changes.fresh)) {
    add_one_way(neighbour.sphere(), neighbour.reversed(i));
  }
}

void NeighbourLists::turn() {
  for (std::int32_t i = 0; i < spheres_; ++i) {
    Neighbour* const list = entries(i);
    for (std::size_t k = 0; k < count(i); ++k) {
      list[k] = {list[k].sphere(), list[k].periodic_image().after_whole_turn()};
    }
  }
}

}  // namespace zenosphere
