#pragma once

#include <array>
#include <optional>

#include "model/word_table.hpp"

namespace zenosphere {

/// What has ended a run, or a trial of an adjudication.
enum class EndedBy {
  collisions,   ///< the limit of the case, or of the adjudication
  time,         ///< the limit of the case
  arrest,       ///< the arrest criterion was met
  overlap,      ///< the overlap rule `stop`
  at_rest,      ///< no collision will ever come
  clock,        ///< the next collision is beyond the end of the clock
  idle,         ///< no spheres have met for too long
  signal,       ///< from outside, or before its end by the one who drives it piece by piece
  self_check,   ///< something that cannot be right
  wall_time,    ///< the limit of a sweep
  digits,       ///< those of the followed spheres are spent; from here on trials only
  apart,        ///< the followed spheres have flown apart
  others,       ///< other spheres have spent the digits
  budget,       ///< the time for the adjudication is over
  interrupted,  ///< from outside
};

inline constexpr std::array ended_by_words{Word{"collisions", EndedBy::collisions},
                                           Word{"time", EndedBy::time},
                                           Word{"arrest", EndedBy::arrest},
                                           Word{"overlap", EndedBy::overlap},
                                           Word{"at rest", EndedBy::at_rest},
                                           Word{"clock", EndedBy::clock},
                                           Word{"idle", EndedBy::idle},
                                           Word{"signal", EndedBy::signal},
                                           Word{"self-check", EndedBy::self_check},
                                           Word{"wall time", EndedBy::wall_time},
                                           Word{"digits", EndedBy::digits},
                                           Word{"apart", EndedBy::apart},
                                           Word{"others", EndedBy::others},
                                           Word{"budget", EndedBy::budget},
                                           Word{"interrupted", EndedBy::interrupted}};

constexpr const auto& words_of(EndedBy) { return ended_by_words; }

/// As files have it: no word where nothing has ended it yet.
inline const char* word(const std::optional<EndedBy>& ended_by) {
  return ended_by ? word_in(ended_by_words, *ended_by) : "";
}

/// How a run came to its end.
enum class Outcome {
  unfinished,   ///< it has not ended: in a checkpoint, or between two pieces
  finished,     ///< a limit of the case, or nothing more can happen
  collapsed,    ///< the arrest criterion was met, and the case stops there
  interrupted,  ///< from outside, or by a self-check
};

inline constexpr std::array outcome_words{
    Word{"unfinished", Outcome::unfinished}, Word{"finished", Outcome::finished},
    Word{"collapsed", Outcome::collapsed}, Word{"interrupted", Outcome::interrupted}};

constexpr const auto& words_of(Outcome) { return outcome_words; }
inline const char* word(Outcome outcome) { return word_in(outcome_words, outcome); }

/// What came of a run that was ended so.
constexpr Outcome outcome_of(const std::optional<EndedBy>& ended_by) {
  if (!ended_by) return Outcome::unfinished;
  if (*ended_by == EndedBy::arrest) return Outcome::collapsed;
  const bool is_interrupted = *ended_by == EndedBy::signal || *ended_by == EndedBy::self_check ||
                              *ended_by == EndedBy::wall_time;
  return is_interrupted ? Outcome::interrupted : Outcome::finished;
}

}  // namespace zenosphere
