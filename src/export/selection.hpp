#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace zenosphere {

/// Which snapshots, counted from 0; for the table of collisions which collisions, by their number.
struct Selection {
  std::int64_t from = 0;             ///< negative: from the end, -1 is the last; snapshots only
  std::optional<std::int64_t> to{};  ///< likewise, itself included; none: to the last
  std::int64_t every = 1;            ///< one of so many, beginning with `from`; >= 1
};

/// The numbers first, first + step, ... up to and with last.
struct Numbers {
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::int64_t step = 1;

  bool contain(std::int64_t number) const {
    return number >= first && number <= last && (number - first) % step == 0;
  }
};

/// The snapshots that are selected of so many; at least one.
///
/// \param run  its output file, for the message
/// Throws InputError where there are none.
Numbers selected_snapshots(const Selection& selection, std::int64_t snapshots,
                           const std::filesystem::path& run);

/// The collisions that are selected.
///
/// Throws InputError where a number counts from the end.
Numbers selected_collisions(const Selection& selection, const std::filesystem::path& run);

}  // namespace zenosphere
