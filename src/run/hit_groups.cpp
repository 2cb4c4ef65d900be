#include "run/hit_groups.hpp"

#include <algorithm>
#include <utility>

namespace zenosphere {

namespace {

/// Hits of the same spheres belong together within this share of the mean time between two
/// collisions of a sphere: sooner no other sphere has much to do with them.
constexpr double nearness = 0.01;

void insert(std::vector<std::int32_t>& sorted, std::int32_t sphere) {
  const auto place = std::lower_bound(sorted.begin(), sorted.end(), sphere);
  if (place == sorted.end() || *place != sphere) sorted.insert(place, sphere);
}

bool holds(const std::vector<std::int32_t>& sorted, std::int32_t sphere) {
  return std::binary_search(sorted.begin(), sorted.end(), sphere);
}

bool touch(const HitGroup& group, const HitGroup& other) {
  return std::any_of(other.spheres.begin(), other.spheres.end(),
                     [&](std::int32_t sphere) { return holds(group.spheres, sphere); });
}

void merge(HitGroup& into, const HitGroup& other) {
  HitGroup merged = other.first_hit < into.first_hit ? other : into;
  for (const std::int32_t sphere : into.spheres) insert(merged.spheres, sphere);
  for (const std::int32_t sphere : other.spheres) insert(merged.spheres, sphere);
  merged.hits = into.hits + other.hits;
  merged.from = std::min(into.from, other.from);
  merged.last_hit = std::max(into.last_hit, other.last_hit);
  merged.last_time = std::max(into.last_time, other.last_time);
  into = std::move(merged);
}

}  // namespace

bool is_of(const HitGroup& group, const DepthRow& row) {
  return holds(group.spheres, row.i) || holds(group.spheres, row.j);
}

double mean_time_between_collisions(const HitGroup& group, std::int32_t spheres) {
  return group.first_time * spheres /
         (2 * static_cast<double>(std::max<std::int64_t>(group.first_hit, 1)));
}

void mark_arrest(std::int32_t sphere, std::int64_t collision, std::vector<HitGroup>& groups) {
  const auto last = std::find_if(groups.rbegin(), groups.rend(), [&](const HitGroup& group) {
    return std::binary_search(group.spheres.begin(), group.spheres.end(), sphere);
  });
  if (last != groups.rend()) last->arrest = collision;
}

HitGroups::HitGroups(std::int32_t spheres)
    : spheres_(spheres), lead_(static_cast<std::size_t>(std::max(spheres, 100))) {}

void HitGroups::observe(std::int64_t collision, const DepthRow& row) {
  recent_.push_back({collision, row});
  if (recent_.size() > lead_) recent_.pop_front();
}

void HitGroups::observe_hit(std::int64_t collision, double time, const DepthRow& next) {
  HitGroup hit{.first_hit = collision,
               .last_hit = collision,
               .first_time = time,
               .last_time = time,
               .i = next.i,
               .j = next.j,
               .hits = 1,
               .spheres = {next.i}};
  if (next.j < spheres_) insert(hit.spheres, next.j);
  close_before(hit);
  trace_back(hit);
  const auto touched = std::stable_partition(
      open_.begin(), open_.end(), [&](const HitGroup& group) { return !touch(group, hit); });
  if (touched == open_.end()) {
    open_.push_back(std::move(hit));
    return;
  }
  for (auto other = touched + 1; other != open_.end(); ++other) merge(*touched, *other);
  hit.from = touched->from;
  merge(*touched, hit);
  open_.erase(touched + 1, open_.end());
}

/// Closes the groups whose spheres have had time to do other things before this hit.
void HitGroups::close_before(const HitGroup& hit) {
  const double near = nearness * mean_time_between_collisions(hit, spheres_);
  const auto closed = std::stable_partition(open_.begin(), open_.end(), [&](const HitGroup& group) {
    return hit.first_time - group.last_time <= near;
  });
  closed_.insert(closed_.end(), closed, open_.end());
  open_.erase(closed, open_.end());
}

/// Adds the spheres that small gaps connect with a hit, followed backwards from contact to contact
/// but not beyond gaps that were at the limit themselves; and the collision before the first.
void HitGroups::trace_back(HitGroup& hit) const {
  hit.from = hit.first_hit;
  for (auto recent = recent_.rbegin(); recent != recent_.rend(); ++recent) {
    const DepthRow& row = recent->row;
    if (row.depth < least_approach_depth) continue;
    if (!holds(hit.spheres, row.i) && !holds(hit.spheres, row.j)) continue;
    insert(hit.spheres, row.i);
    if (row.j < spheres_) insert(hit.spheres, row.j);
    if (row.at_limit) break;
    hit.from = recent->collision - 1;
  }
  hit.from = std::max<std::int64_t>(hit.from - 1, 0);
}

std::vector<HitGroup> HitGroups::groups() const {
  std::vector<HitGroup> sorted = closed_;
  sorted.insert(sorted.end(), open_.begin(), open_.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const HitGroup& a, const HitGroup& b) { return a.first_hit < b.first_hit; });
  return sorted;
}

}  // namespace zenosphere
