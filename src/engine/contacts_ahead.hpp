#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/contact.hpp"

namespace zenosphere {

/// From where, how fast and when a sphere looks at the others.
template <int Dim, class Real>
struct Viewpoint {
  Vec<Dim, Real> position;
  Vec<Dim, Real> velocity;
  Real when;  ///< remainder of the clock
};

/// The contacts that a sphere may have if nobody else meets anyone before: one column for each
/// quantity, so that several contacts can be found at once.
template <class Real>
struct ContactsAhead {
  std::size_t count = 0;
  bool has_overlaps = false;          ///< of a pair that approaches: time <= 0
  std::vector<Real> time;             ///< from now; infinity: they miss
  std::vector<Real> approach;         ///< dr.dv < 0, diameters^2/time
  std::vector<Real> speed_squared;    ///< dv.dv; scratch of find_contacts_wide()
  std::vector<std::int32_t> partner;  ///< a sphere, or a wall

  void clear() {
    count = 0;
    has_overlaps = false;
  }

  /// Makes room for so many more, and for what is written beyond them when several are found at
  /// once.
  void make_room(std::size_t more) {
    constexpr std::size_t lanes = 8;
    const std::size_t size = count + more + lanes;
    if (size <= time.size()) return;
    for (auto* column : {&time, &approach, &speed_squared}) column->resize(2 * size);
    partner.resize(2 * size);
  }

  void add(std::int32_t with, const Contact<Real>& contact) {
    make_room(1);
    time[count] = contact.time;
    approach[count] = contact.approach;
    partner[count] = with;
    has_overlaps |= contact.overlapping;
    ++count;
  }
};

/// Which two of the contacts come first, by number; -1: none.
struct FirstTwo {
  int first = -1;
  int second = -1;
  int meetings = 0;  ///< how many do not miss
};

/// Of equal times the lower partner's comes first, so that the order of neighbours has no effect.
///
/// \param now  to which the times are added, and rounded, first
template <class Real>
FirstTwo first_two(const ContactsAhead<Real>& ahead, const Real& now);

}  // namespace zenosphere
