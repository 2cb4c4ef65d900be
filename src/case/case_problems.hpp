#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/errors.hpp"

namespace zenosphere::case_format {

/// Where something stands in the user's input, as a text for people and as a number for sorting.
///
/// The lines of the file come first, then the overrides in the order of the command line, then
/// what is nowhere (a missing key).
struct Place {
  std::string text;                     ///< `e06.toml:6:15` or `--set system.restitution=1.2`
  std::array<std::int64_t, 3> order{};  ///< source, line or number of the override, column

  static Place in_file(const std::string& name, std::int64_t line, std::int64_t column) {
    return {name + ':' + std::to_string(line) + ':' + std::to_string(column), {0, line, column}};
  }
  static Place in_override(std::string text, std::int64_t number) {
    return {std::move(text), {1, number, 0}};
  }
  bool is_override() const { return order[0] == 1; }
  static Place absent(std::string name) { return {std::move(name), {2, 0, 0}}; }
};

/// Everything that is wrong with one case, collected so that it can be told at once.
class Problems {
 public:
  /// Notes a problem; `text` is what follows the place.
  void add(const Place& place, const std::string& text) {
    noted_.emplace_back(place.order, place.text + ": " + text);
  }

  /// Throws an InputError with one line per problem, in the order of the input, if there is any.
  void throw_if_any() {
    if (noted_.empty()) return;
    const auto earlier = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::stable_sort(noted_.begin(), noted_.end(), earlier);
    std::string all;
    for (const auto& [order, line] : noted_) all += (all.empty() ? "" : "\n") + line;
    throw InputError(all);
  }

 private:
  std::vector<std::pair<std::array<std::int64_t, 3>, std::string>> noted_;
};

}  // namespace zenosphere::case_format
