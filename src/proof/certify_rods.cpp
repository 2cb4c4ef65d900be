#include "proof/certify_rods.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "model/repeated_round.hpp"
#include "proof/letters.hpp"
#include "proof/rational_eigenvalue.hpp"
#include "proof/round_of_contacts.hpp"

namespace zenosphere {

namespace {

using Kind = Certificate::Kind;

/// Neighbouring letters whose contacts repeat.
struct Row {
  std::vector<int> letters;  ///< of the whole line, from left to right
  std::vector<int> word;     ///< by their place in `letters`
};

/// The row around the last contact, from as few contacts back as show three rounds.
std::optional<Row> row_around_last(std::span<const int> history, int period) {
  for (std::size_t window = 6; window / 2 < history.size(); window *= 2) {
    const auto recent = history.last(std::min(window, history.size()));
    Row row{letters_around_last(recent, period), {}};
    if (row.letters.size() < 2) continue;
    std::vector<int> places;
    for (const int letter : recent) {
      const auto place = std::find(row.letters.begin(), row.letters.end(), letter);
      if (place != row.letters.end())
        places.push_back(static_cast<int>(place - row.letters.begin()));
    }
    auto word = round_at_end(places);
    if (!word) continue;
    // A letter that was met earlier in the window only is no longer in the row.
    const auto [least, greatest] = std::minmax_element(word->begin(), word->end());
    const int shift = *least;
    row.letters = {row.letters.begin() + *least, row.letters.begin() + *greatest + 1};
    for (int& letter : *word) letter -= shift;
    row.word = std::move(*word);
    return row;
  }
  return std::nullopt;
}

RowState state_of(const ExactRods& rods, const Row& row) {
  RowState state;
  for (const int letter : row.letters) {
    state.c.emplace_back(rods.constants()[letter]);
    state.u.emplace_back(rods.slopes()[letter]);
  }
  return state;
}

/// A round that repeats for ever, and how long that takes.
struct Collapse {
  RoundOfContacts round;
  InvariantCone slopes;
  InvariantCone pairs;
  Rational contraction;  ///< of what remains, per round
  Rational duration;     ///< of the first round, over (height of pairs) / (height of slopes)^2

  /// From the state after any number of rounds.
  Enclosure end_after(const RowState& state) const {
    const Rational height = slopes.height(state.u);
    const Rational unit = pairs.height(state.pairs()) / (height * height);
    const Rational now = state.contact_time(round.last_letter());
    return {now, now + unit * duration / (1 - contraction)};
  }
};

std::optional<Collapse> proven_collapse(const Row& row, const RowState& state,
                                        const Rational& restitution,
                                        const std::vector<Integer>& masses) {
  // Where small eigenvalues are complex, a few rounds at once shrink in every direction.
  for (const int repeats : {1, 2, 4, 8}) {
    std::vector<int> word;
    for (int k = 0; k < repeats; ++k) word.insert(word.end(), row.word.begin(), row.word.end());
    RoundOfContacts round(word, static_cast<int>(row.letters.size()), restitution, masses);
    const auto slopes = InvariantCone::around(state.u, round.map());
    const auto pairs = InvariantCone::around(state.pairs(), round.map_of_pairs());
    if (!slopes || !pairs || !round.holds_in(*slopes, *pairs)) continue;
    const Rational slowest = slopes->growth().lower;
    const Rational contraction = pairs->growth().upper / (slowest * slowest);
    if (contraction >= 1) continue;
    const Rational duration = round.longest_duration(*slopes, *pairs);
    return Collapse{std::move(round), *slopes, *pairs, contraction, duration};
  }
  return std::nullopt;
}

/// So many further rounds that the enclosure is as narrow as asked, or as the limit of bits allows.
long rounds_for(const Collapse& collapse, const Rational& width, const RodLimits& limits) {
  const double left = decimal_exponent(width) + 1 + limits.digits;
  const double per_round = -std::log10(collapse.contraction.get_d());
  double bits = 1;
  for (const RationalVector& line : collapse.round.map()) {
    for (const Rational& value : line) {
      bits = std::max(bits, static_cast<double>(mpz_sizeinbase(value.get_den_mpz_t(), 2)));
    }
  }
  const double most = static_cast<double>(limits.bits) / bits;
  return std::lround(std::clamp(std::ceil(left / per_round), 0.0, most));
}

/// No rod beside the row reaches it before the end, whatever it meets outside.
bool is_undisturbed(const ExactRods& rods, const Row& row, const Rational& end) {
  const Rational reach = (end - rods.now()) * rods.velocity_range();
  for (const int edge : {row.letters.front(), row.letters.back()}) {
    for (const int beside : rods.neighbours(edge)) {
      const bool is_inside =
          std::find(row.letters.begin(), row.letters.end(), beside) != row.letters.end();
      if (!is_inside && rods.gap(beside) <= reach) return false;
    }
  }
  return true;
}

std::vector<int> spheres_of(const ExactRods& rods, const Row& row) {
  std::vector<int> spheres;
  for (const int letter : row.letters) spheres.push_back(rods.rod(letter));
  spheres.push_back(rods.rod(row.letters.back() + 1));
  return spheres;
}

std::optional<Certificate> proof(const ExactRods& rods, const Row& row, const RodLimits& limits) {
  const RowState state = state_of(rods, row);
  const auto collapse =
      proven_collapse(row, state, rods.restitution(),
                      rods.masses_from(row.letters.front(), row.letters.size() + 1));
  if (!collapse) return std::nullopt;
  Enclosure end = collapse->end_after(state);
  const long rounds = rounds_for(*collapse, end.upper - end.lower, limits);
  end = collapse->end_after(collapse->round.after(state, rounds));
  if (!is_undisturbed(rods, row, end.upper)) return std::nullopt;
  const int places = places_for(end.upper - end.lower);
  Certificate certificate{.kind = Kind::proven, .word = text_of_letters(first_rotation(row.word))};
  certificate.spheres = spheres_of(rods, row);
  certificate.lower = decimal_below(end.lower, places);
  certificate.upper = decimal_above(end.upper, places);
  certificate.contraction = collapse->contraction.get_d();
  const auto exact =
      rational_collapse_time(collapse->round.map(), collapse->slopes.growth(), state);
  if (exact) certificate.exact = exact->get_str();
  certificate.reason =
      "the word " + certificate.word +
      " repeats for ever: an invariant cone of velocities and one of gaps hold its order, "
      "and what remains shrinks by a constant factor a round";
  return certificate;
}

/// The exact run, and what it comes to.
class RodProof {
 public:
  RodProof(const RodsStart& start, const RodLimits& limits) : rods_(start), limits_(limits) {
    if (!limits.until.empty()) until_ = exact_number(limits.until);
  }

