#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/contact_rules.hpp"
#include "model/archive.hpp"
#include "model/collision.hpp"
#include "model/grains.hpp"
#include "model/random.hpp"
#include "model/spin.hpp"
#include "model/walls.hpp"

namespace zenosphere {

/// What a contact law has done in a run.
struct ContactCounts {
  std::int64_t collisions = 0;    ///< of two spheres that approached
  double mean_restitution = 0;    ///< of these
  std::int64_t made_elastic = 0;  ///< of these, and of bounces off walls, by the TC model
  std::int64_t rotated = 0;       ///< of these, with the relative velocity turned

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.collisions, self.mean_restitution, self.made_elastic, self.rotated);
    require_counts(self.collisions, self.made_elastic, self.rotated);
  }
};

/// The spheres, as a contact sees them beside their motion.
template <int Dim, class Real>
struct Bodies {
  const Grains<Real>& grains;
  std::span<const Spin<Dim, Real>> spins{};  ///< of each, or none where they do not turn

  /// radius x spin: the speed of its surface.
  Spin<Dim, Real> surface_spin(std::int32_t i) const {
    return spins[static_cast<std::size_t>(i)] * grains.radius(i);
  }
};

/// What happens to two spheres in contact, where they are more than smooth unit spheres with a
/// constant restitution: the contact models of a case, sizes, masses, constants for each pair of
/// kinds, and friction. Remembers what the models need: the last collision of every sphere, and
/// the stream of random angles.
template <int Dim, class Real>
class ContactLaw {
 public:
  using Vector = Vec<Dim, Real>;

  /// Whether a case needs more than impact().
  static bool is_needed(const ContactRules<Real>& rules, const Grains<Real>& grains) {
    return rules.models.is_any() || rules.table || !grains.are_alike();
  }

  /// \param clock_unit  of the simulation's clock
  ContactLaw(const ContactRules<Real>& rules, std::int32_t spheres, const Real& clock_unit);

  /// Works out the impulse, the change of momentum and the flags of a collision, of which the time
  /// and the two spheres are set.
  ///
  /// \param motion  at contact
  void collide(Collision<Dim, Real>& collision, const RelativeMotion<Dim, Real>& motion,
               const Bodies<Dim, Real>& bodies);

  /// The same for a bounce off a wall.
  ///
  /// \param velocity  of the sphere, along the normal relative to the wall
  /// \param least     see wall_impact()
  void bounce(Collision<Dim, Real>& collision, Walls<Real> walls, int side, const Vector& velocity,
              const Bodies<Dim, Real>& bodies, const Real& least = Real(0));

  /// What a collision changes of the spin of a sphere, i or j.
  Spin<Dim, Real> change_of_spin(const Collision<Dim, Real>& collision, std::int32_t sphere,
                                 const Grains<Real>& grains) const {
    return zenosphere::change_of_spin(collision.impact.normal, collision.friction,
                                      grains.inverse_mass(sphere), grains.radius(sphere), inertia_);
  }

  const ContactCounts& counts() const { return counts_; }

  /// \throws ArchiveError for the state of other models or of another number of spheres
  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    const std::size_t remembered = self.last_contact_.size();
    archive(self.last_contact_, self.random_, self.counts_);
    require_archived(self.last_contact_.size() == remembered,
                     "contacts of another number of spheres");
  }

 private:
  bool is_lasting(const Collision<Dim, Real>& collision, std::int32_t sphere) const;
  Real restitution(const Collision<Dim, Real>& collision, const ContactConstants<Real>& constants,
                   const Grains<Real>& grains) const;
  void rub(Collision<Dim, Real>& collision, const Vector& dv, const Spin<Dim, Real>& turning,
           const Real& inverse_masses, const ContactConstants<Real>& constants) const;
  void rotate(Collision<Dim, Real>& collision, const Vector& dv, const Real& inverse_masses);
  Vector turned(const Vector& velocity);

  ContactRules<Real> rules_;
  Real inertia_;
  Real clock_unit_;
  std::vector<Instant<Real>> last_contact_;  ///< of each sphere; empty without the TC model
  Random random_;
  ContactCounts counts_;
};

}  // namespace zenosphere
