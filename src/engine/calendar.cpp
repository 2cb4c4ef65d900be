#include "engine/calendar.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

template <class Real>
constexpr bool is_event(const Real& time) {
  return time < std::numeric_limits<Real>::infinity();
}

}  // namespace

template <class Real>
Calendar<Real>::Calendar(std::int32_t size)
    : events_(static_cast<std::size_t>(size),
              Event{std::numeric_limits<Real>::infinity(), kNone, kNowhere}),
      bins_(static_cast<std::int32_t>(std::bit_ceil(static_cast<std::uint32_t>(size)))),
      current_(bins_ - 1),
      soon_(size > most_spheres_in_cache ? 64 : bins_) {
  heads_.assign(static_cast<std::size_t>(bins_), kNone);
  end_cycle();
}

template <class Real>
void Calendar<Real>::schedule(std::int32_t id, const Real& time) {
  remove(id);
  event(id).time = time;
  if (is_event(time)) place(id);
}

template <class Real>
std::int32_t Calendar<Real>::earliest() {
  while (heap_.empty()) {
    if (current_ + soon_ >= least_bin_) end_waits();
    if (current_ + 1 < bins_) {
      open_bin(++current_);
    } else if (in_next_cycle_ > 0) {
      start_cycle();
    } else {
      return kNone;
    }
  }
  return heap_.front();
}

template <class Real>
void Calendar<Real>::set_back(const Real& span) {
  heap_.clear();
  std::fill(heads_.begin(), heads_.end(), kNone);
  in_next_cycle_ = 0;
  end_cycle();
  for (Event& event : events_) {
    if (event.place == kNowhere) continue;
    event.time -= span;
    event.place = kInNextCycle;
    ++in_next_cycle_;
  }
}

/// Lets every event wait for the next cycle.
template <class Real>
void Calendar<Real>::end_cycle() {
  first_wait_ = end_of_waits_;
  least_bin_ = kNoBin;
  current_ = bins_ - 1;
  origin_ = -std::numeric_limits<Real>::infinity();
  bins_per_time_ = 1;
}

/// Spreads the events that wait over the bins of a new cycle.
template <class Real>
void Calendar<Real>::start_cycle() {
  origin_ = std::numeric_limits<Real>::infinity();
  for (const Event& event : events_) {
    if (event.place == kInNextCycle) origin_ = std::min(origin_, event.time);
  }
  const Real width = fitted_bin_width(origin_);
  bins_per_time_ = width > 0 ? Real(1 / width) : Real(0);
  current_ = -1;
  in_next_cycle_ = 0;
  for (std::size_t id = 0; id < events_.size(); ++id) {
    if (events_[id].place == kInNextCycle) place(static_cast<std::int32_t>(id));
  }
}

/// About one event a bin: half of the events lie before their median.
template <class Real>
Real Calendar<Real>::fitted_bin_width(const Real& first) const {
  constexpr std::size_t kSample = 1024;  // enough for a width within some per cent
  const std::size_t stride = events_.size() / kSample + 1;
  std::vector<Real> sample;
  for (std::size_t id = 0; id < events_.size(); id += stride) {
    if (is_event(events_[id].time)) sample.push_back(events_[id].time - first);
  }
  if (sample.empty()) return 0;
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle * 2 / static_cast<Real>(events_.size());
}

template <class Real>
void Calendar<Real>::place(std::int32_t id) {
  Event& event = this->event(id);
  const double offset = bins_after_origin(event.time);
  if (offset < current_ + 1) {
    heap_push(id);
  } else if (offset < bins_) {
    const auto bin = static_cast<std::int32_t>(offset);
    if (bin <= current_ + soon_) {
      put(id, bin);
    } else {
      wait(id, bin);
    }
  } else {
    event.place = kInNextCycle;
    ++in_next_cycle_;
  }
}

