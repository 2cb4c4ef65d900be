#pragma once

#include <array>
#include <optional>

#include "case/tables/friction.hpp"
#include "model/case_key.hpp"
#include "model/overlap_rule.hpp"
#include "model/precision.hpp"
#include "model/word_table.hpp"

namespace zenosphere {

inline constexpr std::array overlap_words{
    Word{"rewind", OverlapRule::rewind}, Word{"immediate", OverlapRule::immediate},
    Word{"guarded", OverlapRule::guarded}, Word{"stop", OverlapRule::stop}};
inline const auto& words_of(OverlapRule) { return overlap_words; }

enum class RestitutionLaw { constant, viscoelastic, fixed_loss, two_valued };
inline constexpr std::array law_words{
    Word{"constant", RestitutionLaw::constant}, Word{"viscoelastic", RestitutionLaw::viscoelastic},
    Word{"fixed-loss", RestitutionLaw::fixed_loss}, Word{"two-valued", RestitutionLaw::two_valued}};
inline const auto& words_of(RestitutionLaw) { return law_words; }

namespace case_format {

// Beyond every run, and far below the time at which a sphere that never met has met.
inline constexpr double longest_contact = 1e100;
// Every collision faster than 1e-100 is wholly inelastic then.
inline constexpr double most_viscoelastic = 1e100;
// Beyond every collision, and four times it is a number.
inline constexpr double most_loss = 1e300;
// A right angle: a pair may still recede then, whatever its velocity.
inline constexpr double widest_rotation = 1.57;

inline constexpr When only_viscoelastic{
    "collision.restitution_law", "",
    [](const auto& c) { return c.collision.restitution_law == RestitutionLaw::viscoelastic; },
    "collision.restitution_law = \"viscoelastic\""};
inline constexpr When only_fixed_loss{
    "collision.restitution_law", "",
    [](const auto& c) { return c.collision.restitution_law == RestitutionLaw::fixed_loss; },
    "collision.restitution_law = \"fixed-loss\""};
inline constexpr When only_two_valued{
    "collision.restitution_law", "",
    [](const auto& c) { return c.collision.restitution_law == RestitutionLaw::two_valued; },
    "collision.restitution_law = \"two-valued\""};
inline constexpr When only_turning{"system.dimension", "",
                                   [](const auto& c) { return c.system.dimension > 1; },
                                   "two or three dimensions"};

/// The table [collision]: what two spheres do to each other, and in which arithmetic.
struct Collisions {
  OverlapRule overlap = OverlapRule::rewind;
  double guard = 1e-15;  ///< diameter^2/time; only the rule `guarded` reads it
  Precision precision = Precision::double_precision;
  RestitutionLaw restitution_law = RestitutionLaw::constant;
  double viscoelastic_constant = 0;  ///< A, (time/diameter)^(1/5)
  double energy_loss = 0;            ///< of an energetic collision, mass diameter^2/time^2
  double slow_restitution = 0;       ///< of RestitutionLaw::two_valued: below the threshold
  double fast_restitution = 0;       ///< from the threshold on
  double threshold_speed = 0;        ///< diameters/time
  double contact_duration = 0;       ///< of the TC model, time; 0: not used
  double rotation_angle = 0;         ///< largest, radians; 0: not used
  std::optional<double> tangential_restitution;       ///< beta0; none: smooth spheres
  std::optional<Friction> friction;                   ///< mu, together with it
  std::optional<double> reduced_moment_of_inertia{};  ///< q = 4 I/(m s^2); none: solid spheres

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"overlap", optional, any,
                  "what is done with spheres that overlap by rounding while they approach"},
          overlap);
    visit(CaseKey{"guard", optional, at_least(0),
                  "the rule guarded lets slower approach pass [diameter^2/time]"},
          guard);
    visit(CaseKey{"precision", optional, any, "of the arithmetic"}, precision);
    visit(CaseKey{"restitution_law", optional, any, "how the restitution depends on the speed"},
          restitution_law);
    keys_of_laws(visit);
    visit(CaseKey{"contact_duration", optional, from_to(0, longest_contact, "0 is off"),
                  "a sphere that collides again within it does so elastically; 0 is off [time]"},
          contact_duration);
    visit(CaseKey{"rotation_angle", optional, from_to(0, widest_rotation, "0 is off"),
                  "most that a collision turns the relative velocity, at random [radians]"},
          rotation_angle);
    keys_of_rough_spheres(visit);
  }

 private:
  template <class Visitor>
  void keys_of_laws(Visitor& visit) {
    visit(CaseKey{"viscoelastic_constant", required, above_to(0, most_viscoelastic),
                  "A in e = 1 - C1 A v^(1/5) + ... [(time/diameter)^(1/5)]"},
          viscoelastic_constant, only_viscoelastic);
    visit(CaseKey{"energy_loss", required, above_to(0, most_loss),
                  "of each collision with more kinetic energy along its normal "
                  "[mass diameter^2/time^2]"},
          energy_loss, only_fixed_loss);
    visit(CaseKey{"slow_restitution", required, from_to(0, 1, "1 is elastic"),
                  "normal speed after a collision / before, below the threshold"},
          slow_restitution, only_two_valued);
    visit(CaseKey{"fast_restitution", required, from_to(0, 1, "1 is elastic"),
                  "the same from the threshold on"},
          fast_restitution, only_two_valued);
    visit(CaseKey{"threshold_speed", required, above(0),
                  "closing speed along the normal at which the restitution changes "
                  "[diameters/time]"},
          threshold_speed, only_two_valued);
  }
  template <class Visitor>
  void keys_of_rough_spheres(Visitor& visit) {
    visit(CaseKey{"tangential_restitution", optional, from_to(-1, 1, "-1 is smooth"),
                  "- tangential speed of the surfaces after a sticking contact / before"},
          tangential_restitution, only_turning);
    visit(CaseKey{"friction", optional, from_to(0, most_friction, "or \"unbounded\""),
                  "tangential impulse of a sliding contact / normal impulse"},
          friction, only_turning);
    visit(CaseKey{"reduced_moment_of_inertia", optional, above_to(0, 1, "1 is a ring"),
                  "4 moment of inertia / (mass diameter^2) of rough spheres"},
          reduced_moment_of_inertia, only_turning);
  }
};

}  // namespace case_format
}  // namespace zenosphere
