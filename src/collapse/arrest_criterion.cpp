#include "collapse/arrest_criterion.hpp"

#include <algorithm>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
void ArrestCriterion<Dim, Real>::go_on(const Collision<Dim, Real>& collision) {
  remember(collision);
  const auto pairs = static_cast<std::int64_t>(seen_.size());
  const bool is_long_enough =
      collision.number - stretch_start_ >= std::max(window_, repetitions_ * pairs);
  if (is_long_enough && collision.number - newest_pair_ >= window_ / 2) conclude(collision);
}

template <int Dim, class Real>
void ArrestCriterion<Dim, Real>::remember(const Collision<Dim, Real>& collision) {
  const Pair pair{collision.i, collision.j};
  const auto place =
      std::lower_bound(seen_.begin(), seen_.end(), pair,
                       [](const Seen& seen, const Pair& wanted) { return seen.pair < wanted; });
  if (place != seen_.end() && place->pair == pair) {
    place->last = collision.number;
    return;
  }
  seen_.insert(place, {pair, collision.number});
  newest_pair_ = collision.number;
}

template <int Dim, class Real>
void ArrestCriterion<Dim, Real>::conclude(const Collision<Dim, Real>& collision) {
  collision_ = collision.number;
  time_ = since_start(collision.time, clock_unit_);
  for (const Seen& seen : seen_) {
    if (seen.last > collision.number - window_ / 2) pairs_.push_back(seen.pair);
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class ArrestCriterion<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
