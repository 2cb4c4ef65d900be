#pragma once

#include <array>
#include <optional>
#include <string>

#include "case/tables/friction.hpp"
#include "model/case_key.hpp"
#include "model/overlap_rule.hpp"
#include "model/precision.hpp"
#include "model/restitution/laws.hpp"
#include "model/word_table.hpp"

namespace zenosphere {

inline constexpr std::array overlap_words{
    Word{"rewind", OverlapRule::rewind}, Word{"immediate", OverlapRule::immediate},
    Word{"guarded", OverlapRule::guarded}, Word{"stop", OverlapRule::stop}};
inline const auto& words_of(OverlapRule) { return overlap_words; }

namespace case_format {

// Beyond every run, and far below the time at which a sphere that never met has met.
inline constexpr double longest_contact = 1e100;
// A right angle: a pair may still recede then, whatever its velocity.
inline constexpr double widest_rotation = 1.57;

inline constexpr When only_turning{"system.dimension", "",
                                   [](const auto& c) { return c.system.dimension > 1; },
                                   "two or three dimensions"};

/// The table [collision]: what two spheres do to each other, and in which arithmetic.
struct Collisions : RestitutionLaws::Numbers {
  OverlapRule overlap = OverlapRule::rewind;
  double guard = 1e-15;  ///< diameter^2/time; only the rule `guarded` reads it
  Precision precision = Precision::double_precision;
  RestitutionLaw restitution_law = RestitutionLaw::constant;
  double contact_duration = 0;                        ///< of the TC model, time; 0: not used
  double rotation_angle = 0;                          ///< largest, radians; 0: not used
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
    RestitutionLaws::for_each(*this, [&]<class Law>(Law& law) {
      static const std::string text =
          "collision.restitution_law = \"" + std::string(Law::word) + '"';
      const When only_with_it{
          "collision.restitution_law", "",
          [](const auto& c) { return c.collision.restitution_law == Law::choice; }, text};
      law.keys([&](const CaseKey& key, double& number) { visit(key, number, only_with_it); });
    });
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
