#include "collapse/cluster_shape.hpp"

#include <algorithm>
#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

template <int Dim>
using Places = std::map<std::int32_t, Vec<Dim, double>>;

/// The bond from one sphere to the next, one diameter long.
template <int Dim>
Vec<Dim, double> bond(std::int32_t from, std::int32_t to, const Normals<Dim>& normals) {
  const Vec<Dim, double>& normal = normals.at(std::minmax(from, to));
  return from < to ? normal : normal * -1.0;
}

template <int Dim>
Places<Dim> places_of(const std::vector<std::int32_t>& spheres, const ContactGraph& graph,
                      const Normals<Dim>& normals) {
  Places<Dim> places;
  Vec<Dim, double> mean;
  for (const auto& [sphere, from] : graph.breadth_first(spheres.front())) {
    places[sphere] =
        sphere == from ? Vec<Dim, double>{} : places.at(from) + bond<Dim>(from, sphere, normals);
    mean += places[sphere] * (1.0 / static_cast<double>(spheres.size()));
  }
  for (auto& [sphere, place] : places) place -= mean;
  return places;
}

/// Angle between two unit vectors, radians; good to small angles.
template <int Dim>
double angle(const Vec<Dim, double>& a, const Vec<Dim, double>& b) {
  const auto difference = a - b;
  return 2 * std::asin(std::min(1.0, std::sqrt(dot(difference, difference)) / 2));
}

}  // namespace

template <int Dim>
Cluster cluster_of(const std::vector<std::int32_t>& spheres, const ContactGraph& graph,
                   const Normals<Dim>& normals) {
  Cluster cluster;
  cluster.spheres = spheres;
  cluster.chain = graph.longest_way(spheres.front());
  const Places<Dim> places = places_of<Dim>(spheres, graph, normals);
  for (const std::int32_t sphere : spheres) {
    const auto& components = places.at(sphere).components;
    cluster.positions.insert(cluster.positions.end(), components.begin(), components.end());
  }
  Vec<Dim, double> end_to_end;
  Vec<Dim, double> last;
  for (std::size_t n = 1; n < cluster.chain.size(); ++n) {
    const auto next = bond<Dim>(cluster.chain[n - 1], cluster.chain[n], normals);
    if (n > 1) cluster.bends.push_back(angle<Dim>(last, next));
    end_to_end += next;
    last = next;
  }
  if (cluster.chain.size() > 1) {
    cluster.straightness =
        std::sqrt(dot(end_to_end, end_to_end)) / static_cast<double>(cluster.chain.size() - 1);
  }
  return cluster;
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                       \
  template Cluster cluster_of<Dim>(const std::vector<std::int32_t>&, const ContactGraph&, \
                                   const Normals<Dim>&);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
