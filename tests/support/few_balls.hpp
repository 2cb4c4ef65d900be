#pragma once

#include <string>

/// Systems with an exact answer, as case files.
namespace zenosphere::test {

/// Three rods that collapse at the time 40/11: from the first collision on each one scales the
/// relative speed by 0.4, the gap by 0.125 and the flight by 0.3125.
inline const std::string three_rods_case = R"(
[system]
dimension = 1
spheres = 3
restitution = 0.05
sides = [100]
[start]
arrangement = "given"
positions = [10, 11, 13]
velocities = [1, 0, 0.125]
[drive]
kind = "none"
[collapse]
window = 10
[run]
time = 10
)";

/// A ball let go half a diameter above a floor that keeps half of its speed; at rest at the time 3.
inline const std::string ball_on_a_floor_case = R"(
[system]
dimension = 1
spheres = 1
sides = [10]
restitution = 1
[start]
arrangement = "given"
positions = [1.0]
velocities = [0]
[drive]
kind = "none"
[walls]
axis = "x"
restitution = 0.5
[gravity]
acceleration = [-1]
[collapse]
window = 10
[run]
time = 4
)";

}  // namespace zenosphere::test
