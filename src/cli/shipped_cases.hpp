#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zenosphere {

/// A case or sweep file of the folder examples/, which the program carries with it.
struct ShippedCase {
  std::string_view name;  ///< its path there without .toml: `shear-e06`, `new/rods`, `sweeps/disks`
  std::string_view text;
};

/// All of them, in the order of their names; written by cmake/shipped_cases.cmake.
std::span<const ShippedCase> shipped_cases();

/// Examples of one subject.
struct ExampleGroup {
  std::string_view heading;
  std::vector<ShippedCase> cases{};
};

/// The examples but the questions of `zenosphere new`, by subject, the simplest first.
std::vector<ExampleGroup> example_groups();

/// The first sentence of the comment that a file begins with.
std::string title_of(const ShippedCase& shipped);

}  // namespace zenosphere
