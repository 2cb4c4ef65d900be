#include "run/approach_sentence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/case_words.hpp"

namespace zenosphere {
namespace {

std::string law_of(const JudgedApproach& judged) {
  std::string law;
  if (judged.steady) {
    law = fmt::format("{:.0f} decades by one law, {:.3g} decades a collision",
                      judged.steady->decades, judged.steady->per_collision);
  }
  if (judged.word.is_periodic && judged.ratio) {
    law += fmt::format(
        "{}contacts repeat in the order {}, each round in {:.6g} of the time of the "
        "one before",
        law.empty() ? "" : "; ", judged.word.letters, judged.ratio->ratio);
  }
  return law;
}

/// A time in as many digits as a sentence bears.
std::string shortened(const std::string& time) {
  constexpr std::size_t most = 48;
  return time.size() > most ? time.substr(0, most) + "..." : time;
}

/// Whether a fall by the same law can go on for ever.
std::string end_of_law(const JudgedApproach& judged) {
  if (!judged.curvature) return "";
  const auto decade = gives_way_at(*judged.curvature);
  if (!decade) {
    return ". The row straightens faster than it closes (the curvature of the contacts dies out): "
           "nothing seen here ends the fall";
  }
  const std::string end = fmt::format(
      ". But the row straightens more slowly than it closes (the curvature of the contacts grows), "
      "which opens the gaps again near 1e-{:.0f}",
      *decade);
  int digits = 200;
  while (digits < *decade + digits_to_spare && digits < most_digits) digits *= 2;
  return digits < most_digits ? fmt::format("{}: --up-to digits{} would show", end, digits) : end;
}

/// What leaves an approach undecided.
std::string doubt_of(const JudgedApproach& judged, const ApproachEvidence& evidence,
                     const std::string& who) {
  const ClusterApproach& approach = evidence.approach;
  const std::string precision = word(judged.precision);
  if (approach.reopened_to) {
    return fmt::format(
        "the gaps of {} fall to 1e-{}, where the digits of {} end, and grow again: more digits "
        "would tell whether rounding has done that",
        who, judged.decades, precision);
  }
  if (!approach.is_spent) {
    return fmt::format(
        "the gaps of {} were still falling at 1e-{} when the trial in {} ended; more digits, "
        "--seconds or --collisions would decide",
        who, judged.decades, precision);
  }
  if (judged.ratio && !converges(*judged.ratio)) {
    return fmt::format(
        "the gaps of {} fall until the digits of {} are spent, but the ratio of their rounds "
        "({:.6g})"
        " still drifts: more digits would tell whether it stays below one",
        who, precision, judged.ratio->ratio);
  }
  if (!runs_out_of_time(evidence)) {
    return fmt::format(
        "the gaps of {} fall until the digits of {} are spent, but the time between their contacts "
        "does not fall with them: more digits would tell whether they fly apart",
        who, precision);
  }
  return fmt::format(
      "the gaps of {} fall until the digits of {} are spent, by one law over {:.0f} decades only; "
      "more digits would decide",
      who, precision, judged.steady ? judged.steady->decades : 0.0);
}

}  // namespace

std::string count_and_names(const std::vector<std::int32_t>& spheres, std::string_view one) {
  constexpr std::size_t most = 6;
  std::string names;
  for (std::size_t k = 0; k < std::min(spheres.size(), most); ++k) {
    names += fmt::format("{}{}", k == 0 ? "" : "-", spheres[k]);
  }
  return fmt::format("{} {}{} ({}{})", spheres.size(), one, spheres.size() == 1 ? "" : "s", names,
                     spheres.size() > most ? "-..." : "");
}

std::string sentence_of(const JudgedApproach& judged, const ApproachEvidence& evidence) {
  const std::string who = count_and_names(judged.spheres);
  const std::string precision = word(judged.precision);
  switch (judged.finding) {
    case Finding::singular:
      return fmt::format(
          "the gaps of {} fall to 1e-{}, as far as the digits of {} go, and energy is lost: {}. If "
          "they go on so, infinitely many collisions {}{}{}",
          who, judged.decades, precision, law_of(judged),
          judged.collapse_time
              ? fmt::format("end at {} +- {:.1g}", shortened(*judged.collapse_time),
                            judged.uncertainty.value_or(0))
              : std::string("take a finite time, whose end could not be extrapolated"),
          end_of_law(judged),
          judged.reopened_to
              ? ". Behind the last digit they grow again, by the overlap rule or, as "
                "more digits might show, by themselves"
              : "");
    case Finding::near_collapse:
      return fmt::format(
          "the gaps of {} fall together to 1e-{} and grow again, half of them to 1e-{} and more, "
          "with digits of {} to spare",
          who, judged.decades, whole(judged.reopened_to.value_or(0)), precision);
    case Finding::exact_contact:
      return fmt::format(
          "gaps of {} are zero in {} without having decayed: contact by symmetry or by the start",
          who, precision);
    default:
      return doubt_of(judged, evidence, who);
  }
}

}  // namespace zenosphere
