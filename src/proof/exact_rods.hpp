#pragma once

#include <string>
#include <vector>

#include "proof/rational.hpp"

namespace zenosphere {

/// Rods on a line, each number as a text that means it exactly.
struct RodsStart {
  std::vector<std::string> positions;   ///< of the centres, in diameters; in any order
  std::vector<std::string> velocities;  ///< diameter/time
  std::string restitution;              ///< in [0, 1]
  std::string period{};  ///< of a periodic line, in diameters; empty: an infinite line
  std::vector<std::string> lengths{};  ///< > 0, in the order of the positions; empty: all are 1
  std::vector<std::string> masses{};   ///< > 0, likewise
};

/// Rods on a line in exact arithmetic: no rounding, no tolerance.
///
/// Letter i is the gap between rod i and rod i + 1 in the order of their places; on a periodic line
/// the last one is that across the end. Between contacts gap i is c_i + u_i t, with the time t
/// since the start. A contact at letter j takes u to C_j u, where (C_j u)_j = -e u_j and (C_j u)_i
/// = u_i + (1 + e) m/M u_j at its neighbours i, m the mass of the rod of the pair j that is not
/// beside i and M the mass of both: (1 + e)/2 for equal rods. Since gap j is zero then, it takes c
/// to C_j c as well: both go through the same linear map, and their digits grow by a constant
/// number at each contact. Source: the map of the velocities is that of Bernu & Mazighi, J. Phys. A
/// 23 (1990) 5745; that of c follows from C_j (c + u t) = c + u t.
class ExactRods {
 public:
  enum class Event {
    contact,
    none_left,      ///< no two rods approach each other: nothing happens any more
    exact_contact,  ///< three rods touch at one instant: what they do then is not defined
  };

  /// \throws InputError  for texts that are no numbers, lists of different lengths, fewer than two
  ///                     rods, rods that overlap, a restitution outside [0, 1]
  explicit ExactRods(const RodsStart& start);

  /// Goes on to the next contact. After anything but a contact nothing has changed.
  ///
  /// Separate pairs that touch at one instant do so one after the other, in the order of their
  /// letters: the result does not depend on that order.
  Event next_event();

  int letters() const { return static_cast<int>(u_.size()); }
  bool is_periodic() const { return is_periodic_; }
  /// The letter of the latest contact, or of the exact contact; -1 before the first.
  int letter() const { return letter_; }
  /// The time of the latest event, 0 before the first.
  Rational now() const;
  bool is_after(const Rational& time) const;
  /// Two contacts have fallen on one instant, of pairs that have no rod in common.
  bool has_simultaneous_contacts() const { return has_simultaneous_; }

  /// c and u, times one positive integer that grows from contact to contact.
  const std::vector<Integer>& constants() const { return c_; }
  const std::vector<Integer>& slopes() const { return u_; }
  /// The width of a gap now, in diameters.
  Rational gap(int letter) const;
  /// A bound of the differences between two velocities, now and ever after. Between equal rods the
  /// largest one at the start: contacts take both velocities to averages of the two (of positive
  /// weights, since e <= 1). With different masses what the energy at the start allows.
  const Rational& velocity_range() const { return velocity_range_; }
  /// The index, in the start's lists, of the rod at the left of a letter; `letters()` on an
  /// infinite line is the last rod.
  int rod(int place) const { return order_[static_cast<std::size_t>(place) % order_.size()]; }
  const Rational& restitution() const { return restitution_; }

  /// The letters beside one, the left one first, each as often as it is a neighbour.
  std::vector<int> neighbours(int letter) const;

  /// The masses of the rods at a place of the line and behind it, up to a common factor; empty for
  /// equal ones.
  std::vector<Integer> masses_from(int place, std::size_t count) const;

 private:
  void place(const RodsStart& start);
  bool has_contact_beside(int letter) const;
  void collide(int letter);
  void collide_letters(std::vector<Integer>& values, int letter, const Integer& left,
                       const Integer& right) const;

  bool is_periodic_;
  Rational restitution_;
  std::vector<int> order_;       ///< of the rods along the line
  std::vector<Integer> masses_;  ///< along the line, up to a factor; empty: equal
  std::vector<Integer> c_;
  std::vector<Integer> u_;
  Integer scale_ = 1;  ///< of c_ and u_
  Rational velocity_range_;
  Integer now_times_;  ///< numerator and denominator of now, not reduced: that would cost most
  Integer now_over_ = 1;
  int letter_ = -1;
  bool has_simultaneous_ = false;
};

}  // namespace zenosphere
