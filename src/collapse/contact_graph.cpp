#include "collapse/contact_graph.hpp"

#include <algorithm>

namespace zenosphere {

void ContactGraph::connect(std::int32_t i, std::int32_t j) {
  auto& from_i = neighbours_[i];
  if (std::find(from_i.begin(), from_i.end(), j) != from_i.end()) return;
  from_i.push_back(j);
  neighbours_[j].push_back(i);
}

std::vector<std::pair<std::int32_t, std::int32_t>> ContactGraph::breadth_first(
    std::int32_t root) const {
  std::vector<std::pair<std::int32_t, std::int32_t>> reached{{root, root}};
  std::map<std::int32_t, bool> is_known{{root, true}};
  for (std::size_t n = 0; n < reached.size(); ++n) {
    const std::int32_t from = reached[n].first;
    for (const std::int32_t to : neighbours_.at(from)) {
      if (is_known[to]) continue;
      is_known[to] = true;
      reached.emplace_back(to, from);
    }
  }
  return reached;
}

std::vector<std::int32_t> ContactGraph::component(std::int32_t sphere) const {
  std::vector<std::int32_t> members;
  for (const auto& [member, from] : breadth_first(sphere)) members.push_back(member);
  std::sort(members.begin(), members.end());
  return members;
}

bool ContactGraph::is_ring(const std::vector<std::int32_t>& spheres) const {
  return std::all_of(spheres.begin(), spheres.end(),
                     [&](std::int32_t sphere) { return neighbours(sphere).size() == 2; });
}

std::vector<std::int32_t> ContactGraph::way_around(std::int32_t first) const {
  std::vector<std::int32_t> way{first};
  std::int32_t next = neighbours(first).front();
  while (next != first) {
    const auto& ways = neighbours(next);
    const std::int32_t onward = ways.front() == way.back() ? ways.back() : ways.front();
    way.push_back(next);
    next = onward;
  }
  return way;
}

std::vector<std::int32_t> ContactGraph::longest_way(std::int32_t sphere) const {
  const std::vector<std::int32_t> spheres = component(sphere);
  if (is_ring(spheres)) return way_around(spheres.front());
  std::vector<std::int32_t> longest;
  for (const std::int32_t root : spheres) {
    const auto reached = breadth_first(root);
    const std::map<std::int32_t, std::int32_t> from(reached.begin(), reached.end());
    std::vector<std::int32_t> way{reached.back().first};  // none is farther
    while (way.back() != root) way.push_back(from.at(way.back()));
    if (way.size() > longest.size()) longest.assign(way.rbegin(), way.rend());
  }
  return longest;
}

}  // namespace zenosphere
