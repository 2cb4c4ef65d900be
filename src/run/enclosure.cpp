#include "run/enclosure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "case/case_grains.hpp"
#include "case/case_words.hpp"
#include "model/contact.hpp"
#include "model/instantiate.hpp"
#include "proof/enclose_cluster.hpp"
#include "run/approach_sentence.hpp"
#include "run/setup.hpp"

namespace zenosphere {
namespace {

constexpr int first_decade = 10;
/// With more, a collision takes a millisecond and more.
constexpr std::size_t largest_cluster = 12;

/// A cluster taken out of its box.
template <int Dim, class Real>
struct Alone {
  std::vector<std::int32_t> spheres;  ///< in the order in which they were placed
  std::vector<Vec<Dim, Real>> positions;
  std::vector<Vec<Dim, Real>> velocities;
};

/// Places each sphere beside the nearest one that is placed already, the first at rest at the
/// origin.
template <int Dim, class Real>
Alone<Dim, Real> alone(const ClusterGaps<Dim, Real>& state, std::vector<std::int32_t> left) {
  Alone<Dim, Real> cluster{{left.front()}, {{}}, {{}}};
  left.erase(left.begin());
  while (!left.empty()) {
    std::size_t beside = 0;
    std::size_t next = 0;
    double least = -1;
    for (std::size_t a = 0; a < cluster.spheres.size(); ++a) {
      for (std::size_t b = 0; b < left.size(); ++b) {
        const auto dr = state.relative(cluster.spheres[a], left[b]).dr;
        const auto square = static_cast<double>(dot(dr, dr));
        if (least >= 0 && square >= least) continue;
        least = square;
        beside = a;
        next = b;
      }
    }
    const auto way = state.relative(cluster.spheres[beside], left[next]);
    cluster.positions.push_back(cluster.positions[beside] + way.dr);
    cluster.velocities.push_back(cluster.velocities[beside] + way.dv);
    cluster.spheres.push_back(left[next]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(next));
  }
  return cluster;
}

/// Two of the cluster are nearer to each other in the box than in the plane or space alone.
template <int Dim, class Real>
bool closes_around(const ClusterGaps<Dim, Real>& state, const Alone<Dim, Real>& cluster) {
  constexpr double rounding = 1e-6;
  for (std::size_t a = 0; a < cluster.spheres.size(); ++a) {
    for (std::size_t b = a + 1; b < cluster.spheres.size(); ++b) {
      const auto near = state.relative(cluster.spheres[a], cluster.spheres[b]).dr;
      const auto far = cluster.positions[b] - cluster.positions[a];
      if (dot(far, far) > dot(near, near) + rounding) return true;
    }
  }
  return false;
}

/// The time that any other sphere needs at least to reach the cluster.
///
/// Seen from one of its spheres no sphere ever becomes faster than the lightest with the energy of
/// all, and by a face of the box than the shear between its faces.
template <int Dim, class Real>
double least_time_to_reach(const ClusterGaps<Dim, Real>& state,
                           const std::vector<std::int32_t>& cluster) {
  const Grains<Real>& grains = state.grains();
  double energy = 0;
  auto lightest = static_cast<double>(grains.mass(0));
  const auto& sides = state.box().sides().components;
  const auto shortest = static_cast<double>(*std::min_element(sides.begin(), sides.end()));
  // Images beyond the nearest are not looked at.
  double way = shortest / 2 - static_cast<double>(grains.largest_diameter());
  for (std::int32_t other = 0; other < state.spheres(); ++other) {
    const auto dv = state.relative(cluster.front(), other).dv;
    const auto mass = static_cast<double>(grains.mass(other));
    energy += mass * static_cast<double>(dot(dv, dv));
    lightest = std::min(lightest, mass);
    if (std::find(cluster.begin(), cluster.end(), other) != cluster.end()) continue;
    for (const std::int32_t own : cluster) {
      const Real sigma = grains.radius(own) + grains.radius(other);
      const Real distance = gap(state.relative(own, other).dr, sigma) * sigma;
      way = std::min(way, static_cast<double>(distance));
    }
  }
  double speed = std::sqrt(energy / lightest);
  if constexpr (Dim > 1) {
    speed += static_cast<double>(Real(state.box().shear_rate() * state.box().sides()[1]));
  }
  return way / (2 * speed);
}

template <int Dim, class Real>
std::vector<ExactSphere> exact_spheres(const Alone<Dim, Real>& cluster,
                                       const Grains<Real>& grains) {
  std::vector<ExactSphere> spheres(cluster.spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    for (int axis = 0; axis < Dim; ++axis) {
      spheres[k].position.push_back(exactly(cluster.positions[k][axis]));
      spheres[k].velocity.push_back(exactly(cluster.velocities[k][axis]));
    }
    spheres[k].radius = exactly(grains.radius(cluster.spheres[k]));
    spheres[k].mass = exactly(grains.mass(cluster.spheres[k]));
  }
  return spheres;
}

template <int Dim, class Real>
PairRestitutions restitutions_of(const Alone<Dim, Real>& cluster, const Grains<Real>& grains,
                                 const ContactRules<Real>& law) {
  const std::size_t size = cluster.spheres.size();
  PairRestitutions result(size, exactly(law.restitution));
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; b < size; ++b) {
      const std::int32_t kind = grains.kind(cluster.spheres[a]);
      const std::int32_t other = grains.kind(cluster.spheres[b]);
      result.rows[a][b] = exactly(law.constants(kind, other).restitution);
    }
  }
  return result;
}

}  // namespace

