#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "case/case.hpp"
#include "case/case_grains.hpp"
#include "model/contact_models.hpp"
#include "model/contact_table.hpp"
#include "model/grains.hpp"
#include "storage/records.hpp"
#include "verify/motion.hpp"

namespace zenosphere::verify {

/// The law of the collisions of a case, applied to rows of its log.
class Law {
 public:
  using Number = long double;

  /// \param grains  of the file
  Law(const Case& values, std::int64_t spheres, const Grains<double>& grains = {})
      : spheres_(spheres),
        grains_(grains),
        table_(table_of(values)),
        is_rough_(table_ && table_->is_rough() && values.system.dimension > 1),
        inertia_(in_precision(reduced_moment_of_inertia(values), values.collision.precision)),
        restitution_(in_precision(values.system.restitution, values.collision.precision)),
        wall_restitution_(in_precision(values.walls.restitution, values.collision.precision)),
        rotates_(values.collision.rotation_angle > 0),
        is_thermal_{values.walls.lower_temperature.has_value(),
                    values.walls.upper_temperature.has_value()} {
    const auto& collision = values.collision;
    if (collision.restitution_law == RestitutionLaw::viscoelastic) {
      viscoelastic_.emplace(in_precision(collision.viscoelastic_constant, collision.precision));
    } else if (collision.restitution_law == RestitutionLaw::fixed_loss) {
      fixed_loss_ = in_precision(collision.energy_loss, collision.precision);
    } else if (collision.restitution_law == RestitutionLaw::two_valued) {
      two_valued_ = TwoValues{in_precision(collision.slow_restitution, collision.precision),
                              in_precision(collision.fast_restitution, collision.precision),
                              in_precision(collision.threshold_speed, collision.precision),
                              collision.precision == Precision::double_precision};
    }
  }

  /// Whether velocities after a collision follow from the log: random angles are not in it.
  bool tells_velocities() const { return !rotates_; }

  /// Whether the log tells the energy that each collision takes: of friction it does not.
  bool tells_losses() const { return !is_rough_; }

  /// Whether spheres turn.
  bool is_rough() const { return is_rough_; }

  /// 1 / mass of a sphere, of an immobile one 0; of those of a row, added up.
  Number inverse_mass(std::int32_t i) const {
    return grains_.is_immobile(i) ? 0 : 1 / Number(grains_.mass(i));
  }
  Number inverse_masses(const CollisionRow& row) const {
    return inverse_mass(row.i) + (row.j >= spheres_ ? 0 : inverse_mass(row.j));
  }

  /// q: a moment of inertia is q mass radius^2.
  Number inertia() const { return inertia_; }

  /// beta0 and mu of two spheres.
  ContactConstants<Number> constants(const CollisionRow& row) const {
    if (!table_) return {restitution_};
    return table_->of(grains_.kind(row.i), grains_.kind(row.j));
  }

  /// Of a pair, or of a sphere and a wall, that approach with the logged normal speed > 0: 1 where
  /// the row says that the TC model made the collision elastic.
  Number restitution(const CollisionRow& row) const {
    if ((row.flags & collision_flag::made_elastic) != 0) return 1;
    if (row.j >= spheres_) return wall_restitution_;
    if (fixed_loss_ > 0) return parting_speed(row) / row.normal_speed;
    if (two_valued_) {
      return row.normal_speed < two_valued_->threshold ? two_valued_->slow : two_valued_->fast;
    }
    if (viscoelastic_) return (*viscoelastic_)(row.normal_speed);
    return table_ ? constants(row).restitution : restitution_;
  }

  /// The impulse of a collision of two spheres, mass diameter/time; nothing where its direction is
  /// not in the log, or the logged speed does not tell whether it lost the fixed energy.
  std::optional<Number> impulse(const CollisionRow& row) const {
    if (!(row.normal_speed > 0)) return 0.0L;
    if (rotates_ || is_borderline(row)) return std::nullopt;
    return (1 + restitution(row)) / inverse_masses(row) * row.normal_speed;
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
    // A thermal wall exchanges heat, and an oscillating one keeps up what rests on it.
    const bool is_wall = row.j >= spheres_;
    if (is_wall && is_thermal_[static_cast<std::size_t>(row.j - spheres_)]) return 0;
    if ((row.flags & collision_flag::resting) != 0) return 0;
    if (loses_fixed_energy(row)) return fixed_loss_;
    const Number speed = row.normal_speed;
    const Number e = restitution(row);
    return (1 - e * e) * speed * speed / (2 * inverse_masses(row));
  }

 private:
  /// The constants of the pairs of kinds, in the precision of the run.
  static std::optional<ContactTable<Number>> table_of(const Case& values) {
    if (values.collision.precision != Precision::double_precision) {
      return contact_table_of<Number>(values);
    }
    const auto table = contact_table_of<double>(values);
    if (!table) return std::nullopt;
    ContactTable<Number> same(table->kinds(), {});
    for (std::int32_t a = 0; a < table->kinds(); ++a) {
      for (std::int32_t b = 0; b <= a; ++b) {
        const auto& of = table->of(a, b);
        same.set(a, b, {of.restitution, of.tangential_restitution, of.friction});
      }
    }
    return same;
  }

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

  /// Whether the rounding of the logged speed hides on which side of a threshold it was.
  bool is_borderline(const CollisionRow& row) const {
    if (two_valued_ && !two_valued_->is_exact && row.j < spheres_) {
      const Number& threshold = two_valued_->threshold;
      return std::abs(row.normal_speed - threshold) <= double_rounding * threshold;
    }
    return fixed_loss_ > 0 && row.j < spheres_ && excess(row) != 0 &&
           std::abs(excess(row)) <= 16 * double_rounding * fixed_loss_;
  }

  /// The restitution below a speed and from there on.
  struct TwoValues {
    Number slow;
    Number fast;
    Number threshold;
    bool is_exact;  ///< logged speeds are those of the engine
  };

  std::int64_t spheres_;
  Grains<double> grains_;
  std::optional<ContactTable<Number>> table_;  ///< none: restitution_ for all, smooth
  bool is_rough_;
  Number inertia_;
  Number restitution_;
  Number wall_restitution_;
  bool rotates_;
  std::array<bool, 2> is_thermal_;  ///< the lower and the upper wall
  Number fixed_loss_ = 0;           ///< 0: not the law of this case
  std::optional<ViscoelasticRestitution<Number>> viscoelastic_;
  std::optional<TwoValues> two_valued_;
};

}  // namespace zenosphere::verify
