#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/arrangement.hpp"
#include "model/case_key.hpp"
#include "model/word_table.hpp"

namespace zenosphere {

inline constexpr std::array arrangement_words{
    Word{"fcc", Arrangement::fcc}, Word{"random", Arrangement::random},
    Word{"given", Arrangement::given}, Word{"file", Arrangement::file}};
inline const auto& words_of(Arrangement) { return arrangement_words; }

namespace case_format {

inline constexpr When only_given{
    "start.arrangement", "",
    [](const auto& c) { return c.start.arrangement == Arrangement::given; },
    "start.arrangement = \"given\""};
inline constexpr When only_from_file{
    "start.arrangement", "", [](const auto& c) { return c.start.arrangement == Arrangement::file; },
    "start.arrangement = \"file\""};

/// The table [start]: where the spheres are at first, and how fast.
struct Start {
  Arrangement arrangement = Arrangement::fcc;
  std::optional<double> granular_temperature;  ///< (diameter/time)^2; none: as given
  std::uint64_t seed = 1;
  std::vector<std::vector<double>> positions{};   ///< N x D, for Arrangement::given
  std::vector<std::vector<double>> velocities{};  ///< N x D, laboratory, likewise
  std::string file{};                             ///< for Arrangement::file
  std::optional<std::int64_t> snapshot{};         ///< of the file, from 0; none: the last

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"arrangement", required, any, "how the spheres are placed"}, arrangement);
    visit(CaseKey{"granular_temperature", optional, at_least(0),
                  "variance of each velocity component at the start [diameter^2/time^2]"},
          granular_temperature);
    visit(CaseKey{"seed", optional, at_least(0), "of the random numbers"}, seed);
    visit(CaseKey{"positions", required, any, "one sphere a line [diameters]"}, positions,
          only_given);
    visit(CaseKey{"velocities", optional, any,
                  "one sphere a line, in the laboratory [diameters/time]"},
          velocities, only_given);
    visit(CaseKey{"file", required, any, "extended XYZ or an output file: its last state"}, file,
          only_from_file);
    visit(CaseKey{"snapshot", optional, at_least(0), "of the file, from 0, instead of the last"},
          snapshot, only_from_file);
  }
};

}  // namespace case_format
}  // namespace zenosphere
