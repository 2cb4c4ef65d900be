#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collapse/dissection.hpp"
#include "collapse/separation_criterion.hpp"
#include "collapse/verdict.hpp"
#include "flow/averages.hpp"
#include "model/field.hpp"
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

  using Separation = SeparationResult;
  Separation separation;

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

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit) {
      visit(Field{"met", "arrest_met"}, self.met);
      visit(Field{"collision", "arrest_collision"}, self.collision);
      visit(Field{"time", "arrest_time"}, self.time);
      visit(Field{"window", "arrest_window"}, self.window);
      visit(Field{"pairs", "arrest_pairs"}, self.pairs);
      visit(Field{"extrapolated_time"}, self.extrapolated_time);
      visit(Field{"flight_ratio"}, self.flight_ratio);
      visit(Field{.name = "others_moving", .may_lack = true}, self.others_moving);
    }
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

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit) {
      visit(Field{"collision"}, self.collision);
      visit(Field{"time"}, self.time);
      visit(Field{"clusters"}, self.clusters);
      visit(Field{"spheres"}, self.spheres);
      visit(Field{"contacts"}, self.contacts);
      visit(Field{"chain"}, self.chain);
      visit(Field{"straightness"}, self.straightness);
      visit(Field{"cycle"}, self.cycle);
      visit(Field{"gap_ratio"}, self.gap_ratio);
      visit(Field{"speed_ratio"}, self.speed_ratio);
      visit(Field{"flight_ratio"}, self.flight_ratio);
      visit(Field{"exact_gap_ratio"}, self.exact_gap_ratio);
      visit(Field{"exact_speed_ratio"}, self.exact_speed_ratio);
      visit(Field{"exact_flight_ratio"}, self.exact_flight_ratio);
      visit(Field{"collapse_time"}, self.collapse_time);
      visit(Field{"collapse_time_error"}, self.collapse_time_error);
    }
  };
  struct Anatomy {
    std::optional<Dissected> hit, arrest;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit) {
      visit(Field{"hit"}, self.hit);
      visit(Field{"arrest"}, self.arrest);
    }
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

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit) {
      visit(Field{"mean_restitution"}, self.mean_restitution);
      visit(Field{"made_elastic"}, self.made_elastic);
      visit(Field{"rotated"}, self.rotated);
    }
  } contact;

  /// A species of the case, with its temperatures in the mean; none where there are no averages.
  struct Kind {
    std::string name;
    std::int64_t spheres = 0;
    std::optional<double> granular_temperature{};    ///< mass (diameter/time)^2
    std::optional<double> rotational_temperature{};  ///< likewise

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor&& visit) {
      visit(Field{"name"}, self.name);
      visit(Field{"spheres"}, self.spheres);
      visit(Field{"granular_temperature"}, self.granular_temperature);
      visit(Field{"rotational_temperature"}, self.rotational_temperature);
    }
  };
  std::vector<Kind> species{};

  std::optional<Averages> averages;  ///< absent where the measured span is empty

  std::optional<std::string> self_check;  ///< what cannot be right, where that ended the run

  double ledger_error = 0;  ///< relative
  double wall_seconds = 0;
  double collisions_per_second = 0;
  std::int64_t peak_memory_bytes = 0;

  /// All of it, in the order of the JSON object: the one list from which JSON, the reading of it
  /// and the columns of a store come.
  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(Field{"collisions", "collisions"}, self.collisions);
    visit(Field{"collisions_per_sphere", "collisions_per_sphere"}, self.collisions_per_sphere);
    visit(Field{"time", "time"}, self.time);
    visit(Field{"strain", "strain"}, self.strain);
    visit(Field{"outcome", "outcome"}, self.outcome);
    visit(Field{"verdict", "verdict"}, self.verdict);
    visit(Field{"separation"}, self.separation);
    visit(Field{"arrest"}, self.arrest);
    visit(Field{"absorbed", "absorbed"}, self.absorbed);
    visit(Field{"averages"}, self.averages);
    visit(Field{"ledger_error", "ledger_error"}, self.ledger_error);
    visit(Field{"wall_seconds", "wall_seconds"}, self.wall_seconds);
    visit(Field{"collisions_per_second"}, self.collisions_per_second);
    visit(Field{"peak_memory_bytes"}, self.peak_memory_bytes);
    visit(Field{"ended_by", "ended_by"}, self.ended_by);
    visit(Field{"overlap_collisions"}, self.overlap_collisions);
    visit(Field{"overlaps_ignored"}, self.overlaps_ignored);
    visit(Field{"receding"}, self.receding);
    visit(Field{.name = "contact", .may_lack = true}, self.contact);
    visit(Field{.name = "anatomy", .may_lack = true}, self.anatomy);
    visit(Field{.name = "self_check", .may_lack = true}, self.self_check);
    visit(Field{.name = "species", .may_lack = true}, self.species);
  }
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
