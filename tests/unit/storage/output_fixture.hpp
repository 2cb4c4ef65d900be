#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>

#include "model/errors.hpp"
#include "storage/output_file.hpp"
#include "unit/storage/temporary_folder.hpp"

namespace zenosphere {

namespace fs = std::filesystem;

inline const OutputFile::Header planar_pair{"a = 1  # \u00b5\n", "a = 1\n", 2, 2};

inline Snapshot snapshot(std::int64_t step) {
  const double x = 0.1 * static_cast<double>(step);
  const auto image = static_cast<std::int32_t>(step);
  return {step, x, {x, 1, 2, 3}, {-x, 5, 6, 7}, {8, 0, x, 8}, {image, 0, -image, 1}};
}

inline CollisionRow row(std::int64_t k) {
  const double x = static_cast<double>(k);
  const auto i = static_cast<std::int32_t>(k);
  return {k, x / 3, i, i + 1, -x / 7, x / 11, static_cast<std::uint8_t>(k % 32)};
}

/// A checkpoint whose state tells one from another.
inline Checkpoint checkpoint(std::int64_t collisions) {
  Checkpoint checkpoint;
  checkpoint.collisions = collisions;
  checkpoint.time = 0.1 * static_cast<double>(collisions);
  checkpoint.summary = "{}";
  checkpoint.state = {1, 2, 3, static_cast<std::uint8_t>(collisions % 251)};
  return checkpoint;
}

/// A run of so many collisions, from `begin` to its end.
inline void write_run(OutputFile& output, std::int64_t rows) {
  output.write(snapshot(0));
  output.begin(checkpoint(0));
  for (std::int64_t k = 1; k <= rows; ++k) output.append(row(k));
}

inline Summary summary_of(std::int64_t collisions) {
  Summary summary;
  summary.collisions = collisions;
  summary.verdict = Verdict::none;
  return summary;
}

inline std::string error_text(const std::function<void()>& action) {
  try {
    action();
  } catch (const OutputError& error) {
    return error.what();
  }
  return "no OutputError";
}

/// While this lives, no file may grow beyond a size: a full disk for tests.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

class OutputFileTest : public ::testing::Test {
 protected:
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder.path), fs::directory_iterator());
  }

  void finish(OutputFile& output, std::int64_t collisions) const {
    output.end(checkpoint(collisions));
    output.finish(summary_of(collisions));
  }

  TemporaryFolder folder;
  fs::path path = folder.path / "out.h5";
};

}  // namespace zenosphere
