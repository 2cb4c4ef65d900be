#pragma once

#include <cstdint>
#include <vector>

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
  const Real& time(std::int32_t id) const { return times_[static_cast<std::size_t>(id)]; }

  /// Sets all events back by `span`, as when the clock is re-based.
  void set_back(const Real& span);

 private:
  struct Link {
    std::int32_t next;  ///< in the bin; unused in the heap
    std::int32_t prev;  ///< in the bin; position in the heap
    std::int32_t bin;
  };
  // Bins 0 .. bins_ - 1 hold the current cycle, bin `bins_` what comes after it.
  static constexpr std::int32_t kInHeap = -1;
  static constexpr std::int32_t kNowhere = -2;

  void start_cycle();
  void end_cycle();
  Real fitted_bin_width(const Real& first) const;
  void place(std::int32_t id);
  void remove(std::int32_t id);
  void open_bin(std::int32_t bin);

  bool before(std::int32_t a, std::int32_t b) const;
  void heap_push(std::int32_t id);
  void heap_remove(std::int32_t position);
  void heap_settle(std::int32_t position, std::int32_t id);

  std::vector<Real> times_;
  std::vector<Link> links_;
  std::vector<std::int32_t> heads_;
  std::vector<std::int32_t> heap_;
  std::int32_t bins_;
  std::int32_t current_;
  Real origin_ = 0;
  Real bins_per_time_ = 0;
};

}  // namespace zenosphere
