#include "storage/anatomy_group.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "storage/hdf5_series.hpp"

namespace zenosphere {
namespace {

using hdf5::Handle;

/// A dataset of a row of `row_shape` for each value, or each few values.
template <class T>
void write_values(const Handle& group, const std::string& name, const std::vector<T>& values,
                  const std::vector<std::int64_t>& row_shape = {}) {
  const std::int64_t rows = std::max<std::int64_t>(1, static_cast<std::int64_t>(values.size()));
  hdf5::Series(group, name, hdf5::type_of<T>, row_shape, rows).append(values);
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void write_rate(const Handle& group, const std::string& name,
                const std::optional<DecayRate>& rate) {
  hdf5::write_attribute(group, name + "_ratio", rate ? rate->ratio : none);
  hdf5::write_attribute(group, name + "_ratio_spread", rate ? rate->spread : none);
}

void write_clusters(const Handle& group, const std::vector<Cluster>& clusters, int dimension) {
  std::vector<std::int32_t> sphere, sphere_cluster, i, j, contact_cluster;
  std::vector<std::int64_t> collisions;
  std::vector<double> position, straightness;
  for (std::size_t n = 0; n < clusters.size(); ++n) {
    const Cluster& cluster = clusters[n];
    const auto number = static_cast<std::int32_t>(n);
    sphere.insert(sphere.end(), cluster.spheres.begin(), cluster.spheres.end());
    sphere_cluster.insert(sphere_cluster.end(), cluster.spheres.size(), number);
    position.insert(position.end(), cluster.positions.begin(), cluster.positions.end());
    straightness.push_back(cluster.straightness);
    for (const auto& contact : cluster.contacts) {
      i.push_back(contact.i);
      j.push_back(contact.j);
      collisions.push_back(contact.collisions);
      contact_cluster.push_back(number);
    }
  }
  write_values(group, "straightness", straightness);
  const Handle spheres = hdf5::created_group(group, "spheres");
  write_values(spheres, "sphere", sphere);
  write_values(spheres, "cluster", sphere_cluster);
  write_values(spheres, "position", position, {dimension});
  const Handle contacts = hdf5::created_group(group, "contacts");
  write_values(contacts, "i", i);
  write_values(contacts, "j", j);
  write_values(contacts, "cluster", contact_cluster);
  write_values(contacts, "collisions", collisions);
}

void write_collisions(const Handle& group, const ClusterCollisions& collisions) {
  const Handle rows = hdf5::created_group(group, "collisions");
  ClusterCollisions::fields(
      collisions, [&](const char* name, const auto& column) { write_values(rows, name, column); });
}

void write_decay(const Handle& group, const Decay& decay) {
  hdf5::write_attribute(group, "cycle", decay.cycle);
  hdf5::write_attribute(group, "resolution", decay.resolution);
  write_rate(group, "gap", decay.gap);
  write_rate(group, "speed", decay.speed);
  write_rate(group, "flight", decay.flight);
  const ChainFactors exact = decay.exact.value_or(ChainFactors{none, none, none});
  hdf5::write_attribute(group, "exact_gap_ratio", exact.gap);
  hdf5::write_attribute(group, "exact_speed_ratio", exact.speed);
  hdf5::write_attribute(group, "exact_flight_ratio", exact.flight);
  hdf5::write_attribute(group, "collapse_time", decay.collapse_time.value_or(none));
  hdf5::write_attribute(group, "collapse_time_after", decay.collapse_time_after.value_or(none));
  hdf5::write_attribute(group, "collapse_time_error",
                        decay.collapse_time ? decay.collapse_time_error : none);
}

void write_dissection(const Handle& parent, const std::string& name,
                      const std::optional<Dissection>& dissection, int dimension) {
  if (!dissection) return;
  const Handle group = hdf5::created_group(parent, name);
  hdf5::write_attribute(group, "collision", dissection->collision);
  hdf5::write_attribute(group, "time", dissection->time);
  std::vector<std::int32_t> pairs;
  for (const auto& [i, j] : dissection->pairs) pairs.insert(pairs.end(), {i, j});
  write_values(group, "pairs", pairs, {2});
  write_clusters(group, dissection->clusters, dimension);
  write_values(group, "chain", dissection->clusters.front().chain);
  write_values(group, "bends", dissection->clusters.front().bends);
  write_collisions(group, dissection->collisions);
  write_decay(group, dissection->decay);
}

}  // namespace

void write_anatomy(const Handle& parent, const Anatomy& anatomy, int dimension) {
  if (!anatomy.hit && !anatomy.arrest) return;
  const Handle group = hdf5::created_group(parent, "anatomy");
  write_dissection(group, "hit", anatomy.hit, dimension);
  write_dissection(group, "arrest", anatomy.arrest, dimension);
}

}  // namespace zenosphere
