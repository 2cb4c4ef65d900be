#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "collapse/finding.hpp"
#include "result/ended_by.hpp"

namespace zenosphere {

/// What became of one state, gone on with in one precision under one overlap rule.
struct Trial {
  Precision precision = Precision::double_precision;
  OverlapRule rule = OverlapRule::rewind;
  GapThreshold gap_threshold = 1e-16;  ///< diameters, scaled to the precision

  std::int64_t collisions = 0;  ///< of the whole run, at the end of the trial
  std::optional<EndedBy> ended_by;
  std::string time;  ///< at the end, in all digits

  std::int64_t hits = 0;  ///< of the separation criterion
  std::optional<std::int64_t> first_hit;
  std::optional<std::string> first_hit_time;  ///< in all digits
  std::optional<std::int64_t> last_hit;
  std::int64_t absorbed = 0;  ///< collisions that changed no bit of a velocity
  std::optional<std::int64_t> arrest;
  double deepest = 0;  ///< decades of the smallest gap above the limit of the type
};

/// When the gaps of an approach had fallen by so many decades.
struct Milestone {
  int decade = 0;  ///< of the median gap
  std::int64_t collision = 0;
  std::string time;  ///< in all digits
};

/// Where a lower precision has lost an approach: its digits were spent, or it saw other contacts.
struct Loss {
  Precision precision = Precision::double_precision;
  std::optional<std::int64_t> collision{};  ///< none: it saw all of it
  int decade = 0;                           ///< of the smallest gap up to there
};

/// One approach of a run, judged.
struct JudgedApproach {
  Finding finding = Finding::undecided;
  std::string sentence{};                             ///< the finding with its evidence
  Precision precision = Precision::double_precision;  ///< the highest that saw it
  std::vector<std::int32_t> spheres{};                ///< ascending
  int decades = 0;                                    ///< of the smallest gap
  std::int64_t first_collision = 0;                   ///< of the criterion, in `precision`; or that
  std::string first_time{};                           ///< of the smallest gap, with its time
  std::optional<std::string> collapse_time{};         ///< decimal, to its uncertainty
  std::optional<double> uncertainty{};                ///< of it, from the tail of its series
  ContactWord word{};
  std::optional<RoundRatio> ratio{};
  std::optional<SteadyFall> steady{};
  std::optional<Curvature> curvature{};
  std::optional<double> reopened_to{};  ///< decades of the median gap
  std::optional<int> enclosed_to{};     ///< decades to which the order of contacts is certain
  std::vector<Milestone> milestones{};
  std::vector<Loss> losses{};      ///< one for each precision below
  std::int64_t followed_from = 0;  ///< the collision of the run from whose state it was followed
  std::int64_t run_hit = 0;        ///< the run's first hit that belongs to it, a collision
};

struct Adjudication {
  Precision precision = Precision::double_precision;  ///< of the run itself
  OverlapRule rule = OverlapRule::rewind;             ///< likewise
  std::int64_t hits = 0;                              ///< of the run
  std::optional<std::int64_t> first_hit{};            ///< its first, a collision
  std::vector<JudgedApproach> approaches{};           ///< in the order of the run's hits
  std::int64_t left_out = 0;                          ///< groups of hits that were not followed
  std::int64_t beyond = 0;               ///< of these, the ones behind as many as were asked for
  std::vector<Trial> trials{};           ///< from before the first hit: the first is the run itself
  Finding finding = Finding::undecided;  ///< the strongest of its approaches
  std::string sentence{};
  bool is_without_hits = false;  ///< all of the run was searched, and there is nothing to judge
  bool was_interrupted = false;
};

/// Makes a near-collapse of an approach: its spheres part again, so that there is no collapse time.
void refute(JudgedApproach& approach, std::string sentence);

/// Adds what is not there yet: two groups of hits may lead to the same approach.
void add_distinct(const std::vector<JudgedApproach>& found, std::vector<JudgedApproach>& all);

/// One JSON object; text for people, with a line for each approach and each trial.
std::string to_json(const Adjudication& adjudication);
std::string to_text(const Adjudication& adjudication);

}  // namespace zenosphere
