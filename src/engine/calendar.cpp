#include "engine/calendar.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>
#include <utility>

#include "engine/simd/places_in_order.hpp"
#include "engine/simd/wide_lanes.hpp"
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
      bin_count_(size),
      bins_(std::min(bins_in_group, std::bit_ceil(static_cast<std::uint32_t>(size)))),
      groups_(static_cast<std::size_t>(size) / bins_in_group + 1),
      lanes_are_wide_(has_wide_lanes()) {
  end_cycle();
}

template <class Real>
void Calendar<Real>::schedule(std::int32_t id, const Real& time) {
  Real& own = times_[static_cast<std::size_t>(id)];
  const bool has_place = own == time;
  own = time;
  if (has_place || !is_event(time)) return;
  place(id);
  // As in a collapse, where spheres get new events all the time and the old ones never come.
  if (entries_ > 2 * times_.size() + 1024) end_cycle();
}

/// Opens the next bin, or begins a new cycle. Returns whether there is any event.
template <class Real>
bool Calendar<Real>::go_on() {
  if (opened_ == bin_count_) return start_cycle();
  open_bin();
  return true;
}

template <class Real>
void Calendar<Real>::shift_times(const Real& span) {
  end_cycle();
  for (Real& time : times_) time -= span;
}

/// Lets every event wait for the next cycle.
template <class Real>
void Calendar<Real>::end_cycle() {
  for (Bin& bin : bins_) bin.size = 0;
  for (Group& group : groups_) group.clear();
  next_ = line_end_ = 0;
  heap_.clear();
  entries_ = 0;
  opened_ = open_end_ = bin_count_;
  origin_ = -std::numeric_limits<Real>::infinity();
  bins_per_time_ = 1;
}

/// Spreads the events over the bins of a new cycle. Returns whether there are any.
template <class Real>
bool Calendar<Real>::start_cycle() {
  const Real first = *std::min_element(times_.begin(), times_.end());
  if (!is_event(first)) return false;
  fit_bins(first);
  opened_ = 0;
  open_end_ = std::min(bin_count_, std::int32_t{bins_in_group});  // the first group is empty
  for (std::size_t id = 0; id < times_.size(); ++id) {
    if (is_event(times_[id])) place(static_cast<std::int32_t>(id));
  }
  return true;
}

/// The bins reach eight times as far as half of the events, so that few come later.
template <class Real>
void Calendar<Real>::fit_bins(const Real& first) {
  constexpr int medians = 8;
  constexpr std::size_t most_in_sample = 1024;  // enough for a width within some per cent
  const std::size_t stride = times_.size() / most_in_sample + 1;
  std::vector<Real> sample;
  for (std::size_t id = 0; id < times_.size(); id += stride) {
    if (is_event(times_[id])) sample.push_back(times_[id] - first);
  }
  origin_ = first;
  bins_per_time_ = 0;  // all in one bin
  if (sample.empty()) return;
  const auto median = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), median, sample.end());
  const Real per_time = static_cast<Real>(bin_count_) / (*median * medians);
  if (is_event(per_time)) bins_per_time_ = per_time;
}

template <class Real>
void Calendar<Real>::place(std::int32_t id) {
  const double offset = bins_after_origin(time(id));
  if (!(offset < bin_count_)) return;  // the next cycle will find it
  ++entries_;
  if (offset < opened_) return put_in_heap(id);
  const auto number = static_cast<std::int32_t>(offset);
  if (number < open_end_) return put_in_bin(id, number);
  group(number).push_back(id);
}

/// Where a bin is full the heap takes what comes.
template <class Real>
void Calendar<Real>::put_in_bin(std::int32_t id, std::int32_t number) {
  Bin& bin = this->bin(number);
  if (bin.size == Bin::room) [[unlikely]]
    return put_in_heap(id);
  bin.ids[bin.size++] = id;
}

template <class Real>
void Calendar<Real>::put_in_heap(std::int32_t id) {
  if (heap_.size() >= heap_limit_) clear_heap_of_void();
  heap_.push_back({time(id), id});
  std::push_heap(heap_.begin(), heap_.end(), is_after);
}

