#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace zenosphere::verify {

/// Contradictions found in a file. One mistake can have thousands of consequences: the first are
/// kept, all are counted.
class Findings {
 public:
  void add(std::string text) {
    constexpr std::size_t most_kept = 20;
    if (texts_.size() < most_kept) texts_.push_back(std::move(text));
    ++count_;
  }

  const std::vector<std::string>& texts() const { return texts_; }
  std::int64_t count() const { return count_; }

 private:
  std::vector<std::string> texts_;
  std::int64_t count_ = 0;
};

}  // namespace zenosphere::verify
