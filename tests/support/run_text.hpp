#pragma once

#include <string>
#include <vector>

#include "case/case_file.hpp"
#include "run/run.hpp"

namespace zenosphere::test {

/// Runs the case of a TOML text to its end and returns the summary; nothing is written.
inline Summary run_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return run_case(parse_case(text, "test.toml", overrides), RunOptions{});
}

}  // namespace zenosphere::test
