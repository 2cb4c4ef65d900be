// What the next events need is fetched into the cache before they come.

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/simulation.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Bins of the calendar whose events are looked at together.
constexpr std::int32_t bins_a_round = 4;

/// How much earlier than its events a round begins: time for the steps below, and for the
/// spheres that are one or two behind the first of their bin.
constexpr std::int32_t rounds_ahead = 8;

}  // namespace

template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_ahead() {
  fetches_.fetch(8 + fetches_.size() / 4);
  const std::int32_t round = calendar_.current_bin() / bins_a_round;
  fetched_round_ = std::clamp(fetched_round_, round - rounds_ahead, round);
  while (fetched_round_ < round) fetch_round(++fetched_round_);
}

/// Takes everyone who will have an event soon one step on: what has been fetched in one round tells
/// what to fetch in the next.
template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_round(std::int32_t round) {
  std::vector<std::int32_t>& found = soon_.found;
  std::vector<std::int32_t>& known = soon_.known;
  std::vector<std::int32_t>& ready = soon_.ready;
  for (const std::int32_t i : ready) fetch_neighbours(i);
  for (const std::int32_t i : known) fetch_surroundings(i);
  ready.clear();
  std::swap(ready, known);
  std::swap(known, found);
  const auto find = [&](std::int32_t i) {
    if (i == Calendar<Real>::kNone) return;
    found.push_back(i);
    calendar_.add_to(fetches_, i);
  };
  for (const std::int32_t i : known) {
    fetch(i);
    find(calendar_.behind_in_bin(i));
  }
  const std::int32_t first = (round + rounds_ahead) * bins_a_round;
  for (std::int32_t bin = first; bin < first + bins_a_round; ++bin) find(calendar_.in_bin(bin));
}

template <int Dim, class Real>
void Simulation<Dim, Real>::fetch(std::int32_t i) {
  spheres_.add_to(fetches_, i);
  fetches_.add(&meetings(i));
}

/// The cells around a sphere that will be settled, or the partner that it meets.
template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_surroundings(std::int32_t i) {
  if (will_settle(i)) {
    spheres_.add_cells_to(fetches_, i);
  } else {
    fetch_partner(meetings(i).first());
  }
}

/// All whom a prediction will look at; or the second partner, where the first has met somebody
/// else.
template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_neighbours(std::int32_t i) {
  const Meeting<Real>& first = meetings(i).first();
  const Meeting<Real>& second = meetings(i).second();
  if (will_settle(i) || !first.is_with_anybody()) return;
  if (is_stale(first) && second.is_with_anybody()) return fetch_partner(second);
  spheres_.add_neighbours_to(fetches_, i);
  fetch_observed(i);
  if (is_stale(first) || wall(first.partner())) return;
  spheres_.add_neighbours_to(fetches_, first.partner());
  fetch_observed(first.partner());
}

template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_observed(std::int32_t i) {
  if (observed_) fetches_.add(observed_ + static_cast<std::size_t>(i) * observed_bytes_);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::fetch_partner(const Meeting<Real>& meeting) {
  const std::int32_t j = meeting.partner();
  if (!meeting.is_with_anybody() || wall(j)) return;
  fetch(j);
  calendar_.add_to(fetches_, j);
}

template <int Dim, class Real>
bool Simulation<Dim, Real>::will_settle(std::int32_t i) const {
  return calendar_.time(i) < meetings(i).first().time;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template void Simulation<Dim, Real>::fetch_ahead();
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
