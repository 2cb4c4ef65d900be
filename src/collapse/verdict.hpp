#pragma once

#include <cstdint>
#include <optional>

namespace zenosphere {

/// What a run says about collapse.
enum class Verdict {
  none,       ///< the separation criterion was never met
  temporary,  ///< it was met, and not again during the last window of collisions
  open,       ///< it was still being met when the run ended
  arrested,   ///< the arrest criterion was met: a true collapse in the paper's sense
};

/// The verdict after a number of collisions.
///
/// \param last_hit  the last collision at which the separation criterion was met, if any
/// \param window    collisions, the window of the arrest criterion
Verdict verdict(std::int64_t collisions, std::optional<std::int64_t> last_hit, bool arrest_is_met,
                std::int64_t window);

/// The word for a verdict in files and on the screen: none, temporary, open, true.
const char* word(Verdict verdict);

}  // namespace zenosphere
