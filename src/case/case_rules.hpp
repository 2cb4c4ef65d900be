#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace zenosphere::case_format {

/// What must hold between several keys that are each right by themselves.
struct Rule {
  std::vector<std::string_view> keys;  ///< all that it reads; the first one is the one to blame
  /// Why the first key's value is wrong, and what to do; nothing if it is right.
  std::optional<std::string> (*objection)(const Case&);
};

/// All rules, in the order in which they are to be asked.
std::span<const Rule> rules();

/// The rules about the box and how many spheres fit into it; they come first in rules().
std::span<const Rule> box_rules();

/// The rules about speeds: what a number type can hold, and tell apart.
std::span<const Rule> speed_rules();

/// The rules about walls that oscillate or are thermal.
std::span<const Rule> wall_rules();

/// The rules about what the spheres are and how they touch.
std::span<const Rule> grain_rules();

/// Why polydispersity.spread is none of its distribution; nothing if it is.
std::optional<std::string> spread_objection(const Case& values);

/// Two keys of which a case needs one.
struct Choice {
  std::array<std::string_view, 2> keys;  ///< the second may be empty
  std::string_view depends_on;           ///< the key that `applies` reads, or empty
  bool (*applies)(const Case&);
  bool exclusive;           ///< one and no more
  std::string_view reason;  ///< why one is needed
};

std::span<const Choice> choices();

/// Whether something sets the spheres of a case moving even from rest.
bool is_driven(const Case& values);

}  // namespace zenosphere::case_format
