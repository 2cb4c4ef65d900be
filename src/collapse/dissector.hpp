#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "collapse/cluster_shape.hpp"
#include "collapse/dissection.hpp"
#include "collapse/recent_collisions.hpp"

namespace zenosphere {

/// Watches collisions, and takes apart what collapses: at the first hit of the separation criterion
/// and at an arrest.
///
/// Two spheres are in *repeated contact* if they met at least three times among the last
/// N/4 collisions (at least 64, at most 1024: half a collision per sphere) or since the clock
/// stopped. The cluster of a pair is what repeated contacts connect with it, the pair itself
/// included; at a hit also the collision after which it was met, if it has a sphere in common with
/// the pair. What is kept are at most 2048 collisions.
template <int Dim, class Real>
class Dissector {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;

  /// \param threshold    gap in diameters
  /// \param clock_unit   of the simulation's clock
  /// \param restitution  to compare a chain with; none where it is not constant
  Dissector(const Real& threshold, std::int32_t spheres, const Real& clock_unit,
            std::optional<double> restitution)
      : threshold_(threshold),
        spheres_(spheres),
        clock_unit_(clock_unit),
        restitution_(restitution),
        recent_(threshold_, clock_unit) {}

  void observe(const Collision<Dim, Real>& collision);

  /// The pair that would collide next after the collision observed last, and its gap.
  ///
  /// To be called where a run ends and that pair is known without its collision.
  void observe_next(const Pair& pair, const Real& gap);

  /// The arrest criterion was met at the collision observed last; only the first call counts.
  ///
  /// \param pairs  that repeat
  void observe_arrest(const std::vector<Pair>& pairs);

  const Anatomy& anatomy() const { return anatomy_; }

  /// \throws ArchiveError for collisions of spheres that there are not, or what none can lead to
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.recent_, self.anatomy_);
    if constexpr (Archive::reads) self.require_possible();
  }

 private:
  using Trace = CollisionTrace<Dim, Real>;

  /// Repeated contacts, with how often, and the spheres connected by them.
  struct Contacts {
    std::map<Pair, std::int64_t> counts;
    Normals<Dim> normals;
    ContactGraph graph;
  };

  Contacts contacts_of(const std::vector<Trace>& traces) const;
  void add(const Pair& pair, Contacts& contacts) const;
  void add_last_collision(const std::vector<Trace>& traces, const Pair& hit,
                          Contacts& contacts) const;
  Dissection dissection(const std::vector<Trace>& traces, const std::vector<Pair>& pairs,
                        const Contacts& contacts) const;
  void add_cluster(std::int32_t sphere, const Contacts& contacts,
                   std::vector<Cluster>& clusters) const;
  Cluster cluster(std::int32_t sphere, const Contacts& contacts) const;
  void follow(const std::vector<Trace>& traces, Dissection& dissection) const;
  void require_possible() const;

  Real threshold_;
  std::int32_t spheres_;
  Real clock_unit_;
  std::optional<double> restitution_;
  RecentCollisions<Dim, Real> recent_;
  Anatomy anatomy_;
};

}  // namespace zenosphere
