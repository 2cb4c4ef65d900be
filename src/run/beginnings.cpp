#include "run/beginnings.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "model/instantiate.hpp"
#include "run/cluster_gaps.hpp"

namespace zenosphere {
namespace {

/// The choice of a state among those that a run goes through before a hit.
class Choice {
 public:
  /// \param takes_first  if the first state offered will do, should its gaps be wide
  explicit Choice(bool takes_first) : takes_first_(takes_first) {}

  /// \param depth  decades of the smallest gap of the group
  void offer(std::int64_t collision, double depth) {
    const bool is_first = chosen_ < 0;
    if (has_taken_first_) return;
    if (collision == 0 || depth < least_approach_depth) {
      chosen_ = collision;
      has_wide_ = true;
      has_taken_first_ = is_first && takes_first_;
    } else if (!has_wide_ && (is_first || depth < depth_)) {
      chosen_ = collision;
      depth_ = depth;
    }
  }
  std::int64_t chosen() const { return chosen_; }

 private:
  bool takes_first_;
  bool has_taken_first_ = false;
  bool has_wide_ = false;
  std::int64_t chosen_ = -1;
  double depth_ = 0;
};

/// Whether the smallest gap of a group is looked for after this collision: it has moved a sphere of
/// the group. In a large group only now and then, as the search takes the square of its size.
bool is_looked_at(const HitGroup& group, std::int64_t collision, const DepthRow& row) {
  constexpr std::size_t pairs_each = 4096;
  const std::size_t pairs = group.spheres.size() * group.spheres.size();
  const auto every = static_cast<std::int64_t>(1 + pairs / pairs_each);
  return is_of(group, row) && collision % every == 0;
}

}  // namespace

template <int Dim, class Real>
Beginnings<Dim, Real>::Beginnings(const Case& values, const std::vector<HitGroup>& groups,
                                  TrialEnd limits)
    : groups_(groups),
      limits_(std::move(limits)),
      lead_(std::max<std::int64_t>(values.system.spheres, 100)),
      order_(groups.size()),
      run_(values) {
  for (std::size_t n = 0; n < groups.size(); ++n) begins_.push_back(earliest(n));
  if (groups.size() > 1) choose_by_gaps(values);
  std::iota(order_.begin(), order_.end(), 0);
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return begins_[a] < begins_[b]; });
}

template <int Dim, class Real>
Before Beginnings<Dim, Real>::before(std::size_t group) {
  for (; !waiting_.contains(group); ++next_) {
    const std::size_t n = order_[next_];
    run_.go(until(begins_[n]));
    waiting_[n] = {groups_[n], run_.collisions(), significand_bits<Real>(), run_.state()};
  }
  return std::move(waiting_.extract(group).mapped());
}

template <int Dim, class Real>
TrialEnd Beginnings<Dim, Real>::until(std::int64_t collisions) const {
  TrialEnd end = limits_;
  end.collisions = collisions;
  return end;
}

template <int Dim, class Real>
std::int64_t Beginnings<Dim, Real>::earliest(std::size_t group) const {
  return std::max<std::int64_t>(groups_[group].first_hit - lead_, 0);
}

/// Goes through the states before all groups but the first, and chooses for each.
template <int Dim, class Real>
void Beginnings<Dim, Real>::choose_by_gaps(const Case& values) {
  TrialRun<Dim, Real> run(values);
  std::vector<Choice> choices;
  std::int64_t latest_hit = -1;
  for (std::size_t n = 0; n < groups_.size(); ++n) {
    choices.emplace_back(latest_hit < earliest(n));
    latest_hit = std::max(latest_hit, groups_[n].last_hit);
  }
  std::size_t first = 1;  // the groups from here to `last` have begun, and their hits are to come
  std::size_t last = 1;
  for (std::int64_t next = earliest(1); first < groups_.size(); next = run.collisions() + 1) {
    if (first == last) next = std::max(next, earliest(first));
    run.go(until(next));
    if (run.collisions() < next) break;  // it was interrupted, or its case has ended it
    std::optional<ClusterGaps<Dim, Real>> gaps;
    while (last < groups_.size() && earliest(last) <= next) ++last;
    for (std::size_t n = first; n < last; ++n) {
      if (next != earliest(n) && !is_looked_at(groups_[n], next, run.last_row())) continue;
      if (!gaps) gaps.emplace(run.gaps());
      choices[n].offer(next, gaps->smallest(groups_[n].spheres, run.limit()));
    }
    while (first < last && groups_[first].first_hit <= next) ++first;
  }
  for (std::size_t n = 1; n < groups_.size(); ++n) {
    if (choices[n].chosen() >= 0) begins_[n] = choices[n].chosen();
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Beginnings<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
