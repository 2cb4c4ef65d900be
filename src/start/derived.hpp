#pragma once

#include <string>

#include "case/case.hpp"

namespace zenosphere {

/// What follows exactly from a case, as aligned lines for people: box, density, cells, start,
/// shear, size of the output.
///
/// Throws InputError, as given_start does, where positions or velocities that the case gives are
/// wrong.
std::string derived_text(const Case& values);

}  // namespace zenosphere
