#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/adjudication_request.hpp"
#include "campaign/axis.hpp"
#include "campaign/boundary_request.hpp"
#include "case/case_template.hpp"

namespace zenosphere {

/// Most runs of a sweep: their rows take about a gigabyte.
inline constexpr std::int64_t most_runs = 10'000'000;
inline constexpr std::size_t most_axes = 16;
/// Most points of a search, each of which keeps what it knows in memory (0.2 to 10 MB).
inline constexpr std::int64_t most_searches = 1000;
inline constexpr std::size_t most_axis_values = 10'000;

/// When a run of a sweep ends, besides what its case says: the first reached ends it.
struct StopRule {
  std::optional<double> collisions_per_sphere;  ///< 2 collisions / N
  std::optional<double> wall_seconds;
  friend bool operator==(const StopRule&, const StopRule&) = default;
};

/// An ensemble of runs as its user describes it: the content of a sweep file.
struct Sweep {
  std::string name;               ///< of the file
  std::string text;               ///< as it was read, byte for byte
  CaseTemplate base;              ///< what all runs share; its places are those of the user's files
  std::string base_text;          ///< the same as a case file that needs no other, without a seed
  std::vector<SweepAxis> axes{};  ///< the last one varies fastest
  std::int64_t seeds = 0;         ///< runs at each point of the grid
  std::int64_t master_seed = 1;
  StopRule stop{};
  std::optional<BoundaryRequest> boundary{};  ///< a search: its axis is the last, seeds are 0
  std::optional<AdjudicationRequest> adjudicate{};

  std::int64_t points() const;

  /// Points that are searched at: those of all axes but the last.
  std::int64_t searches() const { return points() / static_cast<std::int64_t>(axes.back().size()); }
  /// Of a search: at most.
  std::int64_t runs() const {
    return boundary ? searches() * boundary->range.most_runs : points() * seeds;
  }
};

/// The sweep that a file describes; docs/sweep-file.md lists the keys.
///
/// Every value of every axis has been through the case reader, together with the others where there
/// are few enough points to try them all.
/// Throws InputError with one line for each problem of the sweep file and of the base case.
Sweep read_sweep(const std::filesystem::path& file);

/// The sweep that a text describes; `name` is what messages call it.
Sweep parse_sweep(std::string text, const std::string& name);

}  // namespace zenosphere
