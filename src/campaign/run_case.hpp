#pragma once

#include <string>
#include <vector>

#include "campaign/sweep.hpp"

namespace zenosphere {

/// The case of one run of a sweep.
///
/// \param overrides  its axis values and its seed
/// Throws InputError where they make no case.
Case case_of_run(const CaseTemplate& base, const StopRule& stop,
                 std::vector<case_format::Entry> overrides);

/// The axis values and the seed of a run, as arguments of `--set`, in a store that is begun with
/// the sweep as it is: the replica is outermost, the last axis fastest.
std::vector<std::string> overrides_of(const Sweep& sweep, std::int64_t run);

/// The case of one run from arguments of `--set`, as a store gives them.
Case case_of_run(const CaseTemplate& base, const StopRule& stop,
                 const std::vector<std::string>& overrides);

}  // namespace zenosphere
