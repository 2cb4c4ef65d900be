#include "run/followed_group.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/instantiate.hpp"
#include "model/real.hpp"

namespace zenosphere {
namespace {

/// Takes apart what a trial has seen of a group.
template <class Real>
class GroupExamination {
 public:
  GroupExamination(const KeptCollisions<Real>& collisions, double limit, std::int32_t spheres,
                   const HitGroup& group)
      : all_(collisions), limit_(limit), spheres_(spheres), group_(group) {}

  std::vector<SeenApproach> approaches() {
    std::vector<SeenApproach> all;
    for (const auto& cluster : deep_clusters(all_.rows, least_approach_depth, spheres_)) {
      if (is_of_group(cluster)) add(cluster, all);
    }
    std::sort(all.begin(), all.end(), [](const SeenApproach& a, const SeenApproach& b) {
      return a.first_collision < b.first_collision;
    });
    return all;
  }

 private:
  bool is_of_group(const std::vector<std::int32_t>& cluster) const {
    return std::any_of(cluster.begin(), cluster.end(), [&](std::int32_t sphere) {
      return std::binary_search(group_.spheres.begin(), group_.spheres.end(), sphere);
    });
  }

  void add(const std::vector<std::int32_t>& cluster, std::vector<SeenApproach>& all) {
    places_ = rows_of_cluster(all_.rows, cluster, spheres_);
    rows_.clear();
    for (const std::size_t place : places_) rows_.push_back(all_.rows[place]);
    window_ = smoothing_window(rows_, least_approach_depth);
    depths_ = smoothed_depths(rows_, window_);
    auto found = approaches_of(rows_, limit_, least_approach_depth);
    for (ClusterApproach& approach : found) {
      if (!approach.is_spent && approach.end == rows_.size() && has_been_left()) {
        approach.reopened_to = 0;
      }
      all.push_back(seen(approach, cluster));
    }
  }

  /// Since the cluster's last contact at a small gap the clock has gone on for longer than the last
  /// of them took: they fly apart.
  bool has_been_left() const {
    std::size_t last = rows_.size() - 1;
    while (last > 0 && rows_[last].depth < least_approach_depth) --last;
    return last >= window_ && all_.end - time(last) > time(last) - time(last - window_);
  }

  SeenApproach seen(const ClusterApproach& approach,
                    const std::vector<std::int32_t>& cluster) const {
    SeenApproach seen{.evidence = evidence(approach), .spheres = cluster};
    seen.places.assign(places_.begin() + static_cast<std::ptrdiff_t>(approach.first),
                       places_.begin() + static_cast<std::ptrdiff_t>(approach.end));
    const std::size_t first = first_place(approach);
    // A gap is met at the collision before the one that closes it.
    seen.first_collision = std::max<std::int64_t>(all_.number(first) - 1, 0);
    seen.first_time = to_decimal(all_.times[first > 0 ? first - 1 : 0]);
    add_milestones(approach, seen);
    if (approach.is_spent) add_collapse_time(seen);
    return seen;
  }

  /// The row of the first gap at the limit, or of the smallest.
  std::size_t first_place(const ClusterApproach& approach) const {
    if (approach.is_spent) return places_[approach.last];
    std::size_t deepest = approach.first;
    for (std::size_t k = approach.first; k < approach.end; ++k) {
      if (rows_[k].depth > rows_[deepest].depth) deepest = k;
    }
    return places_[deepest];
  }

  ApproachEvidence evidence(const ClusterApproach& approach) const {
    std::vector<std::pair<std::int32_t, std::int32_t>> contacts;
    ApproachEvidence evidence{.approach = approach};
    for (std::size_t k = approach.first; k <= approach.last; ++k) {
      contacts.emplace_back(rows_[k].i, rows_[k].j);
      evidence.is_dissipative = evidence.is_dissipative || all_.dissipative[places_[k]];
    }
    evidence.word = contact_word(contacts);
    if (evidence.word.is_periodic) {
      evidence.ratio = round_ratio(durations(approach, evidence.word.letters.size()));
    }
    if (approach.steady) {
      evidence.clock_ratio = clock_ratio(approach);
      evidence.curvature = curvature(approach);
    }
    return evidence;
  }

  /// The first row at which the median gap has fallen so far.
  std::size_t row_at(const ClusterApproach& approach, double depth) const {
    std::size_t row = approach.first;
    while (row < approach.last && depths_[row] < depth) ++row;
    return row;
  }

  /// Of the contacts in the steady fall that still have digits to measure it by.
  std::optional<Curvature> curvature(const ClusterApproach& approach) const {
    const double end = std::min(depths_[approach.last], limit_ - digits_to_spare);
    const std::size_t last = row_at(approach, end);
    std::vector<double> depths, margins;
    for (std::size_t k = row_at(approach, end - approach.steady->decades); k < last; ++k) {
      depths.push_back(depths_[k]);
      margins.push_back(all_.margins[places_[k]]);
    }
    return curvature_of(depths, margins);
  }

