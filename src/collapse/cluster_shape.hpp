#pragma once

#include <map>
#include <utility>

#include "collapse/contact_graph.hpp"
#include "collapse/dissection.hpp"
#include "model/vec.hpp"

namespace zenosphere {

/// The line of centres of each pair, i < j, from i to j.
template <int Dim>
using Normals = std::map<std::pair<std::int32_t, std::int32_t>, Vec<Dim, double>>;

/// Where the spheres of a cluster are, and how straight it is.
///
/// Spheres in contact are one diameter apart along their line of centres; so the places follow from
/// contact to contact, without images of a box. Where contacts form a ring the way of the fewest
/// contacts from the first sphere counts.
///
/// \param spheres  a component of the graph, ascending
/// \param normals  of each of its contacts
template <int Dim>
Cluster cluster_of(const std::vector<std::int32_t>& spheres, const ContactGraph& graph,
                   const Normals<Dim>& normals);

}  // namespace zenosphere
