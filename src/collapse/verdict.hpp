#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/word_table.hpp"

namespace zenosphere {

/// What gaps, hits, arrests and verdicts of a run mean; in its output file. 1: gaps are those along
/// the shortest image and from where a flight begins, an arrest does not ask how often each pair
/// has met, and a verdict looks at the window only.
inline constexpr std::int64_t criteria_version = 2;

/// What the computation of a run came to, by the two criteria of collapse. Whether the spheres of
/// the model have collapsed is another question: rounding can end a collapse and make one.
enum class Verdict {
  none,       ///< the separation criterion was never met
  temporary,  ///< it was met, and has been left
  open,       ///< it was still being met when the run ended
  arrested,   ///< the arrest criterion was met: a true collapse in the paper's sense
};

/// Its words in files and on the screen.
inline constexpr std::array verdict_words{
    Word{"none", Verdict::none}, Word{"temporary", Verdict::temporary}, Word{"open", Verdict::open},
    Word{"true", Verdict::arrested}};

constexpr const auto& words_of(Verdict) { return verdict_words; }
inline const char* word(Verdict verdict) { return word_in(verdict_words, verdict); }

/// A run, as far as a verdict depends on it.
struct Course {
  std::int64_t collisions = 0;
  double collisions_per_sphere = 0;  ///< a collision has two
  double time = 0;                   ///< since the start
  bool is_at_rest = false;           ///< no collision will ever come
  bool is_arrested = false;          ///< the arrest criterion was met
  std::int64_t window = 0;           ///< of that criterion, collisions

  std::optional<std::int64_t> last_hit;  ///< the last collision that met the separation criterion
  std::optional<double> last_hit_time;   ///< its time; absent: not known
  double longest_pause = 0;              ///< the longest time between two hits
};

/// Whether the last hit lies behind the spheres: because no collision will ever come; or the clock
/// has gone on since for longer than it ever did between two hits, and longer than a sphere flies
/// between two of its collisions, on average over the run; or there were more than a window of
/// collisions since, and one of each sphere on average.
bool is_left(const Course& course);

/// The verdict on a run.
Verdict verdict(const Course& course);

/// The verdict by the rule of versions before the clock was asked: left is what has not been hit
/// for a window of collisions.
Verdict verdict_by_window(const Course& course);

}  // namespace zenosphere