/// Where many events come soon, as in a cluster that collapses, most of the heap would be void.
template <class Real>
void Calendar<Real>::clear_heap_of_void() {
  entries_ -= std::erase_if(heap_, [this](const Event& event) { return is_void(event); });
  std::make_heap(heap_.begin(), heap_.end(), is_after);
  heap_limit_ = 2 * heap_.size() + 32;
}

template <class Real>
void Calendar<Real>::drop_void_heap() {
  while (!heap_.empty() && is_void(heap_.front())) {
    std::pop_heap(heap_.begin(), heap_.end(), is_after);
    heap_.pop_back();
    --entries_;
  }
}

/// Parts the next group into bins.
template <class Real>
void Calendar<Real>::open_group() {
  constexpr std::ptrdiff_t ahead = 16;
  Group& group = this->group(open_end_);
  entries_ -= group.size();
  open_end_ += std::int32_t{bins_in_group};
  for (auto id = group.begin(); id != group.end(); ++id) {
    if (group.end() - id > ahead) prefetch(id[ahead]);
    const double offset = bins_after_origin(time(*id));
    if (!(offset >= opened_ && offset < open_end_)) continue;
    put_in_bin(*id, static_cast<std::int32_t>(offset));
    ++entries_;
  }
  group.clear();
}

/// Lets the events of the next bin stand in line.
template <class Real>
void Calendar<Real>::open_bin() {
  if (opened_ == open_end_) open_group();
  Bin& bin = this->bin(opened_);
  Times times;
  Ids ids{};
  times.fill(std::numeric_limits<Real>::infinity());
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < bin.size; ++k) {
    ids[count] = bin.ids[k];
    times[count] = time(bin.ids[k]);
    const double offset = bins_after_origin(times[count]);
    count += static_cast<std::size_t>(offset >= opened_) &
             static_cast<std::size_t>(offset < opened_ + 1);
  }
  times[count] = std::numeric_limits<Real>::infinity();
  entries_ -= std::exchange(bin.size, 0);
  stand_in_line(times, ids, count);
  lined_up_ += static_cast<std::int64_t>(count);
  ++opened_;
  if (groups_.size() > 1 && opened_ < open_end_) {
    const Bin& next = this->bin(opened_);
    for (std::uint32_t k = 0; k < next.size; ++k) prefetch(next.ids[k]);
  }
}

/// Lets events stand at the end of the line, earliest first.
template <class Real>
void Calendar<Real>::stand_in_line(const Times& times, const Ids& ids, std::size_t count) {
  if (next_ == line_end_) next_ = line_end_ = 0;
  if (line_end_ + most_in_order > line_.size()) make_room_in_line();
  Event* const events = line_.data() + line_end_;
  line_end_ += count;
  if constexpr (std::is_same_v<Real, double>) {
    if (lanes_are_wide_) {
      const PlacesInOrder order = places_in_order_wide(times, count);
      // Without a look at `count`, which would have to be guessed: no events come behind the
      // others.
      for (std::size_t k = 0; k < order.compared; ++k) events[order.places[k]] = {times[k], ids[k]};
      if (order.all_differ) [[likely]]
        return;
    }
  }
  for (std::size_t k = 0; k < count; ++k) events[k] = {times[k], ids[k]};
  std::sort(events, events + count, is_before);
}

/// Makes room behind the end of the line: from its front where that is half of it.
template <class Real>
void Calendar<Real>::make_room_in_line() {
  if (next_ < line_.size() / 2) return line_.resize(2 * line_.size());
  const auto front = line_.begin() + static_cast<std::ptrdiff_t>(next_);
  std::copy(front, line_.begin() + static_cast<std::ptrdiff_t>(line_end_), line_.begin());
  line_end_ -= std::exchange(next_, 0);
}

#define ZENOSPHERE_INSTANTIATE(Real) template class Calendar<Real>;
ZENOSPHERE_FOR_EACH_REAL(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
