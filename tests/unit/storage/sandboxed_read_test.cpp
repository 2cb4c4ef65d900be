#include "storage/sandboxed_read.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <vector>

#include "model/errors.hpp"
#include "unit/storage/temporary_folder.hpp"

namespace zenosphere {
namespace {

/// What is said about a reading, or nothing.
std::string problem(const std::function<void()>& reading) {
  try {
    sandboxed_read("a.h5", 0, reading);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SandboxedRead, OfAReadingThatGoesWellChangesNothingHere) {
  int readings = 0;
  EXPECT_EQ(problem([&] { ++readings; }), "");
  EXPECT_EQ(readings, 0);  // it was another process that counted
}

TEST(SandboxedRead, PassesRefusalsOn) {
  const std::string text(100'000, 'x');  // more than a pipe holds
  EXPECT_EQ(problem([&] { throw InputError(text); }), text);
}

TEST(SandboxedRead, SurvivesAReadingThatCrashes) {
  EXPECT_EQ(problem([] { std::abort(); }),
            "a.h5: cannot be read (HDF5 fails while it reads it); it is damaged");
  EXPECT_EQ(problem([] { throw 1; }),
            "a.h5: cannot be read (HDF5 fails while it reads it); it is damaged");
}

TEST(SandboxedRead, BoundsMemory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers map terabytes";
#endif
  EXPECT_EQ(problem([] { std::vector<char>(1'000'000'000); }),
            "a.h5: cannot be read (reading it takes too much memory); it is damaged");
}

TEST(SandboxedRead, WritesNoFiles) {
  const TemporaryFolder folder;
  const auto file = folder.path / "x";
  EXPECT_NE(problem([&] { std::ofstream(file) << "text" << std::flush; }), "");
  EXPECT_EQ(std::filesystem::file_size(file), 0u);
}

}  // namespace
}  // namespace zenosphere
