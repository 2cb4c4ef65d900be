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

/// The contacts that a sphere may have if no other pair meets before.
template <class Real>
struct ContactsAhead {
  struct Ahead {
    std::int32_t partner;  ///< a sphere, or a wall
    Real time;             ///< from now; infinity: they miss
    Real approach;         ///< dr.dv < 0, diameters^2/time
  };
  std::vector<Ahead> contacts;
  bool has_overlaps = false;  ///< of a pair that approaches: time <= 0

  void clear() {
    contacts.clear();
    has_overlaps = false;
  }
  void add(std::int32_t partner, const Contact<Real>& contact) {
    contacts.push_back({partner, contact.time, contact.approach});
    has_overlaps |= contact.overlapping;
  }
};

/// Neighbours of which the first two contacts are found without a look at each.
inline constexpr std::size_t most_first_contacts = 60;

/// The first two of them, where they are spheres that do not overlap yet.
template <class Real>
struct FirstContacts {
  int meetings = 0;  ///< how many do not miss
  std::int32_t first = -1;
  std::int32_t second = -1;
  Real first_time = 0;  ///< remainder of the clock
  Real second_time = 0;
};

}  // namespace zenosphere
