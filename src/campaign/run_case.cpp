#include "campaign/run_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "campaign/grid_check.hpp"
#include "campaign/seeds.hpp"

namespace zenosphere {

using case_format::Entry;
using case_format::Problems;

namespace {

/// The value that a key has in a case, or null.
const Entry* entry_of(std::string_view path, std::span<const Entry> base,
                      std::span<const Entry> overrides) {
  const Entry* found = nullptr;
  const auto look = [&](const Entry& entry) {
    if (entry.key() == path) found = &entry;
  };
  std::for_each(base.begin(), base.end(), look);
  std::for_each(overrides.begin(), overrides.end(), look);
  return found;
}

std::optional<std::int64_t> count_in(const Entry* entry) {
  if (!entry) return std::nullopt;
  const auto value = in_storage(entry->value, Storage::integer);
  const auto* number = std::get_if<std::int64_t>(&value);
  return number ? std::optional(*number) : std::nullopt;
}

/// Ends the run after so many collisions of each sphere, unless the case ends it before. What is
/// wrong with the case's own counts is left for the case reader to tell.
void add_stop(const CaseTemplate& base, const StopRule& stop, std::vector<Entry>& overrides) {
  if (!stop.collisions_per_sphere) return;
  const auto spheres = count_in(entry_of("system.spheres", base.entries(), overrides));
  if (!spheres) return;
  const double most = std::ceil(*stop.collisions_per_sphere * static_cast<double>(*spheres) / 2);
  if (const Entry* given = entry_of("run.collisions", base.entries(), overrides)) {
    const auto count = count_in(given);
    if (!count || static_cast<double>(*count) <= most) return;
  }
  const auto place = case_format::Place::in_override("stop.collisions_per_sphere", 0);
  overrides.push_back({"run", "collisions", most, place, place});
}

Case case_of_run(const CaseTemplate& base, const StopRule& stop, std::vector<Entry> overrides,
                 Problems& problems) {
  add_stop(base, stop, overrides);
  Case values = base.with(std::move(overrides), problems);
  problems.throw_if_any();
  return values;
}

}  // namespace

Case case_of_run(const CaseTemplate& base, const StopRule& stop, std::vector<Entry> overrides) {
  Problems problems;
  return case_of_run(base, stop, std::move(overrides), problems);
}

Case case_of_run(const CaseTemplate& base, const StopRule& stop,
                 const std::vector<std::string>& overrides) {
  Problems problems;
  auto entries = case_format::entries_of(overrides, problems);
  return case_of_run(base, stop, std::move(entries), problems);
}

std::vector<std::string> overrides_of(const Sweep& sweep, std::int64_t run) {
  std::vector<std::string> overrides{fmt::format(
      "start.seed={}",
      run_seed(static_cast<std::uint64_t>(sweep.master_seed), static_cast<std::uint64_t>(run)))};
  const auto coordinates = coordinates_of(sweep.axes, run % sweep.points());
  for (std::size_t n = 0; n < coordinates.size(); ++n) {
    const SweepAxis& axis = sweep.axes[n];
    overrides.push_back(axis.key.override_of(column_text(axis.values[coordinates[n]].value)));
  }
  return overrides;
}

}  // namespace zenosphere
