#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace zenosphere {

/// One line of the table: the names of all lines end in the same column.
inline std::string line(std::string_view name, const std::string& value) {
  return fmt::format("  {:<24}{}\n", name, value);
}

}  // namespace zenosphere
