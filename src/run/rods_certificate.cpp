#include "run/rods_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/case_box.hpp"
#include "case/case_grains.hpp"
#include "case/case_words.hpp"
#include "proof/certify_rods.hpp"
#include "run/approach_sentence.hpp"
#include "run/judge_group.hpp"

namespace zenosphere {
namespace {

/// With more rods the words are long, and seldom repeat.
constexpr std::int64_t most_rods = 32;
/// A second or two; where a word repeats, it does so within hundreds.
constexpr std::int64_t most_contacts = 5000;

/// Mobile, with one restitution, and of lengths and masses that the case writes down.
bool are_rods_in_decimals(const Case& values) {
  const auto is_mobile = [](const Species& species) { return !species.immobile; };
  return values.contacts.empty() && !values.polydispersity.distribution &&
         std::all_of(values.species.begin(), values.species.end(), is_mobile);
}

bool is_of_rods(const Case& values) {
  const auto& gravity = values.gravity.acceleration;
  const bool falls = std::any_of(gravity.begin(), gravity.end(), [](double g) { return g != 0; });
  const auto& collision = values.collision;
  return values.system.dimension == 1 && values.system.spheres >= 2 &&
         values.system.spheres <= most_rods && values.drive.kind == DriveKind::none &&
         !values.walls.axis && !falls && values.start.arrangement == Arrangement::given &&
         !values.start.granular_temperature && are_rods_in_decimals(values) &&
         collision.restitution_law == RestitutionLaw::constant && collision.contact_duration == 0;
}

/// The shortest decimal text: what the user has written.
std::string decimal(double number) { return fmt::format("{}", number); }

RodsStart start_of_rods(const Case& values) {
  RodsStart start;
  for (const auto& position : values.start.positions) {
    start.positions.push_back(decimal(position.front()));
  }
  for (const auto& velocity : values.start.velocities) {
    start.velocities.push_back(decimal(velocity.front()));
  }
  const Grains<double> grains = grains_of(values);
  for (std::int32_t i = 0; i < values.system.spheres && !grains.are_alike(); ++i) {
    start.lengths.push_back(decimal(grains.diameter(i)));
    start.masses.push_back(decimal(grains.mass(i)));
  }
  start.restitution = decimal(values.system.restitution);
  start.period = decimal(box_sides(values).front());
  return start;
}

/// The digits that two decimals have in common.
std::string common_digits(const std::string& lower, const std::string& upper) {
  const auto end = std::mismatch(lower.begin(), lower.end(), upper.begin(), upper.end()).first;
  return {lower.begin(), end};
}

/// A unit in the last place of a decimal without exponent.
double last_place(const std::string& decimal) {
  const auto point = decimal.find('.');
  return point == std::string::npos
             ? 1
             : std::pow(10.0, -static_cast<double>(decimal.size() - point - 1));
}

std::string sentence_of(const Certificate& certificate) {
  const std::string when =
      certificate.exact.empty()
          ? fmt::format("between {} and {}", certificate.lower, certificate.upper)
          : certificate.exact;
  return fmt::format(
      "in exact fractions the word {} repeats for ever, each round taking at most {:.6g} of the "
      "time "
      "of the one before, and no other rod arrives: infinitely many collisions end at {}",
      certificate.word, certificate.contraction, when);
}

void prove(const Certificate& certificate, Adjudication& adjudication) {
  const auto found = strongest(adjudication.approaches);
  if (found == adjudication.approaches.end()) return;
  JudgedApproach& proven = *found;
  proven.finding = Finding::proven;
  proven.spheres.assign(certificate.spheres.begin(), certificate.spheres.end());
  std::sort(proven.spheres.begin(), proven.spheres.end());
  proven.word = {certificate.word, true};
  const std::string time = common_digits(certificate.lower, certificate.upper);
  // What the trial has extrapolated may have more digits of it.
  if (!proven.collapse_time || !proven.collapse_time->starts_with(time)) {
    proven.collapse_time = time;
    proven.uncertainty = last_place(time);
  }
  proven.sentence = sentence_of(certificate);
}

std::string end_of(const Certificate& certificate, const Case& values) {
  if (certificate.kind == Certificate::Kind::escapes) {
    return fmt::format("no two rods approach each other any more after {} collisions",
                       certificate.collisions);
  }
  return fmt::format("there are {} collisions until run.time = {}, and no more",
                     certificate.collisions, decimal(*values.run.time));
}

/// Only what was followed from the start itself is what the proof is about.
void refute(const std::string& end, Adjudication& adjudication) {
  for (JudgedApproach& one : adjudication.approaches) {
    if (one.followed_from > 0) continue;
    if (one.finding == Finding::near_collapse) {
      one.sentence += fmt::format("; in exact fractions {}", end);
      continue;
    }
    if (one.finding != Finding::singular && one.finding != Finding::undecided) continue;
    refute(one,
           fmt::format("the gaps of {} fall together to 1e-{} as far as {} tells, and grow "
                       "again: in exact fractions {}",
                       count_and_names(one.spheres, "rod"), one.decades, word(one.precision), end));
  }
}

}  // namespace

std::optional<Certificate> certificate_of(const Case& values, const std::atomic<bool>* interrupt) {
  if (!is_of_rods(values)) return std::nullopt;
  RodLimits limits{.contacts = most_contacts};
  limits.interrupt = interrupt;
  if (values.run.time) limits.until = decimal(*values.run.time);
  return certify_rods(start_of_rods(values), limits);
}

void apply(const Certificate& certificate, const Case& values, Adjudication& adjudication) {
  using Kind = Certificate::Kind;
  if (certificate.kind == Kind::proven) prove(certificate, adjudication);
  if (certificate.kind == Kind::escapes || certificate.kind == Kind::finite) {
    refute(end_of(certificate, values), adjudication);
  }
}

}  // namespace zenosphere
