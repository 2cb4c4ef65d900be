#include "collapse/dissection.hpp"

#include <algorithm>

namespace zenosphere {
namespace {

bool are_spheres(const std::vector<std::int32_t>& ids, std::int32_t spheres) {
  return std::all_of(ids.begin(), ids.end(),
                     [&](std::int32_t id) { return id >= 0 && id < spheres; });
}

bool is_possible(const Cluster& cluster, int dimension, std::int32_t spheres) {
  const std::size_t components = cluster.spheres.size() * static_cast<std::size_t>(dimension);
  const auto joins_two = [&](const RepeatedContact& contact) {
    return is_pair({contact.i, contact.j}, spheres);
  };
  return cluster.positions.size() == components && are_spheres(cluster.spheres, spheres) &&
         are_spheres(cluster.chain, spheres) &&
         std::all_of(cluster.contacts.begin(), cluster.contacts.end(), joins_two);
}

bool has_whole_rows(const ClusterCollisions& rows) {
  bool are_equal = true;
  ClusterCollisions::fields(rows, [&](const char*, const auto& column) {
    are_equal = are_equal && column.size() == rows.k.size();
  });
  return are_equal;
}

}  // namespace

bool is_pair(const std::pair<std::int32_t, std::int32_t>& pair, std::int32_t spheres) {
  const auto [i, j] = pair;
  return i >= 0 && i < j && i < spheres && j - 2 < spheres;
}

bool is_possible(const Dissection& dissection, int dimension, std::int32_t spheres) {
  const auto joins_two = [&](const auto& pair) { return is_pair(pair, spheres); };
  const auto holds_together = [&](const Cluster& cluster) {
    return is_possible(cluster, dimension, spheres);
  };
  return !dissection.clusters.empty() &&
         std::all_of(dissection.pairs.begin(), dissection.pairs.end(), joins_two) &&
         std::all_of(dissection.clusters.begin(), dissection.clusters.end(), holds_together) &&
         has_whole_rows(dissection.collisions);
}

}  // namespace zenosphere
