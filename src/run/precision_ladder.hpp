#pragma once

#include <optional>
#include <vector>

#include "model/precision.hpp"

namespace zenosphere {

/// The precision in which a run is judged at first: a hundred digits, or twice its own.
Precision first_judge(Precision own);

/// Twice as many digits; nothing beyond the most that there are.
std::optional<Precision> doubled(Precision precision);

/// The precisions of trials from the run's own up to the highest, ascending: what the types of the
/// machine have, a hundred digits, `named`, and from that on twice as many each time.
std::vector<Precision> precision_ladder(Precision own, Precision named, Precision highest);

}  // namespace zenosphere
