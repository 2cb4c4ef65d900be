#pragma once

#include <string>

#include "case/case.hpp"

namespace zenosphere {

/// The words for values of a case, as case files have them.
std::string word(Precision precision);
const char* word(OverlapRule rule);

}  // namespace zenosphere
