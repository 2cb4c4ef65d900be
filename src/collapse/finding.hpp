#pragma once

#include <optional>
#include <vector>

#include "collapse/approach.hpp"
#include "collapse/contact_word.hpp"
#include "collapse/curvature.hpp"

namespace zenosphere {

/// What a close approach of spheres was, from the weakest to the strongest.
enum class Finding {
  undecided,
  chance_close_pair,  ///< two spheres came close once; with more digits their gap is a number
  exact_contact,      ///< zero by symmetry or by the start: no gap has decayed
  near_collapse,      ///< gaps fell together, and grew again before the digits were spent
  arithmetic_arrest,  ///< the clock stands still in the run's precision, and not in a higher one
  singular,           ///< gaps fall by a steady law until the digits are spent
  proven,             ///< singular, with a mathematical proof
};

/// "singular", "near-collapse" and so on, as files and the screen have it.
const char* word(Finding finding);

/// The contraction of a repeating word: what each round takes of the time of the one before.
struct RoundRatio {
  double ratio = 1;
  double change_before = 0;  ///< of the ratio over the second quarter of the rounds
  double change = 0;         ///< likewise over the second half: the ratio converges if it is less
};

/// Whether a ratio settles: a pair of complex eigenvalues, which reopens in the end, lets it drift
/// ever faster.
bool converges(const RoundRatio& ratio);

/// The ratio of rounds at the end of a series, from their durations; nothing below eight of them.
///
/// \param durations  of consecutive rounds of a word, any unit, > 0
std::optional<RoundRatio> round_ratio(const std::vector<double>& durations);

/// What is known of one approach in the highest precision that has seen it.
struct ApproachEvidence {
  ClusterApproach approach{};
  ContactWord word{};
  std::optional<RoundRatio> ratio{};     ///< of a periodic word
  std::optional<Curvature> curvature{};  ///< of the contacts in its steady fall
  double clock_ratio = 0;       ///< time of the last quarter of its fall over the one before
  bool is_dissipative = false;  ///< some contact of the cluster has lost energy
};

/// Whether the time that is left shrinks with the gaps.
bool runs_out_of_time(const ApproachEvidence& evidence);

/// Decades above the limit at which a gap has still so many digits that rounding does not decide
/// what becomes of it.
inline constexpr double digits_to_spare = 4;

/// What the evidence of one approach says: singular, near-collapse, exact contact or undecided.
///
/// *Singular* is a cluster that dissipates, whose gaps fell over at least twenty decades by one
/// law up to the end of the digits (or, in a type with fewer, over half of all it has); a periodic
/// word must contract by a ratio that settles. *Near-collapse*: the gaps grew again with digits to
/// spare, which is where the smallest still had `digits_to_spare`. *Exact contact*: gaps at the
/// limit, and hardly any in the decades above it; whether the spheres or rounding made it so, the
/// caller must know.
Finding judge(const ApproachEvidence& evidence, double limit);

}  // namespace zenosphere
