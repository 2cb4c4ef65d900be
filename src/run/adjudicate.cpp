#include "run/adjudicate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

#include "case/case_words.hpp"
#include "model/errors.hpp"
#include "run/arithmetic.hpp"
#include "run/beginnings.hpp"
#include "run/enclosure.hpp"
#include "run/followed_group.hpp"
#include "run/hit_groups.hpp"
#include "run/judge_group.hpp"
#include "run/precision_ladder.hpp"
#include "run/rods_certificate.hpp"
#include "run/trial_run.hpp"
#include "text/counted.hpp"

namespace zenosphere {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array rules{OverlapRule::rewind, OverlapRule::immediate, OverlapRule::guarded,
                           OverlapRule::stop};

/// What a trial may take of the time that is left: lower precisions only tell how far they see.
constexpr double share_of_highest = 0.75;
constexpr double share_of_others = 0.1;
/// Looking for hits, before any trial.
constexpr double share_of_search = 0.5;

/// Does an adjudication, group after group, as long as there is time.
class Adjudicator {
 public:
  Adjudicator(const Case& values, const AdjudicationLimits& limits)
      : values_(values),
        limits_(limits),
        highest_(limits.highest.value_or(first_judge(values.collision.precision))) {
    const auto seconds = std::chrono::duration<double>(std::min(limits.seconds, 1e9));
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(seconds);
    result_.precision = values.collision.precision;
    result_.rule = values.collision.overlap;
  }

  Adjudication go() {
    in_arithmetic_of(values_, [&]<int Dim, class Real>() { adjudicate_run<Dim, Real>(); });
    const bool may_prove = !result_.approaches.empty();
    const auto certificate = may_prove ? certificate_of(values_, limits_.interrupt) : std::nullopt;
    if (certificate) apply(*certificate, values_, result_);
    conclude();
    return std::move(result_);
  }

 private:
  template <int Dim, class Real>
  void adjudicate_run() {
    std::vector<HitGroup> groups = groups_of_run<Dim, Real>();
    if (groups.empty()) return;
    result_.left_out = static_cast<std::int64_t>(groups.size());
    const std::int64_t asked =
        std::min(result_.left_out, limits_.groups.value_or(result_.left_out));
    result_.beyond = result_.left_out - asked;
    groups.resize(static_cast<std::size_t>(asked));
    started_ = Clock::now();
    Beginnings<Dim, Real> beginnings(values_, groups, surroundings(deadline_));
    for (std::size_t n = 0; n < groups.size(); ++n) {
      const Before before = beginnings.before(n);
      if (is_over()) return;
      announce_ = fmt::format("hits from collision {} on ({} of {}{})", groups[n].first_hit, n + 1,
                              groups.size(), time_for(groups.size() - n, n));
      result_.left_out -= follow(before);
      if (n == 0 && limits_.tries_other_rules) try_other_rules(before);
    }
  }

  /// Does the run once, to see what hits there are.
  template <int Dim, class Real>
  std::vector<HitGroup> groups_of_run() {
    if (limits_.on_trial) limits_.on_trial("looking for separation hits");
    TrialRun<Dim, Real> run(values_);
    run.gather_hits();
    TrialEnd end = surroundings(share_of_time(share_of_search));
    end.collisions = values_.run.collisions.value_or(end.collisions);
    run.go(end);
    result_.was_interrupted = run.ended_by() == EndedBy::interrupted;
    const bool is_cut_off = run.ended_by() == EndedBy::budget;
    if (is_cut_off) searched_ = run.collisions();
    result_.hits = run.hits();
    auto groups = run.hit_groups();
    if (run.arrest().is_met()) {
      mark_arrest(run.arrest().pairs().front().first, *run.arrest().collision(), groups);
    }
    if (groups.empty() && (result_.was_interrupted || is_cut_off)) {
      result_.sentence =
          fmt::format("{} at collision {} of the run, before a separation hit was found",
                      is_cut_off ? "the time for it was over (raise --seconds)" : "interrupted",
                      run.collisions());
      return {};
    }
    if (groups.empty()) {
      result_.is_without_hits = true;
      result_.sentence = fmt::format("no two spheres have met the separation criterion in {}",
                                     counted(run.collisions(), "collision"));
      return {};
    }
    result_.first_hit = groups.front().first_hit;
    return groups;
  }

