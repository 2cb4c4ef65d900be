#include "proof/round_of_contacts.hpp"

namespace zenosphere {

namespace {

RationalVector opposite(RationalVector form) {
  for (Rational& value : form) value = -value;
  return form;
}

}  // namespace

RationalMatrix contact_map(int letter, int letters, const Rational& restitution,
                           const std::vector<Integer>& masses) {
  RationalMatrix map = identity_matrix(static_cast<std::size_t>(letters));
  const Integer left = masses.empty() ? Integer(1) : masses[letter];
  const Integer right = masses.empty() ? Integer(1) : masses[letter + 1];
  const Rational share = (1 + restitution) / Rational(left + right);
  map[letter][letter] = -restitution;
  if (letter > 0) map[letter - 1][letter] = share * right;
  if (letter + 1 < letters) map[letter + 1][letter] = share * left;
  return map;
}

RoundOfContacts::RoundOfContacts(const std::vector<int>& word, int letters,
                                 const Rational& restitution, const std::vector<Integer>& masses)
    : map_(identity_matrix(static_cast<std::size_t>(letters))),
      map_of_pairs_(exterior_square(map_)),
      last_letter_(word.back()) {
  for (const int letter : word) {
    add_contact(letter, contact_map(letter, letters, restitution, masses));
  }
}

void RoundOfContacts::add_contact(int letter, const RationalMatrix& step) {
  const std::size_t size = map_.size();
  const auto j = static_cast<std::size_t>(letter);
  const auto before = static_cast<std::size_t>(last_letter_);
  Contact contact{opposite(map_[j]), map_[before], {}, {}};
  for (std::size_t i = 0; i < size; ++i) {
    if (i == j) continue;
    // Row (i, j) of the minors is c_i u_j - c_j u_i, which is w_ij; row (j, i) is its opposite.
    const RationalVector form = i < j ? opposite(map_of_pairs_[minor_index(i, j, size)])
                                      : map_of_pairs_[minor_index(j, i, size)];
    if (i == before) contact.flight = form;
    contact.order.push_back(form);
  }
  contacts_.push_back(std::move(contact));
  map_ = product(step, map_);
  map_of_pairs_ = product(exterior_square(step), map_of_pairs_);
  last_letter_ = letter;
}

RowState RoundOfContacts::after(const RowState& state, long rounds) const {
  const RationalMatrix map = power(map_, rounds);
  return {product(map, state.c), product(map, state.u)};
}

bool RoundOfContacts::holds_in(const InvariantCone& slopes, const InvariantCone& pairs) const {
  for (const Contact& contact : contacts_) {
    if (contact.flight.empty()) return false;  // the same letter twice in a row
    if (slopes.range(contact.approach).lower <= 0) return false;
    if (slopes.range(contact.recession).lower <= 0) return false;
    for (const RationalVector& form : contact.order) {
      if (pairs.range(form).lower <= 0) return false;
    }
  }
  return true;
}

Rational RoundOfContacts::longest_duration(const InvariantCone& slopes,
                                           const InvariantCone& pairs) const {
  Rational sum;
  for (const Contact& contact : contacts_) {
    sum += pairs.range(contact.flight).upper /
           (slopes.range(contact.approach).lower * slopes.range(contact.recession).lower);
  }
  return sum;
}

}  // namespace zenosphere
