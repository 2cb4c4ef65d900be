// What the next events need is fetched into the cache before they come.

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// So many events are looked at together: while a processor looks up a page of memory it goes on
/// with the next instructions, but not for long.
constexpr std::size_t events_at_once = 4;

/// By how many events what they need is fetched ahead. What has been fetched in one step tells what
/// to fetch in the next.
constexpr std::size_t own_ahead = 32;
constexpr std::size_t around_ahead = 22;
constexpr std::size_t neighbours_ahead = 14;
constexpr std::size_t stale_ahead = 7;

}  // namespace

template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_ahead() {
  const std::int64_t passed = calendar_.passed();
  const auto count = static_cast<std::size_t>(passed - fetched_);
  if (count < events_at_once) return;
  fetched_ = passed;
  calendar_.line_up(own_ahead + 1);
  const std::span line = calendar_.line();
  if (count > stale_ahead || line.size() <= own_ahead) return;  // a new cycle
  for (std::size_t k = count; k-- > 0;) fetch_own(line[own_ahead - k].id);
  for (std::size_t k = count; k-- > 0;) fetch_around(line[around_ahead - k]);
  for (std::size_t k = count; k-- > 0;) fetch_neighbours(line[neighbours_ahead - k]);
  for (std::size_t k = count; k-- > 0;) fetch_in_place_of_stale(line[stale_ahead - k]);
}

/// What is kept of a sphere.
template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_own(std::int32_t i) {
  spheres_.fetch(i);
  fetch_line(&meetings_[static_cast<std::size_t>(i)]);
  calendar_.fetch(i);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_partner(const Meeting<Real>& meeting) {
  if (meeting.is_with_anybody() && !wall(meeting.partner())) fetch_own(meeting.partner());
}

/// The cells around a sphere that will be settled, or the partner that it meets.
template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_around(const Event& event) {
  const Meeting<Real>& first = meetings(event.id).first();
  if (event.time < first.time) {
    spheres_.fetch_cells(event.id, event.time);
  } else {
    fetch_partner(first);
  }
}

/// All whom a prediction will look at; or the second partner, where the first has met somebody
/// else.
template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_neighbours(const Event& event) {
  const Meeting<Real>& first = meetings(event.id).first();
  if (event.time < first.time) return;
  if (is_stale(first)) return fetch_partner(meetings(event.id).second());
  fetch_neighbours(event.id);
  if (!wall(first.partner())) fetch_neighbours(first.partner());
}
template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_neighbours(std::int32_t i) {
  spheres_.fetch_neighbours(i);
  if (observed_) fetch_line(observed_ + static_cast<std::size_t>(i) * observed_bytes_);
}

/// All whom a prediction will look at that is made because no known meeting holds any more.
template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_in_place_of_stale(const Event& event) {
  const NextMeetings<Real>& next = meetings(event.id);
  if (event.time < next.first().time || !is_stale(next.first())) return;
  if (!is_second_known(next)) fetch_neighbours(event.id);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template void Simulation<Dim, Real>::fetch_ahead();
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
