#include "cli/search_text.hpp"

#include <fmt/format.h>

namespace zenosphere {

namespace {

/// `0.312 (95 %: 0.298 to 0.331)`, with dashes beyond the range.
std::string estimate_text(const Estimate& estimate, const SearchRange& range) {
  const auto number = [&](double x) -> std::string {
    return x < range.from ? "below the range"
           : x > range.to ? "above the range"
                          : fmt::format("{:.4g}", x);
  };
  return fmt::format("{} (95 %: {} to {})", number(estimate.place), number(estimate.low),
                     number(estimate.high));
}

std::string answer(const FoundBoundary& found, const BoundaryRequest& request) {
  switch (found.finding) {
    case BoundaryFinding::crossing:
      return estimate_text(found.estimate, request.range);
    case BoundaryFinding::below:
      return "P < 1/2 in the whole range";
    case BoundaryFinding::above:
      return "P > 1/2 in the whole range";
    case BoundaryFinding::unresolved:
      break;
  }
  return "unresolved, " + estimate_text(found.estimate, request.range);
}

}  // namespace

std::string found_text(const Sweep& sweep, const SearchResult& result) {
  if (!sweep.boundary || result.progress.counts.pending > 0) return "";
  std::string text = fmt::format("{} where P({}) = 1/2:\n", sweep.axes.back().path(),
                                 sweep.boundary->criterion_word());
  for (const FoundBoundary& found : result.found) {
    std::string point;
    for (std::size_t n = 0; n < found.values.size(); ++n) {
      point += fmt::format("{} = {}  ", sweep.axes[n].path(), found.values[n]);
    }
    text += fmt::format("  {}{}, {} runs\n", point, answer(found, *sweep.boundary), found.runs);
  }
  return text;
}

}  // namespace zenosphere
