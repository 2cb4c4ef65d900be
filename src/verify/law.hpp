#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "case/case.hpp"
#include "model/contact_models.hpp"
#include "storage/records.hpp"
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
    const auto& collision = values.collision;
    if (collision.restitution_law == RestitutionLaw::viscoelastic) {
      viscoelastic_.emplace(in_precision(collision.viscoelastic_constant, collision.precision));
    } else if (collision.restitution_law == RestitutionLaw::fixed_loss) {
      fixed_loss_ = in_precision(collision.energy_loss, collision.precision);
    }
  }

  /// Whether velocities after a collision follow from the log: random angles are not in it.
  bool tells_velocities() const { return !rotates_; }

  /// Of a pair, or of a sphere and a wall, that approach with the logged normal speed > 0: 1 where
  /// the row says that the TC model made the collision elastic.
  Number restitution(const CollisionRow& row) const {
    if ((row.flags & collision_flag::made_elastic) != 0) return 1;
    if (row.j >= spheres_) return wall_restitution_;
    if (fixed_loss_ > 0) return parting_speed(row) / row.normal_speed;
    return viscoelastic_ ? (*viscoelastic_)(row.normal_speed) : restitution_;
  }

  /// The impulse of a collision of two spheres, mass diameter/time; nothing where its direction is
  /// not in the log, or the logged speed does not tell whether it lost the fixed energy.
  std::optional<Number> impulse(const CollisionRow& row) const {
    if (!(row.normal_speed > 0)) return 0.0L;
    if (rotates_ || is_borderline(row)) return std::nullopt;
    return (1 + restitution(row)) / 2 * row.normal_speed;
  }

  /// What the rounding of the logged speed makes of the impulse beyond a few of its own units,
  /// mass diameter/time: the speed after a collision just above a fixed loss is a small difference.
  Number impulse_error(const CollisionRow& row) const {
    if (!loses_fixed_energy(row)) return 0;
    return double_rounding * row.normal_speed * row.normal_speed / parting_speed(row);
  }

  /// Energy that a collision takes, mass diameter^2/time^2; a rotation takes none.
  Number loss(const CollisionRow& row) const {
    if (!(row.normal_speed > 0)) return 0;
    if (loses_fixed_energy(row)) return fixed_loss_;
    const Number speed = row.normal_speed;
    const Number e = restitution(row);
    // Two spheres: reduced mass 1/2. A wall does not give way.
    return (1 - e * e) * speed * speed / (row.j >= spheres_ ? 2 : 4);
  }

 private:
  /// Whether the case has a fixed loss that applies to a collision of two spheres: the kinetic
  /// energy of their normal motion, v^2/4, exceeds it.
  bool loses_fixed_energy(const CollisionRow& row) const {
    const bool is_of_spheres = row.j < spheres_;
    const bool lasts = (row.flags & collision_flag::made_elastic) != 0;
    return fixed_loss_ > 0 && is_of_spheres && !lasts && excess(row) > 0;
  }

  /// Energy left after a fixed loss, as a squared speed, (diameters/time)^2.
  Number excess(const CollisionRow& row) const {
    const Number speed = row.normal_speed;
    return speed * speed - 4 * fixed_loss_;
  }

  Number parting_speed(const CollisionRow& row) const {
    return loses_fixed_energy(row) ? std::sqrt(excess(row)) : row.normal_speed;
  }

  /// Whether the rounding of the logged speed hides on which side of the fixed loss it was.
  bool is_borderline(const CollisionRow& row) const {
    return fixed_loss_ > 0 && row.j < spheres_ && excess(row) != 0 &&
           std::abs(excess(row)) <= 16 * double_rounding * fixed_loss_;
  }

  std::int64_t spheres_;
  Number restitution_;
  Number wall_restitution_;
  bool rotates_;
  Number fixed_loss_ = 0;  ///< 0: not the law of this case
  std::optional<ViscoelasticRestitution<Number>> viscoelastic_;
};

}  // namespace zenosphere::verify
