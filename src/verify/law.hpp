#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "case/case.hpp"
#include "case/case_grains.hpp"
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
      viscoelastic_constant_ = in_precision(collision.viscoelastic_constant, collision.precision);
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
    if (has_own_restitution(row)) return constants(row).restitution;
    if (fixed_loss_ > 0) return parting_speed(row) / row.normal_speed;
    if (two_valued_) {
      return row.normal_speed < two_valued_->threshold ? two_valued_->slow : two_valued_->fast;
    }
    if (viscoelastic_constant_ > 0) return soft_restitution(row);
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
    const Number square = Number(row.normal_speed) * row.normal_speed;
    return 2 / inverse_masses(row) * double_rounding * square / parting_speed(row);
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
        same.set(a, b, {of.restitution, of.tangential_restitution, of.friction, of.is_own});
      }
    }
    return same;
  }

  /// Whether two spheres are of kinds to which the case gives a restitution of their own.
  bool has_own_restitution(const CollisionRow& row) const {
    return table_ && constants(row).is_own;
  }

  /// Whether the case has a law for two spheres that is not overruled by their kinds, or by a
  /// contact that lasts.
  bool follows_law(const CollisionRow& row) const {
    const bool lasts = (row.flags & collision_flag::made_elastic) != 0;
    return row.j < spheres_ && !lasts && !has_own_restitution(row);
  }

  /// Whether the case has a fixed loss that applies to a collision of two spheres: the kinetic
  /// energy of their normal motion, m_n v^2/2, exceeds it.
  bool loses_fixed_energy(const CollisionRow& row) const {
    return fixed_loss_ > 0 && follows_law(row) && excess(row) > 0;
  }

  /// Energy left after a fixed loss, as a squared speed, (diameters/time)^2.
  Number excess(const CollisionRow& row) const {
    const Number speed = row.normal_speed;
    return speed * speed - squared_threshold(row);
  }

  /// Square of the speed at which a fixed loss is all of the kinetic energy, (diameters/time)^2.
  Number squared_threshold(const CollisionRow& row) const {
    return 2 * fixed_loss_ * inverse_masses(row);
  }

  /// That of two viscoelastic spheres, whose equation of motion is
  /// m_n x'' = -sqrt(R) (x^(3/2) + A' sqrt(x) x') in the units of their material.
  Number soft_restitution(const CollisionRow& row) const {
    constexpr Number c1 = 1.1534488580952884L;
    constexpr Number c2 = 2 * c1 * c1 / 5;
    constexpr Number c3 = 4 / (15 * c2);
    const Number radius = grains_.diameter(row.i) / 2;
    const Number other = grains_.diameter(row.j) / 2;
    const Number reduced_radius = 1 / (1 / radius + 1 / other);
    // In units of those of two unit spheres, 1/4 and 1/2.
    const Number stiffness = std::sqrt(4 * reduced_radius);
    const Number mass = 2 / inverse_masses(row);
    const Number softness = viscoelastic_constant_ * std::pow(stiffness / mass, 0.4L) *
                            std::pow(Number(row.normal_speed), 0.2L);
    const Number beginning = 1 + c3 * std::sqrt(softness);
    return beginning / (beginning * (1 + c1 * softness) + c2 * softness * softness);
  }

  Number parting_speed(const CollisionRow& row) const {
    return loses_fixed_energy(row) ? std::sqrt(excess(row)) : row.normal_speed;
  }

  /// Whether the rounding of the logged speed hides on which side of a threshold it was.
  bool is_borderline(const CollisionRow& row) const {
    if (!follows_law(row)) return false;
    if (two_valued_ && !two_valued_->is_exact) {
      const Number& threshold = two_valued_->threshold;
      return std::abs(row.normal_speed - threshold) <= double_rounding * threshold;
    }
    return fixed_loss_ > 0 && excess(row) != 0 &&
           std::abs(excess(row)) <= 4 * double_rounding * squared_threshold(row);
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
  std::array<bool, 2> is_thermal_;    ///< the lower and the upper wall
  Number fixed_loss_ = 0;             ///< 0: not the law of this case
  Number viscoelastic_constant_ = 0;  ///< of two unit spheres; 0: not the law of this case
  std::optional<TwoValues> two_valued_;
};

}  // namespace zenosphere::verify
