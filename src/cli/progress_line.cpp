#include "cli/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/counted.hpp"

namespace zenosphere {

std::string duration_text(double seconds) {
  if (!(seconds < 360000)) return "more than 100 h";
  const int whole = static_cast<int>(std::lround(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string fitted_line(std::vector<LinePart> parts, std::size_t columns) {
  const auto joined = [&] {
    std::string line;
    for (const LinePart& part : parts) line += (line.empty() ? "" : "  ") + part.text;
    return line;
  };
  while (parts.size() > 1 && joined().size() > columns) {
    parts.erase(std::max_element(parts.begin(), parts.end(),
                                 [](const auto& a, const auto& b) { return a.rank < b.rank; }));
  }
  return joined();
}

std::string progress_line(const Progress& progress, std::size_t columns) {
  std::vector<LinePart> parts{{fmt::format("{:>3.0f} %", 100 * progress.done), 0},
                              {counted(progress.collisions, "collision"), 2},
                              {fmt::format("time {:.6g}", progress.time), 5},
                              {fmt::format("{:.3g}/s", progress.collisions_per_second), 4},
                              {counted(progress.separation_hits, "hit"), 3}};
  if (progress.done > 0) {
    const double left = progress.wall_seconds * (1 - progress.done) / progress.done;
    parts.push_back({fmt::format("{} left", duration_text(left)), 1});
  }
  return fitted_line(std::move(parts), columns);
}

}  // namespace zenosphere
