#include "result/summary_species.hpp"

#include <fmt/format.h>

#include "text/counted.hpp"

namespace zenosphere {

std::string species_lines(const Summary& summary) {
  std::string text;
  const auto& averages = summary.averages;
  if (averages && averages->rotational_temperature) {
    text += fmt::format("  {:<24}{:.6g} (diameter/time)^2\n", "rotational temperature",
                        *averages->rotational_temperature);
  }
  for (const Summary::Kind& kind : summary.species) {
    text += fmt::format("  {:<24}{}", "species " + kind.name, counted(kind.spheres, "sphere"));
    if (kind.granular_temperature) {
      text += fmt::format(", granular temperature {:.6g}", *kind.granular_temperature);
    }
    if (kind.rotational_temperature) {
      text += fmt::format(", rotational {:.6g}", *kind.rotational_temperature);
    }
    text += '\n';
  }
  return text;
}

}  // namespace zenosphere