  /// Follows a group up the ladder, and judges what the highest precision has seen. Where that has
  /// used up its digits without a decision, and the user has not named it, twice as many are tried.
  ///
  /// \return  groups followed: 1, or 0 where there was no time
  int follow(const Before& before) {
    std::vector<FollowedGroup> trials;
    std::vector<JudgedApproach> judged;
    for (std::optional<Precision> top = highest_; top && !is_over(); top = doubled(*top)) {
      for (const Precision precision : precision_ladder(result_.precision, highest_, *top)) {
        const bool is_known = !trials.empty() && !(trials.back().trial.precision < precision);
        if (is_known || is_over()) continue;
        trials.push_back(followed(before, precision, result_.rule));
        result_.was_interrupted |= trials.back().trial.ended_by == EndedBy::interrupted;
      }
      if (trials.empty()) return 0;  // the time has run out in between
      judged = judge_group(before.group, trials);
      if (limits_.highest || !wants_more_digits(trials.back())) break;
    }
    if (trials.empty()) return 0;
    enclose_first(before, judged);
    add_distinct(judged, result_.approaches);
    const bool is_first = result_.trials.empty();
    for (const FollowedGroup& trial : trials) {
      if (is_first) result_.trials.push_back(trial.trial);
    }
    return 1;
  }

  /// Encloses the first singular approach of all, in at most a tenth of the time that is left.
  void enclose_first(const Before& before, std::vector<JudgedApproach>& judged) {
    if (has_enclosed_) return;
    for (JudgedApproach& approach : judged) {
      const auto place = place_to_enclose(values_, approach);
      if (!place) continue;
      has_enclosed_ = true;
      const auto deadline = share_of_time(share_of_others);
      const Case trial = case_of_trial(values_, approach.precision, result_.rule);
      const auto certificate = in_arithmetic_of(trial, [&]<int Dim, class Real>() {
        TrialRun<Dim, Real> run = beginning<Dim, Real>(before, trial);
        TrialEnd end = surroundings(deadline);
        end.collisions = *place;
        run.go(end);
        return run.collisions() < *place ? std::nullopt
                                         : enclosed(trial, run.gaps(), approach.spheres,
                                                    approach.decades, deadline, limits_.interrupt);
      });
      if (certificate) tell_enclosure(*certificate, *place, approach);
      return;
    }
  }

  /// What the other rules make of the first group in the run's own precision.
  void try_other_rules(const Before& before) {
    for (const OverlapRule rule : rules) {
      if (rule == result_.rule || is_over()) continue;
      result_.trials.push_back(followed(before, result_.precision, rule).trial);
    }
  }

  FollowedGroup followed(const Before& before, Precision precision, OverlapRule rule) {
    const Case trial = case_of_trial(values_, precision, rule);
    if (limits_.on_trial) {
      limits_.on_trial(fmt::format("{}, {}, {}; {:.0f} s left", announce_, word(precision),
                                   word(rule), std::max(0.0, seconds(deadline_ - Clock::now()))));
    }
    return in_arithmetic_of(
        trial, [&]<int Dim, class Real>() { return followed_in<Dim, Real>(before, trial); });
  }

  /// The state, promoted; a start that the case writes is read in the precision of the trial.
  template <int Dim, class Real>
  static TrialRun<Dim, Real> beginning(const Before& before, const Case& values) {
    const bool is_written = values.start.arrangement == Arrangement::given;
    if (before.collisions == 0 && is_written) return TrialRun<Dim, Real>(values);
    ArchiveReader state(before.state);
    if (before.bits < significand_bits<Real>()) state.promote_from(before.bits);
    return TrialRun<Dim, Real>(values, state);
  }