/// Lets an event wait for its bin, whose head is fetched; of an earlier one, that is half way, the
/// sphere at the head.
template <class Real>
void Calendar<Real>::wait(std::int32_t id, std::int32_t bin) {
  constexpr std::uint32_t half = kMostWaiting / 2;
  if (end_of_waits_ - first_wait_ == kMostWaiting) end_wait();
  const std::uint32_t slot = end_of_waits_++ % kMostWaiting;
  waits_[slot] = {id, bin};
  event(id).place = waits_at(slot);
  least_bin_ = std::min(least_bin_, bin);
  fetch_at_once(&heads_[static_cast<std::size_t>(bin)]);
  const std::int32_t earlier = waits_[(slot + half) % kMostWaiting].bin;
  const std::int32_t head = heads_[static_cast<std::size_t>(earlier)];
  if (head != kNone) fetch_at_once(&event(head));
}

/// Puts the event that waits longest into its bin, if it is still there.
template <class Real>
void Calendar<Real>::end_wait() {
  const std::uint32_t slot = first_wait_++ % kMostWaiting;
  const auto [id, bin] = waits_[slot];
  if (event(id).place == waits_at(slot)) put(id, bin);
}

template <class Real>
void Calendar<Real>::end_waits() {
  while (first_wait_ != end_of_waits_) end_wait();
  least_bin_ = kNoBin;
}

template <class Real>
void Calendar<Real>::put(std::int32_t id, std::int32_t bin) {
  Event& event = this->event(id);
  std::int32_t& head = heads_[static_cast<std::size_t>(bin)];
  event.next = head;
  event.place = behind(kNone);
  if (head != kNone) this->event(head).place = behind(id);
  head = id;
}

template <class Real>
void Calendar<Real>::remove(std::int32_t id) {
  Event& event = this->event(id);
  const std::int32_t place = std::exchange(event.place, kNowhere);
  if (place >= 0) {
    heap_remove(place);
  } else if (is_in_bin(place)) {
    const std::int32_t previous = behind(place);
    (previous == kNone ? heads_[static_cast<std::size_t>(bins_after_origin(event.time))]
                       : this->event(previous).next) = event.next;
    if (event.next != kNone) this->event(event.next).place = place;
  } else if (place == kInNextCycle) {
    --in_next_cycle_;
  }
}

template <class Real>
void Calendar<Real>::open_bin(std::int32_t bin) {
  std::int32_t id = std::exchange(heads_[static_cast<std::size_t>(bin)], kNone);
  while (id != kNone) {
    const std::int32_t next = event(id).next;
    heap_push(id);
    id = next;
  }
}

template <class Real>
bool Calendar<Real>::before(std::int32_t a, std::int32_t b) const {
  const Real& time_a = event(a).time;
  const Real& time_b = event(b).time;
  return time_a < time_b || (time_a == time_b && a < b);
}

template <class Real>
void Calendar<Real>::heap_push(std::int32_t id) {
  heap_.push_back(id);
  heap_settle(static_cast<std::int32_t>(heap_.size()) - 1, id);
}

template <class Real>
void Calendar<Real>::heap_remove(std::int32_t position) {
  const std::int32_t last = heap_.back();
  heap_.pop_back();
  if (position < static_cast<std::int32_t>(heap_.size())) heap_settle(position, last);
}

/// Puts `id` where it belongs, starting from a free `position` in the heap.
template <class Real>
void Calendar<Real>::heap_settle(std::int32_t position, std::int32_t id) {
  const auto put = [this](std::int32_t at, std::int32_t sphere) {
    heap_[static_cast<std::size_t>(at)] = sphere;
    event(sphere).place = at;
  };
  const auto size = static_cast<std::int32_t>(heap_.size());
  while (position > 0) {
    const std::int32_t parent = heap_[static_cast<std::size_t>((position - 1) / 2)];
    if (!before(id, parent)) break;
    put(position, parent);
    position = (position - 1) / 2;
  }
  for (std::int32_t child = 2 * position + 1; child < size; child = 2 * position + 1) {
    if (child + 1 < size && before(heap_[static_cast<std::size_t>(child + 1)],
                                   heap_[static_cast<std::size_t>(child)])) {
      ++child;
    }
    if (!before(heap_[static_cast<std::size_t>(child)], id)) break;
    put(position, heap_[static_cast<std::size_t>(child)]);
    position = child;
  }
  put(position, id);
}

#define ZENOSPHERE_INSTANTIATE(Real) template class Calendar<Real>;
ZENOSPHERE_FOR_EACH_REAL(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
