#include "run/species_summary.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "case/case_grains.hpp"

namespace zenosphere {

std::vector<Summary::Kind> species_summary(const Case& values,
                                           const std::optional<Averages>& averages) {
  if (values.species.empty()) return {};
  const std::vector<std::int64_t> spheres = spheres_by_species(values);
  std::vector<Summary::Kind> kinds;
  // An only kind is the whole, and of one that is immobile there is no temperature.
  const auto temperature = [&](const std::vector<double>& each, std::size_t kind,
                               std::optional<double> of_all) -> std::optional<double> {
    if (values.species.size() == 1) return of_all;
    if (kind >= each.size() || !std::isfinite(each[kind])) return std::nullopt;
    return values.species[kind].immobile ? std::nullopt : std::optional(each[kind]);
  };
  for (std::size_t kind = 0; kind < values.species.size(); ++kind) {
    Summary::Kind row{values.species[kind].name, spheres[kind]};
    if (averages) {
      row.granular_temperature =
          temperature(averages->temperature_of_kind, kind, averages->granular_temperature);
      row.rotational_temperature = temperature(averages->rotational_temperature_of_kind, kind,
                                               averages->rotational_temperature);
    }
    kinds.push_back(std::move(row));
  }
  return kinds;
}

}  // namespace zenosphere
