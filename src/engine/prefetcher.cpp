#include "engine/prefetcher.hpp"

#include <span>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// So many events are looked at together: while a processor looks up a page of memory it goes on
/// with the next instructions, but not for long.
constexpr std::size_t events_at_once = 4;

/// By how many events what they need is prefetched. What has been prefetched in one step tells what
/// to prefetch in the next.
constexpr std::size_t own_ahead = 32;
constexpr std::size_t around_ahead = 22;
constexpr std::size_t neighbours_ahead = 14;
constexpr std::size_t stale_ahead = 7;

}  // namespace

/// The steps for one event that is so far ahead.
template <int Dim, class Real>
struct Prefetcher<Dim, Real>::Ahead {
  using Event = typename Calendar<Real>::Event;

  const System<Dim, Real>& system;
  const Predictor<Dim, Real>& predictor;
  const std::byte* observed;
  std::size_t observed_bytes;

  /// What is kept of a sphere.
  void own(std::int32_t i) const {
    system.spheres.prefetch(i);
    system.search.prefetch(i);
    prefetch_line(&predictor.meetings(i));
    predictor.calendar().prefetch(i);
  }

  /// The cells around a sphere whose list will be rebuilt, or the partner that it meets.
  void around(const Event& event) const {
    const Meeting<Real>& first = predictor.meetings(event.id).first();
    if (event.time < first.time) {
      system.search.prefetch_around(system.spheres, event.id, event.time);
    } else {
      partner(first);
    }
  }

  /// All spheres that a prediction will look at; or the second partner, where the first has met
  /// another one.
  void neighbours(const Event& event) const {
    const Meeting<Real>& first = predictor.meetings(event.id).first();
    if (event.time < first.time) return;
    if (predictor.is_stale(first, system)) return partner(predictor.meetings(event.id).second());
    neighbours(event.id);
    if (!system.wall(first.partner())) neighbours(first.partner());
  }

  /// All spheres that a prediction will look at that is made because no known meeting holds any
  /// more.
  void in_place_of_stale(const Event& event) const {
    const NextMeetings<Real>& next = predictor.meetings(event.id);
    if (event.time < next.first().time || !predictor.is_stale(next.first(), system)) return;
    if (!predictor.is_second_known(next, system)) neighbours(event.id);
  }

 private:
  void partner(const Meeting<Real>& meeting) const {
    if (meeting.has_partner() && !system.wall(meeting.partner())) own(meeting.partner());
  }
  void neighbours(std::int32_t i) const {
    for (const Neighbour neighbour : system.neighbours(i)) {
      system.spheres.prefetch(neighbour.sphere());
    }
    if (observed) prefetch_line(observed + static_cast<std::size_t>(i) * observed_bytes);
  }
};

template <int Dim, class Real>
void Prefetcher<Dim, Real>::prefetch(const System<Dim, Real>& system,
                                     Predictor<Dim, Real>& predictor) {
  Calendar<Real>& calendar = predictor.calendar();
  const std::int64_t passed = calendar.passed();
  const auto count = static_cast<std::size_t>(passed - prefetched_);
  if (count < events_at_once) return;
  prefetched_ = passed;
  calendar.line_up(own_ahead + 1);
  const std::span line = calendar.line();
  if (count > stale_ahead || line.size() <= own_ahead) return;  // a new cycle
  const Ahead ahead{system, predictor, observed_, observed_bytes_};
  for (std::size_t k = count; k-- > 0;) ahead.own(line[own_ahead - k].id);
  for (std::size_t k = count; k-- > 0;) ahead.around(line[around_ahead - k]);
  for (std::size_t k = count; k-- > 0;) ahead.neighbours(line[neighbours_ahead - k]);
  for (std::size_t k = count; k-- > 0;) ahead.in_place_of_stale(line[stale_ahead - k]);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) \
  template void Prefetcher<Dim, Real>::prefetch(const System<Dim, Real>&, Predictor<Dim, Real>&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
