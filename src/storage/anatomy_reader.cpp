#include <cmath>
#include <string>

#include "storage/anatomy_group.hpp"
#include "storage/hdf5_series.hpp"

namespace zenosphere {
namespace {

using hdf5::Handle;

void require(bool condition, const char* text) {
  if (!condition) throw hdf5::Error(text);
}

/// A column of `size` rows of `row_size` numbers.
template <class T>
std::vector<T> column(const Handle& group, const std::string& name, std::size_t size,
                      std::size_t row_size = 1) {
  auto values = hdf5::values<T>(group, name);
  require(values.size() == size * row_size, "columns of the anatomy differ in length");
  return values;
}

std::size_t cluster_of(std::int32_t number, std::size_t clusters) {
  require(number >= 0 && static_cast<std::size_t>(number) < clusters, "no such cluster");
  return static_cast<std::size_t>(number);
}

std::int32_t required_sphere(std::int32_t sphere, std::int64_t spheres) {
  require(sphere >= 0 && sphere < spheres, "the anatomy names a sphere that is not there");
  return sphere;
}

void read_spheres(const Handle& group, int dimension, std::int64_t spheres,
                  std::vector<Cluster>& clusters) {
  const auto sphere = hdf5::values<std::int32_t>(group, "sphere");
  const auto cluster = column<std::int32_t>(group, "cluster", sphere.size());
  const auto size = static_cast<std::size_t>(dimension);
  const auto position = column<double>(group, "position", sphere.size(), size);
  for (std::size_t n = 0; n < sphere.size(); ++n) {
    Cluster& target = clusters[cluster_of(cluster[n], clusters.size())];
    target.spheres.push_back(required_sphere(sphere[n], spheres));
    for (std::size_t d = 0; d < size; ++d) target.positions.push_back(position[n * size + d]);
  }
}

void read_contacts(const Handle& group, std::int64_t spheres, std::vector<Cluster>& clusters) {
  const auto i = hdf5::values<std::int32_t>(group, "i");
  const auto j = column<std::int32_t>(group, "j", i.size());
  const auto cluster = column<std::int32_t>(group, "cluster", i.size());
  const auto collisions = column<std::int64_t>(group, "collisions", i.size());
  for (std::size_t n = 0; n < i.size(); ++n) {
    clusters[cluster_of(cluster[n], clusters.size())].contacts.push_back(
        {required_sphere(i[n], spheres), required_sphere(j[n], spheres + 2), collisions[n]});
  }
}

std::vector<Cluster> read_clusters(const Handle& group, int dimension, std::int64_t spheres) {
  const auto straightness = hdf5::values<double>(group, "straightness");
  std::vector<Cluster> clusters(straightness.size());
  require(!clusters.empty(), "the anatomy has no cluster");
  for (std::size_t n = 0; n < clusters.size(); ++n) clusters[n].straightness = straightness[n];
  read_spheres(hdf5::opened(group, "spheres"), dimension, spheres, clusters);
  read_contacts(hdf5::opened(group, "contacts"), spheres, clusters);
  clusters.front().chain = hdf5::values<std::int32_t>(group, "chain");
  for (const auto sphere : clusters.front().chain) required_sphere(sphere, spheres);
  clusters.front().bends = hdf5::values<double>(group, "bends");
  return clusters;
}

ClusterCollisions read_collisions(const Handle& group) {
  ClusterCollisions rows;
  ClusterCollisions::fields(rows, [&]<class T>(const char* name, std::vector<T>& values) {
    values = hdf5::values<T>(group, name);
    require(values.size() == rows.k.size(), "columns of the anatomy differ in length");
  });
  return rows;
}

std::optional<double> known(const Handle& group, const std::string& name) {
  const double value = hdf5::real_attribute(group, name);
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::optional<DecayRate> read_rate(const Handle& group, const std::string& name) {
  const auto ratio = known(group, name + "_ratio");
  if (!ratio) return std::nullopt;
  return DecayRate{*ratio, hdf5::real_attribute(group, name + "_ratio_spread")};
}

Decay read_decay(const Handle& group) {
  Decay decay;
  decay.cycle = hdf5::real_attribute(group, "cycle");
  decay.resolution = hdf5::real_attribute(group, "resolution");
  decay.gap = read_rate(group, "gap");
  decay.speed = read_rate(group, "speed");
  decay.flight = read_rate(group, "flight");
  if (const auto gap = known(group, "exact_gap_ratio")) {
    decay.exact = ChainFactors{*gap, hdf5::real_attribute(group, "exact_speed_ratio"),
                               hdf5::real_attribute(group, "exact_flight_ratio")};
  }
  decay.collapse_time = known(group, "collapse_time");
  decay.collapse_time_after = known(group, "collapse_time_after");
  decay.collapse_time_error = known(group, "collapse_time_error").value_or(0);
  return decay;
}

std::optional<Dissection> read_dissection(const Handle& parent, const std::string& name,
                                          int dimension, std::int64_t spheres) {
  if (!hdf5::contains(parent, name)) return std::nullopt;
  const Handle group = hdf5::opened(parent, name);
  Dissection dissection;
  dissection.collision = hdf5::number_attribute(group, "collision");
  dissection.time = hdf5::real_attribute(group, "time");
  const auto pairs = hdf5::values<std::int32_t>(group, "pairs");
  require(pairs.size() % 2 == 0, "a pair of the anatomy has one sphere");
  for (std::size_t n = 0; n < pairs.size(); n += 2) {
    dissection.pairs.emplace_back(required_sphere(pairs[n], spheres),
                                  required_sphere(pairs[n + 1], spheres + 2));
  }
  dissection.clusters = read_clusters(group, dimension, spheres);
  dissection.collisions = read_collisions(hdf5::opened(group, "collisions"));
  dissection.decay = read_decay(group);
  return dissection;
}

}  // namespace

Anatomy read_anatomy(const Handle& parent, int dimension, std::int64_t spheres) {
  if (!hdf5::contains(parent, "anatomy")) return {};
  const Handle group = hdf5::opened(parent, "anatomy");
  return {read_dissection(group, "hit", dimension, spheres),
          read_dissection(group, "arrest", dimension, spheres)};
}

}  // namespace zenosphere
