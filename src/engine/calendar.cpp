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
    : times_(static_cast<std::size_t>(size), std::numeric_limits<Real>::infinity()),
      links_(static_cast<std::size_t>(size), Link{kNone, kNone, kNowhere}),
      bins_(static_cast<std::int32_t>(std::bit_ceil(static_cast<std::uint32_t>(size)))),
      current_(bins_ - 1) {
  heads_.assign(static_cast<std::size_t>(bins_) + 1, kNone);
  end_cycle();
}

template <class Real>
void Calendar<Real>::schedule(std::int32_t id, const Real& time) {
  remove(id);
  times_[static_cast<std::size_t>(id)] = time;
  if (is_event(time)) place(id);
}

template <class Real>
std::int32_t Calendar<Real>::earliest() {
  while (heap_.empty()) {
    if (current_ + 1 < bins_) {
      open_bin(++current_);
    } else if (heads_[static_cast<std::size_t>(bins_)] != kNone) {
      start_cycle();
    } else {
      return kNone;
    }
  }
  return heap_.front();
}

template <class Real>
void Calendar<Real>::set_back(const Real& span) {
  const auto size = static_cast<std::int32_t>(times_.size());
  for (std::int32_t id = 0; id < size; ++id) remove(id);
  end_cycle();
  for (std::int32_t id = 0; id < size; ++id) {
    auto& time = times_[static_cast<std::size_t>(id)];
    if (!is_event(time)) continue;
    time -= span;
    place(id);
  }
}

/// Lets every event wait in the last bin until the next cycle starts.
template <class Real>
void Calendar<Real>::end_cycle() {
  current_ = bins_ - 1;
  origin_ = -std::numeric_limits<Real>::infinity();
  bins_per_time_ = 1;
}

/// Spreads the events that wait in the last bin over the bins of a new cycle.
template <class Real>
void Calendar<Real>::start_cycle() {
  std::int32_t waiting = std::exchange(heads_[static_cast<std::size_t>(bins_)], kNone);
  origin_ = times_[static_cast<std::size_t>(waiting)];
  for (std::int32_t id = waiting; id != kNone; id = links_[static_cast<std::size_t>(id)].next) {
    origin_ = std::min(origin_, times_[static_cast<std::size_t>(id)]);
  }
  const Real width = fitted_bin_width(origin_);
  bins_per_time_ = width > 0 ? Real(1 / width) : Real(0);
  current_ = -1;
  while (waiting != kNone) {
    const std::int32_t id = waiting;
    waiting = links_[static_cast<std::size_t>(id)].next;
    place(id);
  }
}

/// About one event a bin: half of the events lie before their median.
template <class Real>
Real Calendar<Real>::fitted_bin_width(const Real& first) const {
  constexpr std::size_t kSample = 1024;  // enough for a width within some per cent
  const std::size_t stride = times_.size() / kSample + 1;
  std::vector<Real> sample;
  for (std::size_t id = 0; id < times_.size(); id += stride) {
    if (is_event(times_[id])) sample.push_back(times_[id] - first);
  }
  if (sample.empty()) return 0;
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle * 2 / static_cast<Real>(times_.size());
}

template <class Real>
void Calendar<Real>::place(std::int32_t id) {
  const double offset =
      static_cast<double>((times_[static_cast<std::size_t>(id)] - origin_) * bins_per_time_);
  if (offset < current_ + 1) {
    heap_push(id);
    return;
  }
  const std::int32_t bin = offset < bins_ ? static_cast<std::int32_t>(offset) : bins_;
  auto& link = links_[static_cast<std::size_t>(id)];
  std::int32_t& head = heads_[static_cast<std::size_t>(bin)];
  link = {head, kNone, bin};
  if (head != kNone) links_[static_cast<std::size_t>(head)].prev = id;
  head = id;
}

template <class Real>
void Calendar<Real>::remove(std::int32_t id) {
  const Link link = links_[static_cast<std::size_t>(id)];
  if (link.bin == kNowhere) return;
  links_[static_cast<std::size_t>(id)].bin = kNowhere;
  if (link.bin == kInHeap) {
    heap_remove(link.prev);
    return;
  }
  (link.prev == kNone ? heads_[static_cast<std::size_t>(link.bin)]
                      : links_[static_cast<std::size_t>(link.prev)].next) = link.next;
  if (link.next != kNone) links_[static_cast<std::size_t>(link.next)].prev = link.prev;
}

template <class Real>
void Calendar<Real>::open_bin(std::int32_t bin) {
  std::int32_t id = std::exchange(heads_[static_cast<std::size_t>(bin)], kNone);
  while (id != kNone) {
    const std::int32_t next = links_[static_cast<std::size_t>(id)].next;
    heap_push(id);
    id = next;
  }
}

template <class Real>
bool Calendar<Real>::before(std::int32_t a, std::int32_t b) const {
  const Real& time_a = times_[static_cast<std::size_t>(a)];
  const Real& time_b = times_[static_cast<std::size_t>(b)];
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
    links_[static_cast<std::size_t>(sphere)] = {kNone, at, kInHeap};
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
