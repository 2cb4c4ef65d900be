#include "collapse/approach.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "collapse/contact_graph.hpp"

namespace zenosphere {
namespace {

constexpr std::int64_t least_repeats = 3;  // once or twice happens in any dense gas
constexpr double least_steady_decades = 4;
constexpr double most_uneven = 2;  // quarters of a stretch of one law

/// A rise of the smoothed depth to a peak, from the valley before it.
struct Rise {
  std::size_t valley = 0;
  std::size_t peak = 0;
  std::size_t end = 0;  ///< where the next rise begins, or behind the last row
  bool is_over = false;
};

/// Parts a series into its rises: each ends where it has come down from its peak by `prominence`,
/// or by a fifth of its height if that is more.
std::vector<Rise> rises_of(const std::vector<double>& depths, double prominence) {
  std::vector<Rise> rises;
  Rise rise;
  bool is_rising = true;
  for (std::size_t k = 0; k < depths.size(); ++k) {
    if (is_rising) {
      if (depths[k] > depths[rise.peak]) rise.peak = k;
      const double height = depths[rise.peak];
      if (depths[k] > height - std::max(prominence, height / 5)) continue;
      rise.end = k;
      rise.is_over = true;
      rises.push_back(rise);
      rise = {k, k, 0, false};
      is_rising = false;
    } else {
      if (depths[k] < depths[rise.valley]) rise.valley = k;
      if (depths[k] < depths[rise.valley] + prominence) continue;
      rise.peak = k;
      is_rising = true;
      if (!rises.empty()) rises.back().end = rise.valley;
    }
  }
  if (!is_rising) {
    if (!rises.empty()) rises.back().end = depths.size();
    return rises;
  }
  rise.end = depths.size();
  rises.push_back(rise);
  return rises;
}

/// The rates, in decades a collision, in the four quarters of a stretch.
std::optional<SteadyFall> law_between(const std::vector<double>& depths, std::size_t first,
                                      std::size_t last) {
  constexpr std::size_t quarters = 4;
  if (last - first < 2 * quarters) return std::nullopt;
  double slowest = 0;
  double fastest = 0;
  for (std::size_t q = 0; q < quarters; ++q) {
    const std::size_t a = first + (last - first) * q / quarters;
    const std::size_t b = first + (last - first) * (q + 1) / quarters;
    const double rate = (depths[b] - depths[a]) / static_cast<double>(b - a);
    slowest = q == 0 ? rate : std::min(slowest, rate);
    fastest = q == 0 ? rate : std::max(fastest, rate);
  }
  if (!(slowest > 0)) return std::nullopt;
  const double decades = depths[last] - depths[first];
  return SteadyFall{decades, decades / static_cast<double>(last - first), fastest / slowest};
}

/// The longest stretch up to `last` in which the gaps fall by one law, in steps of a decade.
std::optional<SteadyFall> steady_fall(const std::vector<double>& depths, std::size_t first,
                                      std::size_t last) {
  std::optional<SteadyFall> best;
  double wanted = least_steady_decades;
  for (std::size_t k = last; k-- > first;) {
    if (depths[k] > depths[last] - wanted) continue;
    wanted = std::floor(depths[last] - depths[k]) + 1;
    const auto law = law_between(depths, k, last);
    if (law && law->unevenness <= most_uneven) best = law;
  }
  return best;
}

/// Share of the whole decades from `least` up to two above the limit that any gap was seen in.
double visited_share(std::span<const DepthRow> rows, double least, double limit) {
  std::set<int> seen;
  for (const DepthRow& row : rows) {
    if (row.depth >= least && row.depth < limit - 2) seen.insert(static_cast<int>(row.depth));
  }
  const double all = std::max(1.0, std::floor(limit - 2) - std::floor(least));
  return static_cast<double>(seen.size()) / all;
}

ClusterApproach approach_of(std::span<const DepthRow> rows, const std::vector<double>& depths,
                            const Rise& rise, double limit, double least_depth) {
  ClusterApproach approach{.first = rise.valley, .last = rise.peak, .end = rise.end};
  for (std::size_t k = rise.valley; k <= rise.peak && !approach.is_spent; ++k) {
    approach.is_spent = rows[k].at_limit;
    if (approach.is_spent) approach.last = k;
  }
  for (std::size_t k = rise.valley; k < rise.end; ++k) {
    if (!rows[k].at_limit) approach.deepest = std::max(approach.deepest, rows[k].depth);
  }
  approach.from = depths[approach.first];
  approach.to = depths[approach.last];
  if (rise.is_over) {
    const auto after = depths.begin() + static_cast<std::ptrdiff_t>(rise.peak);
    const auto end =
        depths.begin() + static_cast<std::ptrdiff_t>(std::min(rise.end + 1, depths.size()));
    approach.reopened_to = *std::min_element(after, end);
  }
  approach.visited = visited_share(rows.subspan(rise.valley, rise.peak + 1 - rise.valley),
                                   std::max(least_depth, depths[rise.valley]), limit);
  approach.steady = steady_fall(depths, approach.first, approach.last);
  return approach;
}

}  // namespace

std::vector<std::vector<std::int32_t>> deep_clusters(std::span<const DepthRow> rows,
                                                     double least_depth, std::int32_t spheres) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int64_t> met;
  for (const DepthRow& row : rows) {
    if (row.depth >= least_depth) ++met[{row.i, row.j}];
  }
  ContactGraph graph;
  std::set<std::int32_t> left;
  for (const auto& [pair, times] : met) {
    if (times < least_repeats) continue;
    left.insert(pair.first);
    graph.add(pair.first);
    if (pair.second >= spheres) continue;
    left.insert(pair.second);
    graph.connect(pair.first, pair.second);
  }
  std::vector<std::vector<std::int32_t>> clusters;
  while (!left.empty()) {
    clusters.push_back(graph.component(*left.begin()));
    for (const std::int32_t sphere : clusters.back()) left.erase(sphere);
  }
  return clusters;
}

