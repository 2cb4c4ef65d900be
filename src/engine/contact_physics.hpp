#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/archive.hpp"
#include "model/collision.hpp"
#include "model/contact_models.hpp"
#include "model/random.hpp"
#include "model/walls.hpp"

namespace zenosphere {

/// What contact models have done in a run.
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

/// Applies the contact models of a case to one collision after another, and remembers what they
/// need: the last collision of every sphere, and the stream of random angles.
template <int Dim, class Real>
class ContactPhysics {
 public:
  using Vector = Vec<Dim, Real>;

  /// \param models       at least one in use; no rotation in one dimension
  /// \param restitution  the constant one, in [0, 1]
  /// \param clock_unit   of the simulation's clock
  ContactPhysics(const ContactModels<Real>& models, const Real& restitution, std::int32_t spheres,
                 const Real& clock_unit);

  /// Gives a collision of two spheres, worked out with the constant restitution, the impulse and
  /// the change of velocity of the models.
  ///
  /// \param dv  velocity of j minus velocity of i at contact, diameters/time
  void amend(Collision<Dim, Real>& collision, const Vector& dv);

  /// Makes the walls elastic for a bounce off one of them that comes within the contact duration.
  void amend(Collision<Dim, Real>& collision, Walls<Real>& walls);

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
  void rotate(Collision<Dim, Real>& collision, const Vector& dv);
  Vector turned(const Vector& velocity);

  ContactModels<Real> models_;
  Real restitution_;
  Real clock_unit_;
  std::vector<Instant<Real>> last_contact_;  ///< of each sphere; empty without the TC model
  Random random_;
  ContactCounts counts_;
};

}  // namespace zenosphere