  template <int Dim, class Real>
  FollowedGroup followed_in(const Before& before, const Case& values) {
    TrialRun<Dim, Real> trial = beginning<Dim, Real>(before, values);
    const auto gaps = trial.gaps();
    trial.keep_collisions();
    const bool is_highest = !(values.collision.precision < highest_);
    TrialEnd end = surroundings(share_of_time(is_highest ? share_of_highest : share_of_others));
    end.followed = before.group;
    if (limits_.collisions) end.collisions = before.group.first_hit + *limits_.collisions;
    trial.go(end);
    FollowedGroup followed{
        .trial = trial.trial(),
        .limit = trial.limit(),
        .begin = {before.collisions},
        .first_number = trial.kept().first_number,
        .rows = trial.kept().rows,
        .seen = approaches_seen(trial.kept(), trial.limit(), trial.spheres(), before.group)};
    if (before.collisions == 0) return followed;  // what touches there does so by the case
    followed.begin.depth = gaps.smallest(before.group.spheres, trial.limit());
    for (SeenApproach& seen : followed.seen) {
      seen.begin_depth = gaps.smallest(seen.spheres, trial.limit());
    }
    return followed;
  }

  /// What ends a trial from outside.
  TrialEnd surroundings(Clock::time_point deadline) const {
    return {.deadline = deadline, .interrupt = limits_.interrupt, .on_look = limits_.on_look};
  }

  /// The moment at which a share of the time that is left will be over.
  Clock::time_point share_of_time(double share) const {
    const auto now = Clock::now();
    return now + std::chrono::duration_cast<Clock::duration>((deadline_ - now) * share);
  }

  static double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
  }

  /// What the groups that are left will take, if they take as long as those before have.
  std::string time_for(std::size_t left, std::size_t done) const {
    if (done == 0) return "";
    const double each = seconds(Clock::now() - started_) / static_cast<double>(done);
    return fmt::format(", {:.0f} s for the rest", each * static_cast<double>(left));
  }

  bool is_over() const { return result_.was_interrupted || Clock::now() > deadline_; }

  /// The strongest of the findings, and how many there are of each.
  void conclude() {
    if (result_.approaches.empty()) {
      if (result_.sentence.empty()) {
        result_.sentence = result_.was_interrupted ? "interrupted before any hit was followed"
                                                   : "there was no time to follow any hit";
      }
      return;
    }
    const JudgedApproach& first = *strongest(result_.approaches);
    result_.finding = first.finding;
    result_.sentence = first.sentence;
    if (const std::int64_t late = result_.left_out - result_.beyond; late > 0) {
      result_.sentence +=
          fmt::format("; for {} more groups of hits there was no time (raise --seconds)", late);
    }
    if (result_.beyond > 0) {
      result_.sentence += fmt::format("; {} more groups of hits were not asked for (--groups {})",
                                      result_.beyond, limits_.groups.value_or(0));
    }
    if (searched_) {
      result_.sentence += fmt::format(
          "; hits after collision {} were not looked for (raise --seconds)", *searched_);
    }
  }

  const Case& values_;
  const AdjudicationLimits& limits_;
  Precision highest_;
  Clock::time_point deadline_;
  Clock::time_point started_{};  ///< with the first group
  std::string announce_;
  std::optional<std::int64_t> searched_{};  ///< the collision up to which there was time to look
  bool has_enclosed_ = false;
  Adjudication result_;
};

}  // namespace

Adjudication adjudicate(const Case& values, const AdjudicationLimits& limits) {
  if (limits.highest && *limits.highest < values.collision.precision) {
    throw InputError(fmt::format(
        "the run is in {} already, and digits cannot be taken away; choose a higher --up-to",
        word(values.collision.precision)));
  }
  return Adjudicator(values, limits).go();
}

}  // namespace zenosphere
