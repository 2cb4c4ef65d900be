#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/case.hpp"

namespace zenosphere {

/// What became of one state, gone on with in one precision under one overlap rule.
struct Trial {
  Precision precision = Precision::double_precision;
  OverlapRule rule = OverlapRule::rewind;
  double gap_threshold = 0;  ///< diameters, scaled to the precision

  std::int64_t collisions = 0;  ///< of the whole run, at the end of the trial
  std::string ended_by;         ///< "arrest", "overlap", "at rest", "collisions", "time"
  std::string time;             ///< at the end, in all digits

  std::int64_t hits = 0;  ///< of the separation criterion
  std::optional<std::int64_t> first_hit;
  std::optional<std::string> first_hit_time;  ///< in all digits
  std::optional<std::int64_t> last_hit;
  std::int64_t absorbed = 0;  ///< collisions that changed no bit of a velocity
  std::optional<std::int64_t> arrest;
  std::optional<std::string> collapse_time;  ///< of a geometric series, in all digits
  std::optional<double> collapse_ratio;      ///< of its flights

  /// Collisions with a gap of 10^-d to 10^-(d-1) diameters before, for d = 1, 2, ...; and those
  /// with a computed gap of zero or less.
  std::vector<std::int64_t> per_decade{};
  std::int64_t without_gap = 0;
};

/// What remains of a separation hit when it is done again with more digits and other rules.
enum class Finding {
  chance_close_pair,        ///< the hit disappears with more digits
  finite_time_singularity,  ///< it stays, and its time converges
  arithmetic_arrest,        ///< the clock stands still because impulses are absorbed, and only then
  undecided
};

struct Adjudication {
  Precision precision = Precision::double_precision;  ///< of the run itself
  OverlapRule rule = OverlapRule::rewind;             ///< likewise
  std::int64_t hit = 0;                               ///< its first hit, a collision
  std::int64_t from = 0;                              ///< the state after so many collisions
  double time_between_collisions = 0;                 ///< of one sphere, mean up to the hit
  std::vector<Trial> trials{};                        ///< the first is the run itself
  Finding finding = Finding::undecided;
  std::string sentence;  ///< the finding with its evidence
};

/// Judges the trials: sets finding and sentence.
void conclude(Adjudication& adjudication);

/// "chance close pair" and so on.
const char* word(Finding finding);

/// One JSON object; a table for people, a line for each trial.
std::string to_json(const Adjudication& adjudication);
std::string to_text(const Adjudication& adjudication);

}  // namespace zenosphere