std::optional<std::int64_t> place_to_enclose(const Case& values, const JudgedApproach& approach) {
  const auto& collision = values.collision;
  const auto& gravity = values.gravity.acceleration;
  const bool is_free = !values.walls.axis && values.drive.kind != DriveKind::random &&
                       std::all_of(gravity.begin(), gravity.end(), [](double g) { return g == 0; });
  const bool is_simple = collision.restitution_law == RestitutionLaw::constant &&
                         collision.contact_duration == 0 && collision.rotation_angle == 0 &&
                         !is_rough(values) && !has_immobile_species(values);
  const bool is_spent = approach.finding == Finding::singular;
  const std::size_t size = approach.spheres.size();
  if (values.system.dimension < 2 || !is_free || !is_simple || !is_spent) return std::nullopt;
  if (size < 2 || size > largest_cluster) return std::nullopt;
  for (const Milestone& milestone : approach.milestones) {
    if (milestone.decade >= first_decade) return milestone.collision;
  }
  return std::nullopt;
}

template <int Dim, class Real>
std::optional<Certificate> enclosed(const Case& values, const ClusterGaps<Dim, Real>& state,
                                    const std::vector<std::int32_t>& cluster, int decades,
                                    std::chrono::steady_clock::time_point deadline,
                                    const std::atomic<bool>* interrupt) {
  const auto in_space = alone(state, cluster);
  if (closes_around(state, in_space)) return std::nullopt;
  const Grains<Real>& grains = state.grains();
  const auto restitutions = restitutions_of(in_space, grains, contact_rules_of<Real>(values));
  const ClusterLimits limits{.decades = decades, .deadline = deadline, .interrupt = interrupt};
  const Certificate found = enclose_cluster(exact_spheres(in_space, grains), restitutions, limits);
  if (found.collisions == 0) return std::nullopt;
  const double left = std::strtod(found.upper.c_str(), nullptr);  // 0 where it is below all doubles
  if (left > least_time_to_reach(state, cluster)) return std::nullopt;
  return found;
}

void tell_enclosure(const Certificate& certificate, std::int64_t collision,
                    JudgedApproach& approach) {
  const std::string from = fmt::format("from its state at collision {} in {}, taken as exact",
                                       collision, word(approach.precision));
  if (certificate.kind == Certificate::Kind::escapes) {
    const std::string sentence = fmt::format(
        "the gaps of {} fall together to 1e-{} and grow again: ball arithmetic makes "
        "certain that they part after {} contacts {}",
        count_and_names(approach.spheres), certificate.decades, certificate.collisions, from);
    refute(approach, sentence);
    return;
  }
  if (certificate.decades <= first_decade) return;
  approach.enclosed_to = certificate.decades;
  approach.sentence += fmt::format(
      ". It is enclosed to 1e-{}: ball arithmetic, where every number is an interval that holds "
      "the true one, makes the order of {} contacts certain, and that no other sphere comes near, "
      "{}",
      certificate.decades, certificate.collisions, from);
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                \
  template std::optional<Certificate> enclosed<Dim, Real>(                               \
      const Case&, const ClusterGaps<Dim, Real>&, const std::vector<std::int32_t>&, int, \
      std::chrono::steady_clock::time_point, const std::atomic<bool>*);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
