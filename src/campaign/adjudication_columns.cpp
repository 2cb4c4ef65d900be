#include "campaign/adjudication_columns.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>

namespace zenosphere {
namespace {

/// The approaches of one group of hits, at least one.
using Group = std::span<const JudgedApproach>;

/// The groups that were judged. The approaches of one stand together.
std::vector<Group> groups_of(const Adjudication& found) {
  const std::vector<JudgedApproach>& all = found.approaches;
  std::vector<Group> groups;
  for (auto begin = all.begin(); begin != all.end();) {
    const auto end = std::find_if(begin, all.end(),
                                  [&](const auto& one) { return one.run_hit != begin->run_hit; });
    groups.emplace_back(begin, end);
    begin = end;
  }
  return groups;
}

const JudgedApproach& strongest(Group group) {
  return *std::max_element(group.begin(), group.end(),
                           [](const auto& a, const auto& b) { return a.finding < b.finding; });
}

/// A cell from the first group of the run's hits; NULL where there was no time for it.
template <class Of>
Cell of_first(const TimedAdjudication& timed, Of of) {
  const auto groups = groups_of(timed.found);
  return groups.empty() ? Cell() : Cell(of(groups.front()));
}

Cell finding(const TimedAdjudication& timed) { return std::string(word(timed.found.finding)); }

Cell first_finding(const TimedAdjudication& timed) {
  return of_first(timed, [](Group group) { return std::string(word(strongest(group).finding)); });
}

Cell first_sentence(const TimedAdjudication& timed) {
  return of_first(timed, [](Group group) { return strongest(group).sentence; });
}

Cell first_spheres(const TimedAdjudication& timed) {
  return of_first(timed, [](Group group) { return std::ssize(strongest(group).spheres); });
}

Cell first_decades(const TimedAdjudication& timed) {
  return of_first(timed, [](Group group) {
    const auto deepest =
        std::max_element(group.begin(), group.end(),
                         [](const auto& a, const auto& b) { return a.decades < b.decades; });
    return std::int64_t{deepest->decades};
  });
}

Cell groups_judged(const TimedAdjudication& timed) { return std::ssize(groups_of(timed.found)); }

template <Finding finding>
Cell groups_with(const TimedAdjudication& timed) {
  const auto groups = groups_of(timed.found);
  return std::int64_t{std::count_if(groups.begin(), groups.end(), [](Group group) {
    return strongest(group).finding == finding;
  })};
}

Cell first_margin_per_decade(const TimedAdjudication& timed) {
  return of_first(timed, [](Group group) {
    const auto& curvature = strongest(group).curvature;
    return curvature ? Cell(curvature->per_decade) : Cell();
  });
}

Cell collapse_time(const TimedAdjudication& timed) {
  const auto& all = timed.found.approaches;
  const auto first = std::find_if(all.begin(), all.end(), [](const JudgedApproach& one) {
    return one.finding == Finding::singular || one.finding == Finding::proven;
  });
  if (first == all.end() || !first->collapse_time) return {};
  return std::strtod(first->collapse_time->c_str(), nullptr);
}

constexpr std::array<AdjudicationColumn, 17> adjudication_list{{
    {"adjudication_finding", "TEXT", finding},
    {"adjudication_first_finding", "TEXT", first_finding},
    {"adjudication_sentence", "TEXT", first_sentence},
    {"adjudication_groups", "INTEGER", groups_judged},
    {"adjudication_left_out", "INTEGER",
     [](const TimedAdjudication& timed) -> Cell { return timed.found.left_out; }},
    {"adjudication_proven", "INTEGER", groups_with<Finding::proven>},
    {"adjudication_singular", "INTEGER", groups_with<Finding::singular>},
    {"adjudication_near_collapse", "INTEGER", groups_with<Finding::near_collapse>},
    {"adjudication_exact_contact", "INTEGER", groups_with<Finding::exact_contact>},
    {"adjudication_chance_close_pair", "INTEGER", groups_with<Finding::chance_close_pair>},
    {"adjudication_arithmetic_arrest", "INTEGER", groups_with<Finding::arithmetic_arrest>},
    {"adjudication_undecided", "INTEGER", groups_with<Finding::undecided>},
    {"adjudication_first_spheres", "INTEGER", first_spheres},
    {"adjudication_collapse_time", "REAL", collapse_time},
    {"adjudication_decades", "INTEGER", first_decades},
    {"adjudication_margin_per_decade", "REAL", first_margin_per_decade},
    {"adjudication_seconds", "REAL",
     [](const TimedAdjudication& timed) -> Cell { return timed.seconds; }},
}};

}  // namespace

std::span<const AdjudicationColumn> adjudication_columns() { return adjudication_list; }

std::vector<Cell> adjudication_cells(const TimedAdjudication& adjudication) {
  std::vector<Cell> cells;
  for (const AdjudicationColumn& column : adjudication_list)
    cells.push_back(column.cell(adjudication));
  return cells;
}

}  // namespace zenosphere
