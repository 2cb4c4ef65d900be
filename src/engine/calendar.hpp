#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/fetch_queue.hpp"
#include "engine/large_vector.hpp"

namespace zenosphere {

/// The event calendar: one time per sphere, earliest first, O(1) per operation.
///
/// A bounded increasing priority queue: linear bins in time, unsorted, and a small binary heap for
/// the bin that is current. An event earlier than the current bin, also one slightly in the
/// past, goes to the heap. When the bins are used up, a new cycle begins with a bin width fitted to
/// the events at hand. Equal times come in the order of the spheres' numbers, so that the order of
/// events depends on the times alone and not on the history of the calendar.
///
/// Source: G. Paul, J. Comput. Phys. 221 (2007) 615.
template <class Real>
class Calendar {
 public:
  static constexpr std::int32_t kNone = -1;

  /// \param size  number of spheres; each starts without an event
  explicit Calendar(std::int32_t size);

  /// Gives sphere `id` its event at `time`, in place of the one it had; infinity: no event.
  void schedule(std::int32_t id, const Real& time);

  /// The sphere with the earliest event, or kNone if there is no event at all.
  std::int32_t earliest();

  /// Time of the event of sphere `id`; infinity if it has none.
  const Real& time(std::int32_t id) const { return event(id).time; }

  /// The bin whose events come now.
  std::int32_t current_bin() const { return current_; }

  /// The first sphere in a later bin, as far as is known now, and the one behind a sphere in the
  /// same bin; or kNone.
  std::int32_t in_bin(std::int32_t bin) const {
    return bin < bins_ ? heads_[static_cast<std::size_t>(bin)] : kNone;
  }
  std::int32_t behind_in_bin(std::int32_t id) const {
    return is_in_bin(event(id).place) ? event(id).next : kNone;
  }

  /// What will be read of the event of sphere `id`.
  void add_to(FetchQueue& fetches, std::int32_t id) const { fetches.add(&event(id)); }

  /// Sets all events back by `span`, as when the clock is re-based.
  void set_back(const Real& span);

 private:
  struct Event {
    Real time;
    std::int32_t next;   ///< in the same bin
    std::int32_t place;  ///< in the heap or in a bin, or one of the following
  };
  static constexpr std::int32_t kNowhere = -1;
  static constexpr std::int32_t kInNextCycle = -2;
  static constexpr std::int32_t kMostWaiting = 8;
  static constexpr std::int32_t kNoBin = std::numeric_limits<std::int32_t>::max();

  struct Wait {
    std::int32_t id, bin;
  };

  /// The place of an event that waits for its bin.
  static constexpr std::int32_t waits_at(std::uint32_t slot) {
    return kInNextCycle - 1 - static_cast<std::int32_t>(slot);
  }

  /// The place in a bin behind the sphere `previous`, or at its head behind kNone; and back.
  static constexpr std::int32_t behind(std::int32_t previous) {
    return kInNextCycle - kMostWaiting - 2 - previous;
  }
  static constexpr bool is_in_bin(std::int32_t place) { return place <= behind(kNone); }

  void start_cycle();
  void end_cycle();
  Real fitted_bin_width(const Real& first) const;
  double bins_after_origin(const Real& time) const {
    return static_cast<double>((time - origin_) * bins_per_time_);
  }
  void place(std::int32_t id);
  void wait(std::int32_t id, std::int32_t bin);
  void end_wait();
  void end_waits();
  void put(std::int32_t id, std::int32_t bin);
  void remove(std::int32_t id);
  void open_bin(std::int32_t bin);

  bool before(std::int32_t a, std::int32_t b) const;
  void heap_push(std::int32_t id);
  void heap_remove(std::int32_t position);
  void heap_settle(std::int32_t position, std::int32_t id);

  Event& event(std::int32_t id) { return events_[static_cast<std::size_t>(id)]; }
  const Event& event(std::int32_t id) const { return events_[static_cast<std::size_t>(id)]; }

  LargeVector<Event> events_;
  LargeVector<std::int32_t> heads_;  ///< of the bins: a sphere in each
  std::vector<std::int32_t> heap_;
  std::int32_t bins_;
  std::int32_t current_;
  std::int32_t soon_;               ///< for bins not further off than this no event waits
  std::int32_t in_next_cycle_ = 0;  ///< how many events are
  std::array<Wait, kMostWaiting> waits_{};
  std::uint32_t first_wait_ = 0;  ///< counted on and on, as is the end
  std::uint32_t end_of_waits_ = 0;
  std::int32_t least_bin_ = kNoBin;  ///< of the bins waited for
  Real origin_ = 0;
  Real bins_per_time_ = 0;
};

}  // namespace zenosphere
