#include "cli/progress_line.hpp"

#include <fmt/format.h>

#include <cmath>

namespace zenosphere {

std::string duration_text(double seconds) {
  if (!(seconds < 360000)) return "more than 100 h";
  const int whole = static_cast<int>(std::lround(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string progress_line(const Progress& progress) {
  std::string line = fmt::format("{:>3.0f} %  {} collisions  time {:.6g}  {:.3g}/s  {} hits",
                                 100 * progress.done, progress.collisions, progress.time,
                                 progress.collisions_per_second, progress.separation_hits);
  if (progress.done > 0) {
    const double left = progress.wall_seconds * (1 - progress.done) / progress.done;
    line += fmt::format("  {} left", duration_text(left));
  }
  return line;
}

}  // namespace zenosphere
