#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "start/start_file.hpp"
#include "unit/case/case_texts.hpp"
#include "unit/storage/temporary_folder.hpp"

namespace zenosphere {

/// Two disks in a box of 10 x 8, written in the case.
inline const std::string planar_case = R"([system]
dimension = 2
spheres = 2
restitution = 0.5
sides = [10, 8]
[start]
arrangement = "given"
positions = [[1, 1], [4, 1]]
velocities = [[1, 0.5], [0, 0]]
[drive]
kind = "none"
[run]
collisions = 100
)";

/// What is wrong with the start of a case, if anything.
inline std::string start_problem(const Case& values) {
  try {
    given_start(values);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The same disks in a file.
class StartFile : public testing::Test {
 protected:
  /// The planar case with its start in a file.
  Case case_with(std::vector<std::string> overrides = {}) const {
    overrides.insert(overrides.end(), {"start.arrangement=file", "start.file=" + file.string()});
    return overridden(planar_case, overrides);
  }
  void write(const std::string& content) const { std::ofstream(file, std::ios::binary) << content; }
  /// The problem of the content, without the folder.
  std::string problem_of(const std::string& content) const {
    write(content);
    return problem();
  }
  std::string problem(const std::vector<std::string>& overrides = {}) const {
    const std::string text = start_problem(case_with(overrides));
    const std::string place = folder.path.string() + "/";
    return text.starts_with(place) ? text.substr(place.size()) : text;
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder.path / "start";
};

/// The first lines of a file of extended XYZ with those disks, and the others.
inline const std::string xyz_header =
    "2\nLattice=\"10 0 0 0 8 0 0 0 1\" Properties=species:S:1:pos:R:3:velo:R:3\n";
inline const std::string xyz_rows = "A 1 1 0 1 0.5 0\nA 4 1 0 0 0 0\n";

}  // namespace zenosphere
