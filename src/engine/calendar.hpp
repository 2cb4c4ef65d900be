#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "engine/huge_page_vector.hpp"
#include "engine/prefetching.hpp"

namespace zenosphere {

/// The event calendar: one time per sphere, earliest first, O(1) per operation.
///
/// Linear bins in time hold the numbers of the spheres that were given an event in them. Nothing is
/// taken out of a bin: where a sphere has got another time since, its entry is void. When its turn
/// comes a bin is opened: its events are sorted and stand in line. An event that is given later and
/// comes before the end of the line, also one slightly in the past, goes to a small heap, and so
/// does one for which its bin has no room. When the bins are used up, or too many entries are void,
/// a new cycle begins with a bin width fitted to the events at hand. Equal times come in the order
/// of the spheres' numbers, so that the order of events depends on the times alone and not on the
/// history of the calendar.
///
/// Later bins are put together in groups, which are parted when their first bin is opened: so few
/// places are written to at a time that they stay in the cache.
///
/// Source: bins bounded in time, G. Paul, J. Comput. Phys. 221 (2007) 615; sorted, in two steps,
/// when their turn comes, Tang, Goh & Thng, ACM Trans. Model. Comput. Simul. 15 (2005) 175.
template <class Real>
class Calendar {
 public:
  static constexpr std::int32_t none = -1;

  struct Event {
    Real time;
    std::int32_t id;
  };

  /// \param size  number of spheres; each starts without an event
  explicit Calendar(std::int32_t size);

  /// Gives sphere `id` its event at `time`, in place of the one it had; infinity: no event.
  void schedule(std::int32_t id, const Real& time);

  /// The sphere with the earliest event, or `none` if there is no event at all.
  std::int32_t earliest() {
    for (;;) {
      if (!heap_.empty()) [[unlikely]]
        drop_void_heap();
      if (next_ < line_end_) {
        const Event& next = line_[next_];
        if (is_void(next)) {
          ++next_;
          continue;
        }
        return heap_.empty() || is_before(next, heap_.front()) ? next.id : heap_.front().id;
      }
      const bool is_next = !heap_.empty() && bins_after_origin(heap_.front().time) < opened_;
      if (is_next) return heap_.front().id;
      if (!go_on()) return none;
    }
  }

  /// Time of the event of sphere `id`; infinity if it has none.
  const Real& time(std::int32_t id) const { return times_[static_cast<std::size_t>(id)]; }

  /// Lets at least `count` events stand in line, as far as there are so many in this cycle.
  void line_up(std::size_t count) {
    while (line_end_ - next_ < count && opened_ < bin_count_) open_bin();
  }

  /// The events in line, earliest first. Some are void, and others may yet come between them.
  std::span<const Event> line() const { return std::span(line_).subspan(next_, line_end_ - next_); }

  /// How many have been in line, and are no more.
  std::int64_t passed() const { return lined_up_ - static_cast<std::int64_t>(line_end_ - next_); }

  /// Prefetches what will be read of the event of sphere `id`.
  void prefetch(std::int32_t id) const { prefetch_line(&time(id)); }

  /// Shifts all events by `span`, as when the clock is re-based.
  void shift_times(const Real& span);

 private:
  /// One line of the cache.
  struct alignas(64) Bin {
    static constexpr std::uint32_t room = 15;
    std::uint32_t size = 0;
    std::array<std::int32_t, room> ids;
  };
  /// Of the events of a bin, and one more.
  using Times = std::array<Real, Bin::room + 1>;
  using Ids = std::array<std::int32_t, Bin::room + 1>;
  using Group = std::deque<std::int32_t>;               ///< gives back its memory when cleared
  static constexpr std::uint32_t bins_in_group = 4096;  ///< which the cache can hold

  bool is_void(const Event& event) const { return time(event.id) != event.time; }
  static bool is_before(const Event& a, const Event& b) {
    return (a.time < b.time) | ((a.time == b.time) & (a.id < b.id));
  }
  static bool is_after(const Event& a, const Event& b) { return is_before(b, a); }

  double bins_after_origin(const Real& time) const {
    return static_cast<double>((time - origin_) * bins_per_time_);
  }
  Bin& bin(std::int32_t number) {
    return bins_[static_cast<std::size_t>(number) & (bins_.size() - 1)];
  }
  Group& group(std::int32_t number) {
    return groups_[static_cast<std::uint32_t>(number) / bins_in_group];
  }

  bool go_on();
  bool start_cycle();
  void end_cycle();
  void fit_bins(const Real& first);
  void place(std::int32_t id);
  void put_in_bin(std::int32_t id, std::int32_t number);
  void put_in_heap(std::int32_t id);
  void open_group();
  void open_bin();
  void stand_in_line(const Times& times, const Ids& ids, std::size_t count);
  void make_room_in_line();
  void drop_void_heap();
  void clear_heap_of_void();

  HugePageVector<Real> times_;
  std::int32_t bin_count_;     ///< in a cycle
  std::vector<Bin> bins_;      ///< of the group that is open, unsorted; a power of two
  std::vector<Group> groups_;  ///< of later bins
  std::int32_t opened_ = 0;    ///< bins of this cycle
  std::int32_t open_end_ = 0;  ///< the first bin that is in no group opened yet
  std::vector<Event> line_ = std::vector<Event>(4 * (Bin::room + 1));  ///< with room for more
  std::size_t next_ = 0;                                               ///< the first in line
  std::size_t line_end_ = 0;                                           ///< behind the last
  std::int64_t lined_up_ = 0;
  std::vector<Event> heap_;
  std::size_t heap_limit_ = 0;  ///< of entries, before it is cleared of those that are void
  std::size_t entries_ = 0;     ///< in bins, groups and the heap
  Real origin_ = 0;
  Real bins_per_time_ = 0;
  bool lanes_are_wide_;  ///< events are put in order all at once
};

}  // namespace zenosphere
