#pragma once

#include <cstdint>
#include <optional>

#include "io/case.hpp"
#include "io/records.hpp"
#include "model/contact_models.hpp"
#include "verify/motion.hpp"

namespace zenosphere::verify {

/// The law of the collisions of a case, applied to rows of its log.
class Law {
 public:
  using Number = long double;

  Law(const Case& values, std::int64_t spheres)
      : spheres_(spheres),
        restitution_(in_precision(values.system.restitution, values.collision.precision)),
        wall_restitution_(in_precision(values.walls.restitution, values.collision.precision)),
        rotates_(values.collision.rotation_angle > 0) {
    if (values.collision.restitution_law != RestitutionLaw::viscoelastic) return;
    viscoelastic_.emplace(
        in_precision(values.collision.viscoelastic_constant, values.collision.precision));
  }

  /// Whether velocities after a collision follow from the log: random angles are not in it.
  bool tells_velocities() const { return !rotates_; }

  /// Of a pair, or of a sphere and a wall, that approach with the logged normal speed > 0: 1 where
  /// the row says that the TC model made the collision elastic.
  Number restitution(const CollisionRow& row) const {
    if ((row.flags & collision_flag::made_elastic) != 0) return 1;
    if (row.j >= spheres_) return wall_restitution_;
    return viscoelastic_ ? (*viscoelastic_)(row.normal_speed) : restitution_;
  }

  /// The impulse of a collision of two spheres, mass diameter/time; nothing where its direction is
  /// not in the log.
  std::optional<Number> impulse(const CollisionRow& row) const {
    if (!(row.normal_speed > 0)) return 0.0L;
    if (rotates_) return std::nullopt;
    return (1 + restitution(row)) / 2 * row.normal_speed;
  }

  /// Energy that a collision takes, mass diameter^2/time^2; a rotation takes none.
  double loss(const CollisionRow& row) const {
    if (!(row.normal_speed > 0)) return 0;
    const auto e = static_cast<double>(restitution(row));
    // Two spheres: reduced mass 1/2. A wall does not give way.
    return (1 - e * e) * row.normal_speed * row.normal_speed / (row.j >= spheres_ ? 2 : 4);
  }

 private:
  std::int64_t spheres_;
  Number restitution_;
  Number wall_restitution_;
  bool rotates_;
  std::optional<ViscoelasticRestitution<Number>> viscoelastic_;
};

}  // namespace zenosphere::verify
