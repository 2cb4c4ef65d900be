#include "run/adjudicate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <numbers>
#include <optional>
#include <utility>

#include "io/case_words.hpp"
#include "model/errors.hpp"
#include "run/arithmetic.hpp"
#include "run/beginnings.hpp"
#include "run/enclosure.hpp"
#include "run/followed_group.hpp"
#include "run/hit_groups.hpp"
#include "run/judge_group.hpp"
#include "run/rods_certificate.hpp"
#include "run/trial_run.hpp"

namespace zenosphere {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array rules{OverlapRule::rewind, OverlapRule::immediate, OverlapRule::guarded,
                           OverlapRule::stop};

/// What a trial may take of the time that is left: lower precisions only tell how far they see.
constexpr double share_of_highest = 0.75;
constexpr double share_of_others = 0.1;

/// The case of a trial: another precision, with its threshold, and another rule.
Case case_of_trial(Case values, Precision precision, OverlapRule rule) {
  const bool is_scaled = values.collapse.gap_threshold == GapThreshold(values.collision.precision);
  if (is_scaled) values.collapse.gap_threshold = GapThreshold(precision);
  values.collision.precision = precision;
  values.collision.overlap = rule;
  return values;
}

/// Does an adjudication, group after group, as long as there is time.
class Adjudicator {
 public:
  Adjudicator(const Case& values, const AdjudicationLimits& limits)
      : values_(values),
        limits_(limits),
        highest_(
            limits.highest.value_or(std::max(values.collision.precision, Precision::digits(100)))) {
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
    const std::vector<HitGroup> groups = groups_of_run<Dim, Real>();
    if (groups.empty()) return;
    started_ = Clock::now();
    Beginnings<Dim, Real> beginnings(values_, groups, limits_.interrupt);
    for (std::size_t n = 0; n < groups.size(); ++n) {
      if (is_over()) {
        result_.left_out = static_cast<std::int64_t>(groups.size() - n);
        return;
      }
      const Before before = beginnings.before(n);
      announce_ = fmt::format("hits from collision {} on ({} of {}{})", groups[n].first_hit, n + 1,
                              groups.size(), time_for(groups.size() - n, n));
      follow(before);
      if (n == 0) try_other_rules(before);
    }
  }

  /// Does the run once, to see what hits there are.
  template <int Dim, class Real>
  std::vector<HitGroup> groups_of_run() {
    if (limits_.on_trial) limits_.on_trial("looking for separation hits");
    TrialRun<Dim, Real> run(values_);
    run.gather_hits();
    run.go({.collisions = values_.run.collisions.value_or(TrialEnd().collisions),
            .interrupt = limits_.interrupt});
    result_.was_interrupted = run.ended_by() == "interrupted";
    result_.hits = run.hits();
    auto groups = run.hit_groups();
    if (run.arrest().is_met()) mark_arrest(run.arrest(), groups);
    if (groups.empty() && result_.was_interrupted) {
      result_.sentence =
          fmt::format("interrupted at collision {} of the run, before a separation hit was found",
                      run.collisions());
      return {};
    }
    if (groups.empty()) {
      throw InputError(
          fmt::format("no separation hit in {} collisions: there is nothing to adjudicate; raise "
                      "run.collisions or run.time, or choose another case",
                      run.collisions()));
    }
    result_.first_hit = groups.front().first_hit;
    return groups;
  }

  /// Tells the last group of the spheres that repeat in an arrest of it.
  template <int Dim, class Real>
  static void mark_arrest(const ArrestCriterion<Dim, Real>& arrest, std::vector<HitGroup>& groups) {
    const std::int32_t sphere = arrest.pairs().front().first;
    const auto last = std::find_if(groups.rbegin(), groups.rend(), [&](const HitGroup& group) {
      return std::binary_search(group.spheres.begin(), group.spheres.end(), sphere);
    });
    if (last != groups.rend()) last->arrest = arrest.collision();
  }

  /// Follows a group up the ladder, and judges what the highest precision has seen. Where that has
  /// used up its digits without a decision, and the user has not named it, twice as many are tried.
  void follow(const Before& before) {
    std::vector<FollowedGroup> trials;
    std::vector<JudgedApproach> judged;
    for (Precision top = highest_; !is_over(); top = Precision::digits(2 * digits_of(top))) {
      for (const Precision precision : ladder_to(top)) {
        const bool is_known = !trials.empty() && !(trials.back().trial.precision < precision);
        if (is_known || is_over()) continue;
        trials.push_back(followed(before, precision, result_.rule));
        result_.was_interrupted |= trials.back().trial.ended_by == "interrupted";
      }
      if (trials.empty()) return;  // the time has run out in between
      judged = judge_group(before.group, trials);
      const bool may_go_on = !limits_.highest && 2 * digits_of(top) <= most_digits;
      if (!may_go_on || !wants_more_digits(trials.back())) break;
    }
    enclose_first(before, judged);
    result_.approaches.insert(result_.approaches.end(), judged.begin(), judged.end());
    if (!result_.trials.empty()) return;
    for (const FollowedGroup& trial : trials) result_.trials.push_back(trial.trial);
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
        run.go({.collisions = *place, .deadline = deadline, .interrupt = limits_.interrupt});
        return run.collisions() < *place ? std::nullopt
                                         : enclosed(trial, run.gaps(), approach.spheres,
                                                    approach.decades, deadline, limits_.interrupt);
      });
      if (certificate) tell_enclosure(*certificate, *place, approach);
      return;
    }
  }

  static int digits_of(Precision precision) {
    return static_cast<int>(precision.bits() * std::numbers::log10e_v<double> * std::numbers::ln2);
  }

  /// The precisions from the run's own up to the highest, ascending.
  std::vector<Precision> ladder_to(Precision highest) const {
    std::vector<Precision> ladder{Precision::double_precision, Precision::extended, Precision::quad,
                                  Precision::digits(100), highest_};
    for (Precision more = highest_; more < highest; ladder.push_back(more)) {
      more = Precision::digits(2 * digits_of(more));
    }
    ladder.push_back(result_.precision);
    std::erase_if(ladder, [&](Precision one) { return one < result_.precision || highest < one; });
    std::sort(ladder.begin(), ladder.end());
    ladder.erase(std::unique(ladder.begin(), ladder.end()), ladder.end());
    return ladder;
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
    TrialEnd end{.followed = before.group,
                 .deadline = share_of_time(is_highest ? share_of_highest : share_of_others),
                 .interrupt = limits_.interrupt};
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
    if (result_.left_out > 0) {
      result_.sentence += fmt::format(
          "; for {} more groups of hits there was no time (raise --seconds)", result_.left_out);
    }
  }

  const Case& values_;
  const AdjudicationLimits& limits_;
  Precision highest_;
  Clock::time_point deadline_;
  Clock::time_point started_{};  ///< with the first group
  std::string announce_;
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