  /// Time in which the median gap fell by the last quarter of its steady fall, over that of the
  /// quarter before.
  double clock_ratio(const ClusterApproach& approach) const {
    const double end = depths_[approach.last];
    const double quarter = approach.steady->decades / 4;
    const Real& middle = time(row_at(approach, end - quarter));
    const Real third(middle - time(row_at(approach, end - 2 * quarter)));
    const Real fourth(time(approach.last) - middle);
    return third > 0 ? static_cast<double>(Real(fourth / third)) : 1;
  }

  const Real& time(std::size_t row) const { return all_.times[places_[row]]; }

  /// Durations of the rounds of a periodic word, as far back as it goes, relative to the last.
  std::vector<double> durations(const ClusterApproach& approach, std::size_t period) const {
    std::vector<double> backwards;
    const std::size_t last = last_measured(approach, std::min(14.0, limit_ / 4));
    if (last < approach.first + period) return {};
    const Real unit = time(last) - time(last - period);
    if (!(unit > 0)) return {};
    for (std::size_t k = last; k >= approach.first + period && is_same_word(k, period);
         k -= period) {
      backwards.push_back(static_cast<double>(Real((time(k) - time(k - period)) / unit)));
      if (!std::isfinite(backwards.back())) break;
    }
    return {backwards.rbegin(), backwards.rend()};
  }

  bool is_same_word(std::size_t k, std::size_t period) const {
    if (k < 2 * period) return false;
    for (std::size_t n = 0; n < period; ++n) {
      const DepthRow& one = rows_[k - n];
      const DepthRow& other = rows_[k - n - period];
      if (one.i != other.i || one.j != other.j) return false;
    }
    return true;
  }

  /// The last row whose gap is so many decades above the limit, and the error of its flight by as
  /// many below one.
  std::size_t last_measured(const ClusterApproach& approach, double decades_of_rounding) const {
    std::size_t last = approach.first;
    for (std::size_t k = approach.first; k <= approach.last; ++k) {
      if (rows_[k].depth > limit_ - decades_of_rounding) break;
      last = k;
    }
    return last;
  }

  void add_milestones(const ClusterApproach& approach, SeenApproach& seen) const {
    int decade = static_cast<int>(std::ceil(std::max(approach.from, 0.0)));
    for (std::size_t k = approach.first; k <= approach.last; ++k) {
      if (depths_[k] < decade) continue;
      decade = static_cast<int>(std::floor(depths_[k]));
      seen.milestones.push_back({decade, all_.number(places_[k]), to_decimal(time(k))});
      ++decade;
    }
  }

  /// The end of the series that the durations of the last rounds begin, by Aitken's extrapolation.
  ///
  /// Rounds are those of a periodic word; otherwise stretches of collisions, twice as long until
  /// each takes less time than the one before. The uncertainty is the range of the estimates.
  void add_collapse_time(SeenApproach& seen) const {
    const ClusterApproach& approach = seen.evidence.approach;
    const ContactWord& word = seen.evidence.word;
    const std::size_t last = last_measured(approach, 4);
    std::size_t step = word.is_periodic ? word.letters.size() : window_;
    std::vector<Real> ends;
    for (; ends.empty() && approach.first + 5 * step <= last; step *= 2) {
      ends = extrapolated_ends(last, step);
    }
    if (ends.empty()) return;
    const auto [low, high] = std::minmax_element(ends.begin(), ends.end());
    const Real rounding = std::numeric_limits<Real>::epsilon() * ends.front();
    const auto range = static_cast<double>(Real(*high - *low + rounding));
    seen.uncertainty = std::max(range, std::numeric_limits<double>::min());  // or it would be none
    seen.collapse_time = to_decimal(ends.front());
  }

  /// Estimates from the last four triples of rows a step apart; none where a stretch takes as long
  /// as the one before.
  std::vector<Real> extrapolated_ends(std::size_t last, std::size_t step) const {
    std::vector<Real> ends;
    for (std::size_t k = last; ends.size() < 4; k -= step) {
      const Real now = time(k) - time(k - step);
      const Real before = time(k - step) - time(k - 2 * step);
      if (!(now > 0 && now < before)) return {};
      ends.push_back(time(k) + now * now / (before - now));
    }
    return ends;
  }

  const KeptCollisions<Real>& all_;
  double limit_;
  std::int32_t spheres_;
  const HitGroup& group_;
  std::vector<std::size_t> places_;
  std::vector<DepthRow> rows_;
  std::vector<double> depths_;
  std::size_t window_ = 0;
};

}  // namespace

template <class Real>
std::vector<SeenApproach> approaches_seen(const KeptCollisions<Real>& collisions, double limit,
                                          std::int32_t spheres, const HitGroup& group) {
  return GroupExamination<Real>(collisions, limit, spheres, group).approaches();
}

#define ZENOSPHERE_INSTANTIATE(Real)                                                            \
  template std::vector<SeenApproach> approaches_seen<Real>(const KeptCollisions<Real>&, double, \
                                                           std::int32_t, const HitGroup&);
ZENOSPHERE_FOR_EACH_REAL(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
