#include "campaign/column_cell.hpp"

#include <fmt/format.h>

namespace zenosphere {

Cell cell_of(const std::vector<std::pair<std::int64_t, std::int64_t>>& pairs) {
  std::string text;
  for (const auto& [i, j] : pairs)
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", i, j);
  return '[' + text + ']';
}

}  // namespace zenosphere
