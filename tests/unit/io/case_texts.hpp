#pragma once

#include <string>
#include <vector>

#include "io/case_file.hpp"
#include "model/errors.hpp"

namespace zenosphere {

/// The smallest case without a drive. `restitution` stands on line 5.
inline const std::string cooling_case = R"(# cooling
[system]
dimension = 3
spheres = 4000
restitution = 0.9
solids_volume_fraction = 0.3
[start]
arrangement = "fcc"
granular_temperature = 1.0
[drive]
kind = "none"
[run]
collisions = 100
)";

/// The smallest sheared case.
inline const std::string shear_case = R"(
[system]
dimension = 3
spheres = 4000
restitution = 0.6
solids_volume_fraction = 0.3
[start]
arrangement = "fcc"
granular_temperature = 6e-3
[drive]
kind = "shear"
shear_rate = 1
[run]
time = 200
)";

inline Case overridden(const std::string& text, const std::vector<std::string>& overrides) {
  return parse_case(text, "e.toml", overrides);
}

/// The text of the InputError, or nothing if the case is right.
inline std::string problems_of(const std::string& text,
                               const std::vector<std::string>& overrides = {}) {
  try {
    overridden(text, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// `text` with its first `old` replaced.
inline std::string replaced(std::string text, const std::string& old, const std::string& with) {
  return text.replace(text.find(old), old.size(), with);
}

}  // namespace zenosphere
