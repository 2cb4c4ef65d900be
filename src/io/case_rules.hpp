#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/case.hpp"

namespace zenosphere::case_format {

/// What must hold between several keys that are each right by themselves.
struct Rule {
  std::span<const std::string_view> keys;  ///< all that it reads; the first one is the one to blame
  /// Why the first key's value is wrong, and what to do; nothing if it is right.
  std::optional<std::string> (*objection)(const Case&);
};

std::span<const Rule> rules();

}  // namespace zenosphere::case_format
