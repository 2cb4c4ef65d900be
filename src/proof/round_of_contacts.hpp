#pragma once

#include <optional>
#include <vector>

#include "proof/invariant_cone.hpp"
#include "proof/rational_matrix.hpp"

namespace zenosphere {

/// A row of rods after the last contact of a round: gap i is c_i + u_i t.
struct RowState {
  RationalVector c;
  RationalVector u;

  /// Their minors c_i u_j - c_j u_i, i < j.
  RationalVector pairs() const { return minors(c, u); }
  /// When gap `letter` is zero.
  Rational contact_time(int letter) const { return -c[letter] / u[letter]; }
};

/// One round of a word of contacts, as a linear map, and what has to hold for it to take place.
///
/// Of u only directions count, of c only the minors w_ij = c_i u_j - u_i c_j: the gap i at the time
/// of contact at letter j is w_ij / u_j. So "j is next" means u_j < 0 and w_ij < 0 for all other i,
/// and the flight from a contact at i to the next one at j takes w_ij / (u_i u_j). Proof in
/// docs/decisions/0019.
class RoundOfContacts {
 public:
  /// The state is that after the last letter of the word.
  ///
  /// \param word         letters 0 to letters - 1 in their order
  /// \param restitution  in (0, 1]
  /// \param masses       of the rods, letters + 1, up to a factor; empty: equal
  RoundOfContacts(const std::vector<int>& word, int letters, const Rational& restitution,
                  const std::vector<Integer>& masses = {});

  const RationalMatrix& map() const { return map_; }
  const RationalMatrix& map_of_pairs() const { return map_of_pairs_; }
  int last_letter() const { return last_letter_; }
  RowState after(const RowState& state, long rounds) const;

  /// All contacts of the round take place in its order for all u and all minors in these cones.
  bool holds_in(const InvariantCone& slopes, const InvariantCone& pairs) const;
  /// An upper bound of the time that the round takes, over (height of pairs) / (height of
  /// slopes)^2.
  Rational longest_duration(const InvariantCone& slopes, const InvariantCone& pairs) const;

 private:
  struct Contact {
    RationalVector approach;            ///< -u_j, a form of u before the round
    RationalVector recession;           ///< u_i of the letter i of the contact before
    RationalVector flight;              ///< -w_ij of that letter
    std::vector<RationalVector> order;  ///< -w_ij of all letters i but j, forms of the minors
  };
  void add_contact(int letter, const RationalMatrix& step);

  RationalMatrix map_;
  RationalMatrix map_of_pairs_;
  int last_letter_;
  std::vector<Contact> contacts_;
};

/// The map of u and c at one contact; masses as above.
RationalMatrix contact_map(int letter, int letters, const Rational& restitution,
                           const std::vector<Integer>& masses = {});

}  // namespace zenosphere
