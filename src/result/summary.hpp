#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collapse/dissection.hpp"
#include "collapse/verdict.hpp"
#include "flow/averages.hpp"
#include "result/ended_by.hpp"

namespace zenosphere {

/// What a run came to, in plain numbers: the content of `--json`, of `info`, and of the
/// dataset /zenosphere/summary of an output file.
///
/// Units: diameter = mass = 1, times in the case's unit. Tensors are row-major, D x D.
struct Summary {
  std::int64_t collisions = 0;
  double collisions_per_sphere = 0;
  double time = 0;
  double strain = 0;
  Outcome outcome = Outcome::unfinished;
  std::optional<EndedBy> ended_by;  ///< none: it is unfinished
  Verdict verdict = Verdict::none;

  struct Separation {
    std::int64_t hits = 0;
    std::optional<std::int64_t> first_collision;
    std::optional<double> first_time;
    std::optional<std::int64_t> last_collision;
    std::optional<double> last_time;  ///< absent from files of older versions
    double longest_pause = 0;         ///< the longest time between two hits
  } separation;

  struct Arrest {
    bool met = false;
    std::optional<std::int64_t> collision;
    std::optional<double> time;
    std::int64_t window = 0;
    std::vector<std::pair<std::int64_t, std::int64_t>> pairs;
    std::optional<double> extrapolated_time;  ///< end of a geometric series of flights, if one
    std::optional<double> flight_ratio;       ///< its ratio
    /// Spheres of none of these pairs that still moved at the end of the run.
    std::optional<std::int64_t> others_moving;
  } arrest;

  /// The first cluster of a dissection, in short; the output file has all of it.
  struct Dissected {
    std::int64_t collision = 0;
    double time = 0;
    std::int64_t clusters = 0;
    std::int64_t spheres = 0;
    std::int64_t contacts = 0;
    std::vector<std::int64_t> chain;
    double straightness = 1;  ///< distance of the chain's ends / its length
    double cycle = 0;         ///< collisions until the same pair comes again
    std::optional<double> gap_ratio, speed_ratio, flight_ratio;  ///< per collision
    std::optional<double> exact_gap_ratio, exact_speed_ratio, exact_flight_ratio;  ///< of a chain
    std::optional<double> collapse_time, collapse_time_error;                      ///< extrapolated
  };
  struct Anatomy {
    std::optional<Dissected> hit, arrest;
  } anatomy;

  std::int64_t absorbed = 0;            ///< collisions that changed no bit of any velocity
  std::int64_t overlap_collisions = 0;  ///< collisions of a pair that overlapped while approaching
  std::int64_t overlaps_ignored = 0;    ///< predictions that `guarded` let pass
  std::int64_t receding = 0;            ///< contacts that rounding had turned into recession

  /// What the law of restitution and the contact models came to.
  struct Contact {
    std::optional<double> mean_restitution;  ///< of the collisions of two spheres
    std::int64_t made_elastic = 0;           ///< collisions that the TC model made elastic
    std::int64_t rotated = 0;                ///< collisions with the relative velocity turned
  } contact;

  /// A species of the case, with its temperatures in the mean; none where there are no averages.
  struct Kind {
    std::string name;
    std::int64_t spheres = 0;
    std::optional<double> granular_temperature{};    ///< mass (diameter/time)^2
    std::optional<double> rotational_temperature{};  ///< likewise
  };
  std::vector<Kind> species{};

  std::optional<Averages> averages;  ///< absent where the measured span is empty

  std::optional<std::string> self_check;  ///< what cannot be right, where that ended the run

  double ledger_error = 0;  ///< relative
  double wall_seconds = 0;
  double collisions_per_second = 0;
  std::int64_t peak_memory_bytes = 0;
};

/// What a verdict depends on.
Course course_of(const Summary& summary);

/// The verdict in one sentence or two, for a reader who has not read the paper.
std::string verdict_sentence(const Summary& summary);

/// What a summary says of the anatomy of a collapse.
Summary::Anatomy in_short(const Anatomy& anatomy);

/// One JSON object on one line, keys as in docs/summary.md; absent values are null.
std::string to_json(const Summary& summary, int dimension);

/// The summary that such a text describes.
///
/// Throws InputError if it is not one of D dimensions, as in a damaged file.
Summary summary_from_json(const std::string& text, int dimension);

/// The summary for people: some lines of aligned text, the verdict first; of a run that was
/// interrupted that it was, and how it goes on.
///
/// \param kept  the output file, which can be resumed; empty: there is none
std::string to_text(const Summary& summary, int dimension, const std::string& kept = "");

}  // namespace zenosphere
