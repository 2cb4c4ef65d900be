#pragma once

#include <array>
#include <optional>

#include "model/case_key.hpp"
#include "model/word_table.hpp"

namespace zenosphere {

enum class SizeDistribution { uniform, normal, lognormal };
inline constexpr std::array distribution_words{Word{"uniform", SizeDistribution::uniform},
                                               Word{"normal", SizeDistribution::normal},
                                               Word{"lognormal", SizeDistribution::lognormal}};
inline const auto& words_of(SizeDistribution) { return distribution_words; }

namespace case_format {

inline constexpr When only_spread{
    "polydispersity.distribution", "",
    [](const auto& c) { return c.polydispersity.distribution.has_value(); },
    "a polydispersity.distribution"};

/// The table [polydispersity]: how the diameters of a species are spread.
struct Polydispersity {
  std::optional<SizeDistribution> distribution;  ///< none: all of a kind have its diameter
  double spread = 0;                             ///< standard deviation / mean of the diameter

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"distribution", with_table, any, "of the diameters of a species"}, distribution);
    visit(CaseKey{"spread", with_table, from_to(0, 1), "standard deviation / mean of the diameter"},
          spread, only_spread);
  }
};

}  // namespace case_format
}  // namespace zenosphere
