#pragma once

#include <vector>

#include "model/case_key.hpp"

namespace zenosphere::case_format {

/// The table [gravity].
struct Gravity {
  std::vector<double> acceleration{};  ///< D components, diameters/time^2; empty: none

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"acceleration", with_table, any, "of every sphere [diameters/time^2]"},
          acceleration);
  }
};

}  // namespace zenosphere::case_format