  Certificate conclude() {
    while (static_cast<std::int64_t>(history_.size()) < limits_.contacts) {
      const ExactRods::Event event = rods_.next_event();
      if (event == ExactRods::Event::none_left) return escaped();
      if (until_ && rods_.is_after(*until_)) return finished();
      if (event == ExactRods::Event::exact_contact) return touched();
      history_.push_back(rods_.letter());
      if (limits_.interrupt && *limits_.interrupt) return given_up("interrupted");
      if (static_cast<std::int64_t>(history_.size()) < next_attempt_) continue;
      next_attempt_ += std::max<std::int64_t>(1, next_attempt_ / 8);
      if (auto certificate = attempt()) return *certificate;
      if (has_too_many_bits()) return given_up("the numbers have become too long");
    }
    return given_up("no proof within the limit of contacts");
  }

 private:
  std::optional<Certificate> attempt() {
    const auto row = row_around_last(history_, rods_.is_periodic() ? rods_.letters() : 0);
    if (!row) return std::nullopt;
    word_ = text_of_letters(first_rotation(row->word));
    auto certificate = proof(rods_, *row, limits_);
    if (certificate) certificate->collisions = static_cast<std::int64_t>(history_.size());
    return certificate;
  }

  bool has_too_many_bits() const {
    const auto bits = [](const Integer& z) { return mpz_sizeinbase(z.get_mpz_t(), 2); };
    std::size_t most = 0;
    for (const Integer& value : rods_.slopes()) most = std::max(most, bits(value));
    return static_cast<std::int64_t>(most) > limits_.bits;
  }

  Certificate ended(Kind kind, const std::string& reason) const {
    Certificate certificate{.kind = kind, .word = word_};
    certificate.collisions = static_cast<std::int64_t>(history_.size());
    certificate.reason = reason;
    return certificate;
  }
  Certificate escaped() const {
    return ended(Kind::escapes, "no two rods approach each other after " +
                                    std::to_string(history_.size()) + " contacts");
  }
  Certificate finished() const {
    return ended(Kind::finite, std::to_string(history_.size()) + " contacts until " +
                                   limits_.until + ", and no more");
  }
  Certificate touched() const {
    const int letter = rods_.letter();
    return ended(Kind::exact_contact,
                 "rods " + std::to_string(rods_.rod(letter)) + " and " +
                     std::to_string(rods_.rod(letter + 1)) + " meet after " +
                     std::to_string(history_.size()) +
                     " contacts at the very instant at which a third one touches them");
  }
  Certificate given_up(const std::string& why) const {
    std::string reason = why + " (" + std::to_string(history_.size()) + ")";
    if (rods_.has_simultaneous_contacts()) {
      reason += "; separate pairs meet at one instant exactly, which the proof does not cover";
    }
    return ended(Kind::none, reason);
  }

  ExactRods rods_;
  RodLimits limits_;
  std::optional<Rational> until_;
  std::vector<int> history_;
  std::int64_t next_attempt_ = 6;
  std::string word_;
};

}  // namespace

Certificate certify_rods(const RodsStart& start, const RodLimits& limits) {
  return RodProof(start, limits).conclude();
}

}  // namespace zenosphere
