#include "export/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "model/errors.hpp"

namespace zenosphere {
namespace {

std::string words_of(const Selection& selection) {
  std::string words = fmt::format("--from {}", selection.from);
  if (selection.to) words += fmt::format(" --to {}", *selection.to);
  return words;
}

}  // namespace

Numbers selected_snapshots(const Selection& selection, std::int64_t snapshots,
                           const std::filesystem::path& run) {
  const auto counted = [&](std::int64_t number) {
    return number < 0 ? snapshots + number : number;
  };
  const Numbers numbers{counted(selection.from),
                        std::min(counted(selection.to.value_or(-1)), snapshots - 1),
                        selection.every};
  if (numbers.first >= 0 && numbers.first <= numbers.last) return numbers;
  throw InputError(fmt::format("{}: {} selects no snapshot (there are {}{}); choose others",
                               run.string(), words_of(selection), snapshots,
                               snapshots > 0 ? fmt::format(", 0 to {}", snapshots - 1) : ""));
}

Numbers selected_collisions(const Selection& selection, const std::filesystem::path& run) {
  const std::int64_t last = selection.to.value_or(std::numeric_limits<std::int64_t>::max());
  if (selection.from >= 0 && last >= selection.from) return {selection.from, last, selection.every};
  throw InputError(fmt::format(
      "{}: {} selects no collision (they are numbered from 1, zenosphere info tells how many there "
      "are); choose others",
      run.string(), words_of(selection)));
}

}  // namespace zenosphere
