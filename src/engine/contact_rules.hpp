#pragma once

#include <optional>

#include "model/contact_models.hpp"
#include "model/contact_table.hpp"
#include "model/overlap_rule.hpp"

namespace zenosphere {

/// The rules of contact: how two spheres collide, and what is done where rounding interferes.
template <class Real>
struct ContactRules {
  Real restitution = 1;
  OverlapRule overlap = OverlapRule::rewind;
  Real guard = Real(1e-15);  ///< diameters^2/time; read by OverlapRule::guarded only
  ContactModels<Real> models{};

  /// In the place of `restitution`: the constants for each pair of kinds, and friction.
  std::optional<ContactTable<Real>> table{};
  /// q of rough spheres, whose moment of inertia is q mass diameter^2 / 4; nothing: they are solid.
  std::optional<Real> inertia{};

  ContactConstants<Real> constants(std::int32_t kind, std::int32_t other_kind) const {
    return table ? table->of(kind, other_kind) : ContactConstants<Real>{restitution};
  }
  bool are_rough() const { return table && table->is_rough(); }
};

}  // namespace zenosphere
