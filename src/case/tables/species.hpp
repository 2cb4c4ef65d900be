#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "case/tables/friction.hpp"
#include "model/case_key.hpp"
#include "model/limits.hpp"

namespace zenosphere {

/// One kind of spheres, as a table [[species]] describes it.
struct Species {
  std::string name{};
  double diameter = 0;
  std::optional<double> mass{};           ///< none: diameter^D, the density of a unit sphere
  std::optional<double> share{};          ///< of the number of spheres
  std::optional<std::int64_t> spheres{};  ///< or their number
  bool immobile = false;

  /// All but its name.
  template <class Visitor>
  void keys(Visitor&& visit) {
    using namespace case_format;
    // A diameter or mass that is so far from the others is meant in another unit.
    visit(CaseKey{"diameter", required, from_to(1e-6, 1e6),
                  "of its spheres, in the mean of a distribution [length]"},
          diameter);
    visit(CaseKey{"mass", optional, from_to(1e-30, 1e30), "of a sphere of that diameter [mass]"},
          mass);
    visit(CaseKey{"share", optional, above_to(0, 1), "of the number of spheres"}, share);
    visit(
        CaseKey{"spheres", optional, from_to(1, static_cast<double>(most_spheres)), "their number"},
        spheres);
    visit(CaseKey{"immobile", optional, any, "whether nothing moves them"}, immobile);
  }
};

/// What holds between two kinds instead of the values for all, as a table [[contact]] has it.
struct SpeciesContact {
  std::array<std::string, 2> between{};
  std::optional<double> restitution{};
  std::optional<double> tangential_restitution{};
  std::optional<Friction> friction{};

  /// All but `between`.
  template <class Visitor>
  void keys(Visitor&& visit) {
    using namespace case_format;
    visit(CaseKey{"restitution", optional, from_to(0, 1, "1 is elastic"),
                  "normal speed after a collision / before"},
          restitution);
    visit(CaseKey{"tangential_restitution", optional, from_to(-1, 1, "-1 is smooth"),
                  "- tangential speed of the surfaces after a sticking contact / before"},
          tangential_restitution);
    visit(CaseKey{"friction", optional, from_to(0, most_friction, "or \"unbounded\""),
                  "tangential impulse of a sliding contact / normal impulse"},
          friction);
  }
};

}  // namespace zenosphere
