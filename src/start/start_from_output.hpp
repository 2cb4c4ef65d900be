#pragma once

#include <string>

#include "case/case.hpp"
#include "start/start_file.hpp"

namespace zenosphere {

/// The snapshot of an output file that `start.snapshot` names, or its last one: of a run that goes
/// on, that of its last checkpoint. What the file tells of its spheres comes with it.
///
/// Throws InputError as read_output_info does, and where the file does not hold that snapshot or
/// those of another number of spheres or dimensions.
GivenStart start_from_output(const Case& values, const std::string& file);

}  // namespace zenosphere
