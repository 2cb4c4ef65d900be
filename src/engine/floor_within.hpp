#pragma once

#include <cmath>

namespace zenosphere {

/// The floor of a number, from `least` to `most` whatever it is: in a state that has been made
/// up it may be anything.
template <class Real>
int floor_within(int least, int most, const Real& number) {
  using std::floor;
  if (!(number > least)) return least;
  return number < most ? static_cast<int>(floor(number)) : most;
}

}  // namespace zenosphere
