#pragma once

#include <string>
#include <vector>

#include "case/case_file.hpp"
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

/// Three balls in a plane; the system stands on lines 1 to 5, the start on 6 to 9.
inline const std::string triple_case = R"([system]
dimension = 2
spheres = 3
restitution = 0.05
sides = [10, 8]
[start]
arrangement = "given"
positions = [[1, 1], [2, 1], [4, 1]]
velocities = [[1, 0], [0, 0], [-1, 0]]
[drive]
kind = "none"
[run]
collisions = 100
)";

/// A ball above a floor.
inline const std::string ball_case = R"([system]
dimension = 1
spheres = 1
restitution = 1
sides = [10]
[start]
arrangement = "given"
positions = [1]
velocities = [0]
[drive]
kind = "none"
[walls]
axis = "x"
restitution = 0.5
[gravity]
acceleration = [-1]
[run]
collisions = 100
)";

inline const std::string rod_case = R"([system]
dimension = 1
spheres = 4
restitution = 0.9
solids_volume_fraction = 0.5
[start]
arrangement = "random"
granular_temperature = 1
[drive]
kind = "none"
[run]
collisions = 100
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

/// What is said about one override of a case, without the place.
inline std::string objection(const std::string& text, const std::string& override_text) {
  const std::string problems = problems_of(text, {override_text});
  const std::string place = "--set " + override_text + ": ";
  return problems.starts_with(place) ? problems.substr(place.size()) : problems;
}

/// A case in three dimensions, made one of randomly placed disks.
inline std::string in_plane(const std::string& text) {
  return replaced(replaced(text, "dimension = 3", "dimension = 2"), "\"fcc\"", "\"random\"");
}

}  // namespace zenosphere