std::vector<std::size_t> rows_of_cluster(std::span<const DepthRow> rows,
                                         std::span<const std::int32_t> cluster,
                                         std::int32_t spheres) {
  const auto is_in = [&](std::int32_t sphere) {
    return std::binary_search(cluster.begin(), cluster.end(), sphere);
  };
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (is_in(rows[k].i) && (rows[k].j >= spheres || is_in(rows[k].j))) places.push_back(k);
  }
  return places;
}

std::size_t smoothing_window(std::span<const DepthRow> cluster_rows, double least_depth) {
  std::set<std::pair<std::int32_t, std::int32_t>> pairs;
  for (const DepthRow& row : cluster_rows) {
    if (row.depth >= least_depth) pairs.insert({row.i, row.j});
  }
  return std::clamp<std::size_t>(4 * pairs.size(), 4, 512);
}

std::vector<double> smoothed_depths(std::span<const DepthRow> cluster_rows, std::size_t window) {
  std::vector<double> smoothed;
  smoothed.reserve(cluster_rows.size());
  std::vector<double> sorted;  // the last `window` depths
  for (std::size_t k = 0; k < cluster_rows.size(); ++k) {
    const auto place_of = [&](double depth) {
      return std::lower_bound(sorted.begin(), sorted.end(), depth);
    };
    if (k >= window) sorted.erase(place_of(cluster_rows[k - window].depth));
    sorted.insert(place_of(cluster_rows[k].depth), cluster_rows[k].depth);
    smoothed.push_back(sorted[(sorted.size() - 1) / 2]);
  }
  return smoothed;
}

std::vector<ClusterApproach> approaches_of(std::span<const DepthRow> cluster_rows, double limit,
                                           double least_depth) {
  const std::vector<double> depths =
      smoothed_depths(cluster_rows, smoothing_window(cluster_rows, least_depth));
  std::vector<ClusterApproach> approaches;
  for (const Rise& rise : rises_of(depths, std::clamp(limit / 4, 4.0, 10.0))) {
    if (depths[rise.peak] < least_depth) continue;
    approaches.push_back(approach_of(cluster_rows, depths, rise, limit, least_depth));
  }
  return approaches;
}

}  // namespace zenosphere
