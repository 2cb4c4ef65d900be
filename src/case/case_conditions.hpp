#pragma once

#include "case/case_table.hpp"

namespace zenosphere::case_format {

// When a key exists.

inline constexpr Condition only_without_sides = {
    {"system.sides", ""},
    [](const Case& c) { return c.system.sides.empty(); },
    "a box without system.sides"};
inline constexpr Condition only_in_a_proportion = {
    {"system.dimension", "system.sides"},
    [](const Case& c) { return c.system.dimension > 1 && c.system.sides.empty(); },
    "two or three dimensions, without system.sides"};
inline constexpr Condition only_given = {
    {"start.arrangement", ""},
    [](const Case& c) { return c.start.arrangement == Arrangement::given; },
    "start.arrangement = \"given\""};
inline constexpr Condition only_from_file = {
    {"start.arrangement", ""},
    [](const Case& c) { return c.start.arrangement == Arrangement::file; },
    "start.arrangement = \"file\""};
inline constexpr Condition only_constant = {
    {"collision.restitution_law", ""},
    [](const Case& c) { return c.collision.restitution_law == RestitutionLaw::constant; },
    "collision.restitution_law = \"constant\""};
inline constexpr Condition only_viscoelastic = {
    {"collision.restitution_law", ""},
    [](const Case& c) { return c.collision.restitution_law == RestitutionLaw::viscoelastic; },
    "collision.restitution_law = \"viscoelastic\""};
inline constexpr Condition only_fixed_loss = {
    {"collision.restitution_law", ""},
    [](const Case& c) { return c.collision.restitution_law == RestitutionLaw::fixed_loss; },
    "collision.restitution_law = \"fixed-loss\""};
inline constexpr Condition only_two_valued = {
    {"collision.restitution_law", ""},
    [](const Case& c) { return c.collision.restitution_law == RestitutionLaw::two_valued; },
    "collision.restitution_law = \"two-valued\""};
inline constexpr Condition only_sheared = {
    {"drive.kind", ""},
    [](const Case& c) { return c.drive.kind == DriveKind::shear; },
    "drive.kind = \"shear\""};
inline constexpr Condition only_kicked = {
    {"drive.kind", ""},
    [](const Case& c) { return c.drive.kind == DriveKind::random; },
    "drive.kind = \"random\""};
inline constexpr Condition only_walled = {{"walls.axis", ""},
                                          [](const Case& c) { return c.walls.axis.has_value(); },
                                          "walls with an axis"};
inline constexpr Condition only_touched = {
    {"walls.axis", "system.dimension"},
    [](const Case& c) { return c.walls.axis.has_value() && c.system.dimension > 1; },
    "walls in two or three dimensions"};
inline constexpr Condition only_sliding = {
    {"walls.axis", ""},
    [](const Case& c) { return c.walls.axis.has_value() && c.walls.axis != Axis::x; },
    "walls normal to y or z, which can move along x"};
inline constexpr Condition only_oscillating = {
    {"walls.motion", ""},
    [](const Case& c) { return c.walls.motion.has_value(); },
    "a walls.motion"};
inline constexpr Condition only_turning = {{"system.dimension", ""},
                                           [](const Case& c) { return c.system.dimension > 1; },
                                           "two or three dimensions"};
inline constexpr Condition only_spread = {
    {"polydispersity.distribution", ""},
    [](const Case& c) { return c.polydispersity.distribution.has_value(); },
    "a polydispersity.distribution"};
inline constexpr Condition only_with_snapshots = {
    {"output.snapshot_interval", ""},
    [](const Case& c) { return c.output.snapshot_interval.has_value(); },
    "an output.snapshot_interval"};
inline constexpr Condition only_windowed = {
    {"output.collision_log", ""},
    [](const Case& c) { return c.output.collision_log == CollisionLog::window; },
    "output.collision_log = \"window\""};

}  // namespace zenosphere::case_format
