#include <fmt/format.h>

#include <algorithm>

#include "case/case_grains.hpp"
#include "case/case_rules.hpp"

namespace zenosphere::case_format {
namespace {

using Objection = std::optional<std::string>;

Objection friction_alone(const Case& values) {
  const auto& collision = values.collision;
  if (!collision.friction || collision.tangential_restitution) return std::nullopt;
  return "(needs collision.tangential_restitution too); add it, or remove this";
}

Objection tangential_restitution_alone(const Case& values) {
  const auto& collision = values.collision;
  if (!collision.tangential_restitution || collision.friction) return std::nullopt;
  return "(needs collision.friction too, maybe \"unbounded\"); add it, or remove this";
}

/// A sphere cannot have more of its mass at the surface than a shell, q = 2/3 (as people round it).
Objection inertia_of_no_sphere(const Case& values) {
  const auto& inertia = values.collision.reduced_moment_of_inertia;
  if (!inertia) return std::nullopt;
  constexpr double of_a_shell = 0.667;
  if (values.system.dimension == 3 && *inertia > of_a_shell) {
    return "(must be in (0, 2/3] in three dimensions: 0.4 is a solid sphere, 2/3 a shell)";
  }
  const auto rubs = [](const SpeciesContact& contact) { return contact.friction.has_value(); };
  const auto& contacts = values.contacts;
  if (values.collision.friction || std::any_of(contacts.begin(), contacts.end(), rubs)) {
    return std::nullopt;
  }
  return "(without friction nothing turns); remove it, or add collision.friction";
}

Objection rotation_of_rough_spheres(const Case& values) {
  if (values.collision.rotation_angle == 0 || !is_rough(values)) return std::nullopt;
  return "(not together with friction); remove one of the two";
}

/// The keys of [collision] are not there on a line.
Objection rough_contact_on_a_line(const Case& values) {
  const auto is_rough = [](const SpeciesContact& contact) { return contact.friction.has_value(); };
  if (values.system.dimension > 1 ||
      std::none_of(values.contacts.begin(), values.contacts.end(), is_rough)) {
    return std::nullopt;
  }
  return "(nothing turns on a line, and a [[contact]] has a friction); remove it or use 2 or 3 "
         "dimensions";
}

Objection immobile_under_shear(const Case& values) {
  if (values.drive.kind != DriveKind::shear || !has_immobile_species(values)) return std::nullopt;
  return "(an immobile species would cut through the sliding images of the box); shear by immobile "
         "spheres that move or by [walls]";
}

}  // namespace

std::optional<std::string> spread_objection(const Case& values) {
  const auto& polydispersity = values.polydispersity;
  if (!polydispersity.distribution) return std::nullopt;
  const double largest = largest_spread(*polydispersity.distribution);
  if (polydispersity.spread <= largest) return std::nullopt;
  return fmt::format("(must be in [0, {}]; some diameters would not be positive)", largest);
}

std::span<const Rule> grain_rules() {
  static const std::vector<Rule> rules{
      {{"polydispersity.spread", "polydispersity.distribution"}, spread_objection},
      {{"collision.friction", "collision.tangential_restitution"}, friction_alone},
      {{"collision.tangential_restitution", "collision.friction"}, tangential_restitution_alone},
      {{"collision.reduced_moment_of_inertia", "collision.friction", "system.dimension"},
       inertia_of_no_sphere},
      {{"collision.rotation_angle", "collision.friction"}, rotation_of_rough_spheres},
      {{"system.dimension"}, rough_contact_on_a_line},
      {{"drive.kind"}, immobile_under_shear}};
  return rules;
}

}  // namespace zenosphere::case_format
