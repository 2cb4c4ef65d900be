#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/huge_page_vector.hpp"
#include "engine/periodic_image.hpp"
#include "engine/prefetching.hpp"
#include "engine/reference_position.hpp"
#include "model/limits.hpp"

namespace zenosphere {

/// A sphere as a neighbour: which one, and in which periodic image.
class Neighbour {
 public:
  /// Numbers of spheres have so many bits; the image takes the other eight.
  static constexpr int sphere_bits = 24;
  static constexpr std::uint32_t sphere_mask = (std::uint32_t{1} << sphere_bits) - 1;
  static_assert(most_spheres <= sphere_mask);

  Neighbour() = default;
  constexpr Neighbour(std::int32_t sphere, PeriodicImage periodic_image)
      : packed_(static_cast<std::uint32_t>(periodic_image.code()) << sphere_bits |
                static_cast<std::uint32_t>(sphere)) {}
  static Neighbour from_packed(std::uint32_t packed) {
    Neighbour neighbour;
    neighbour.packed_ = packed;
    return neighbour;
  }

  constexpr std::uint32_t packed() const { return packed_; }
  std::int32_t sphere() const { return static_cast<std::int32_t>(packed_ & sphere_mask); }
  PeriodicImage periodic_image() const {
    return PeriodicImage::from_code(static_cast<std::int32_t>(packed_ >> sphere_bits));
  }

  /// How sphere i, whose neighbour this is, is seen from here.
  Neighbour reversed(std::int32_t i) const { return {i, periodic_image().reversed()}; }

  friend bool operator==(const Neighbour&, const Neighbour&) = default;

 private:
  std::uint32_t packed_ = 0;
};

/// Which spheres are near each other: those that a sphere can touch before the list of either one
/// is rebuilt.
///
/// If j is on the list of i, then i is on the list of j with the reversed image. The order on a
/// list means nothing. All lists have the same room; the few that are longer are kept elsewhere. In
/// front of each stands the reference position of its sphere, because the two are read and renewed
/// together.
class NeighbourLists {
 public:
  static constexpr std::size_t most = 65532;      ///< on one list
  static constexpr std::size_t most_places = 64;  ///< that a set of bits can tell apart

  /// \param mean  length that lists are expected to have
  NeighbourLists(std::int32_t spheres, double mean);

  std::int32_t spheres() const { return spheres_; }
  ReferencePosition& reference(std::int32_t i) { return head(i).reference; }
  const ReferencePosition& reference(std::int32_t i) const { return head(i).reference; }

  /// The neighbours of i. Up to three more may be read, some that there have been once.
  std::span<const Neighbour> of(std::int32_t i) const { return {entries(i), count(i)}; }

  /// Where j stands on the list of i, as a set of bits; among the first `most_places`.
  std::uint64_t places(std::int32_t i, std::int32_t j) const;

  /// What it takes to give a sphere other neighbours.
  struct Changes {
    std::size_t fresh;   ///< how many are new; of those behind the 64th it may be taken for granted
    std::uint64_t kept;  ///< which of those that it has stay
  };

  /// What changes where i gets the neighbours `now`.
  ///
  /// \param now  in any order; afterwards those that are new come first
  Changes changes(std::int32_t i, std::span<Neighbour> now) const;

  /// Prefetches what replace() will read: all at once, since it was not known before which come and
  /// go.
  void prefetch(std::int32_t i, std::span<const Neighbour> now, const Changes& changes) const;

  /// Gives i the neighbours `now`, and i to them; takes it from those that it had before.
  void replace(std::int32_t i, std::span<const Neighbour> now, const Changes& changes);

  /// Makes i and `neighbour` neighbours of each other, which they must not be yet.
  void add(std::int32_t i, Neighbour neighbour) {
    add_one_way(i, neighbour);
    add_one_way(neighbour.sphere(), neighbour.reversed(i));
  }

  /// Corrects all images for layers that have slid by a whole box.
  void turn();

  /// Prefetches the list of i, and its reference position.
  void prefetch(std::int32_t i) const { for_each_line(i, prefetch_line); }

 private:
  struct Head {
    ReferencePosition reference;
    std::uint32_t count = 0;
  };

  /// A head, and entries behind it.
  const std::byte* record(std::int32_t i) const {
    return records_.data() + static_cast<std::size_t>(i) * record_size_;
  }
  std::byte* record(std::int32_t i) {
    return const_cast<std::byte*>(std::as_const(*this).record(i));
  }
  /// The first and the last line of the cache in which a record lies: all, of 96 bytes.
  template <class Action>
  void for_each_line(std::int32_t i, Action action) const {
    action(record(i));
    action(record(i + 1) - 1);
  }
  const Head& head(std::int32_t i) const { return *reinterpret_cast<const Head*>(record(i)); }
  Head& head(std::int32_t i) { return *reinterpret_cast<Head*>(record(i)); }
  std::size_t count(std::int32_t i) const { return head(i).count; }
  bool is_long(std::int32_t i) const { return count(i) > room_; }

  /// Where its entries are, unless there are too many. In place of its first one, a list that is
  /// longer has its number here.
  Neighbour* usual(std::int32_t i) {
    return reinterpret_cast<Neighbour*>(record(i) + sizeof(Head));
  }
  const Neighbour* entries(std::int32_t i) const {
    const auto* const list = reinterpret_cast<const Neighbour*>(record(i) + sizeof(Head));
    return is_long(i) ? long_[list->packed()].data() : list;
  }
  Neighbour* entries(std::int32_t i) {
    return const_cast<Neighbour*>(std::as_const(*this).entries(i));
  }

  void add_one_way(std::int32_t i, Neighbour neighbour);
  void drop(std::int32_t i, Neighbour neighbour);
  Neighbour* resize(std::int32_t i, std::size_t count);
  Neighbour* resize_long(std::int32_t i, std::size_t count);
  std::uint32_t take_long_list();

  std::int32_t spheres_;
  std::size_t record_size_;  ///< bytes; a multiple of half a line of the cache
  std::size_t room_;         ///< a multiple of four
  HugePageVector<std::byte> records_;
  std::vector<std::vector<Neighbour>> long_;
  std::vector<std::uint32_t> unused_;  ///< of the long ones
};

}  // namespace zenosphere
