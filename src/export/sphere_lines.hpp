#pragma once

#include <fmt/compile.h>
#include <fmt/format.h>

#include "export/frame.hpp"
#include "storage/new_file.hpp"

namespace zenosphere {

/// Writes a line for each sphere of a frame: what `write_line(line, i)` appends for sphere i, and
/// how often it has collided, where that is known.
template <class Action>
void write_sphere_lines(NewFile& file, const Frame& frame, Action write_line) {
  fmt::memory_buffer line;
  for (std::int64_t i = 0; i < frame.spheres(); ++i) {
    line.clear();
    write_line(fmt::appender(line), i);
    if (!frame.collisions.empty()) {
      fmt::format_to(fmt::appender(line), FMT_COMPILE(" {}"),
                     frame.collisions[static_cast<std::size_t>(i)]);
    }
    line.push_back('\n');
    file.write({line.data(), line.size()});
  }
}

}  // namespace zenosphere
