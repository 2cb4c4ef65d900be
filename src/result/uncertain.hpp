#pragma once

#include <string>

namespace zenosphere {

/// A number with its standard error as physicists write it: `1.139(2)` is 1.139 +- 0.002. The error
/// has one digit, or two where the first is a 1.
///
/// \param digits  significant ones of a value whose error is not known (NaN) or 0
std::string with_error(double value, double error, int digits);

}  // namespace zenosphere
