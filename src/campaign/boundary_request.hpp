#pragma once

#include <string_view>

#include "campaign/boundary_search.hpp"

namespace zenosphere {

/// What a search looks for, at each point of the other axes: the table [boundary] of a sweep file.
///
/// The axis is the last one of the sweep, with the two ends of the range as its values.
struct BoundaryRequest {
  enum class Criterion { separation, arrest } criterion = Criterion::separation;
  SearchRange range{};

  std::string_view criterion_word() const {
    return criterion == Criterion::arrest ? "arrest" : "separation";
  }
};

}  // namespace zenosphere
