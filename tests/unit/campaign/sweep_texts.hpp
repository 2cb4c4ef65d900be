#pragma once

#include <string>

namespace zenosphere {

/// The case inside the sweeps of these tests: 32 spheres, some milliseconds.
inline const std::string inline_case = R"([case.system]
dimension = 3
spheres = 32
solids_volume_fraction = 0.3
[case.start]
arrangement = "fcc"
granular_temperature = 0.1
[case.drive]
kind = "shear"
shear_rate = 1
[case.collapse]
window = 200
)";

/// A sweep of two axes and two seeds, eight runs of 320 collisions at most. `[axes]` is on line 4,
/// the restitution on line 5, the fraction on line 6.
inline const std::string small_sweep = R"([sweep]
seeds = 2
master_seed = 7
[axes]
"system.restitution" = [0.2, 0.9]
"system.solids_volume_fraction" = [0.2, 0.3]
[stop]
collisions_per_sphere = 20
)" + inline_case;

/// A sweep over the mass of the heavy spheres of a mixture (line 4) and the restitution of a pair.
inline const std::string mixture_sweep = R"([sweep]
seeds = 2
[axes]
"species.heavy.mass" = [1, 10]
"contact.light.heavy.restitution" = [0.5, 0.7]
[stop]
collisions_per_sphere = 20
[[case.species]]
name = "light"
diameter = 1
share = 0.5
[[case.species]]
name = "heavy"
mass = 3
diameter = 1
share = 0.5
[[case.contact]]
between = ["light", "heavy"]
friction = 0.1
tangential_restitution = 0.5
[case.drive]
kind = "none"
[case.start]
arrangement = "fcc"
granular_temperature = 0.1
[case.system]
dimension = 3
spheres = 32
restitution = 0.9
solids_volume_fraction = 0.3
)";

/// A text with one part of it replaced.
inline std::string replaced(std::string text, const std::string& part, const std::string& other) {
  return text.replace(text.find(part), part.size(), other);
}

}  // namespace zenosphere
