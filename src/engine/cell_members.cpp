#include "engine/cell_members.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace zenosphere {

namespace {

bool is_taken(std::uint32_t place) { return (place & CellPlace::taken) != 0; }

std::int32_t sphere_at(std::uint32_t place) {
  return static_cast<std::int32_t>(place & Neighbour::sphere_mask);
}

constexpr std::uint32_t one_period_along_x =
    Neighbour(0, PeriodicImage(std::array{1}, 0)).packed() - Neighbour(0, {}).packed();

/// What stands at the place of a sphere that none follows.
std::uint32_t alone(std::int32_t sphere) {
  return CellPlace::taken | static_cast<std::uint32_t>(sphere);
}

}  // namespace

CellMembers::CellMembers(std::int32_t cells, std::int32_t spheres)
    : places_(2 * static_cast<std::size_t>(cells) + slack),
      next_(static_cast<std::size_t>(spheres), none) {}

/// What stands at the place of a sphere.
std::uint32_t CellMembers::place_for(std::int32_t sphere) const {
  const auto number = static_cast<std::uint32_t>(sphere);
  return CellPlace::taken | number | (next_[number] == none ? 0 : CellPlace::more);
}

// Which of two places it is, is as good as random: an index is worked out faster than guessed.

void CellMembers::insert(std::int32_t sphere, std::int32_t cell) {
  std::uint32_t* const places = this->places(cell);
  if (!is_taken(places[0] & places[1])) [[likely]] {
    places[static_cast<std::size_t>(is_taken(places[0]))] = alone(sphere);
    return;
  }
  const std::int32_t second = sphere_at(places[1]);
  next(sphere) = (places[1] & CellPlace::more) == 0 ? none : next(second);
  next(second) = sphere;
  places[1] = place_for(second);
  std::size_t members = 2;
  for (std::int32_t other = sphere; other != none; other = next(other)) ++members;
  most_ = std::max(most_, members);
}

void CellMembers::remove(std::int32_t sphere, std::int32_t cell) {
  std::uint32_t* const places = this->places(cell);
  if ((places[1] & CellPlace::more) == 0) [[likely]] {
    const auto place = static_cast<std::size_t>(places[1] == alone(sphere));
    assert(places[place] == alone(sphere));
    places[place] = 0;
    return;
  }
  const std::int32_t second = sphere_at(places[1]);
  if (second == sphere) {
    places[1] = place_for(next(second));
    return;
  }
  const bool is_first = places[0] == alone(sphere);
  // One that has no place leaves those that follow the second, or takes the place of the first.
  std::int32_t before = second;
  while (!is_first && next(before) != sphere) before = next(before);
  const std::int32_t leaves = next(before);
  assert(leaves != none);
  next(before) = next(leaves);
  places[1] = place_for(second);
  if (is_first) places[0] = alone(leaves);
}

void CellMembers::repeat(std::int32_t cell, std::int32_t behind) {
  const std::uint32_t one_period = behind != 0 ? one_period_along_x : 0;
  for (const int k : {0, 1}) {
    const std::uint32_t place = places(cell)[k];
    places(cell + behind)[k] = is_taken(place) ? place + one_period : place;
  }
}

}  // namespace zenosphere
