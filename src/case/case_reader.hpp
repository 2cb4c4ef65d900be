#pragma once

#include <span>
#include <string>

#include "case/case.hpp"
#include "case/case_entries.hpp"
#include "case/case_problems.hpp"

namespace zenosphere::case_format {

/// The case that the entries describe; it is worth something only if no problem was added.
///
/// \param entries   no two for the same key; the head of a table before what stands in it
/// \param name      what stands in front of a problem that has no line
/// \param problems  gets every unknown, wrong, contradictory and missing key
Case case_of(std::span<const Entry> entries, const std::string& name, Problems& problems);

}  // namespace zenosphere::case_format
