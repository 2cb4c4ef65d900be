#include "engine/contacts_ahead.hpp"

#include <limits>

#include "model/instantiate.hpp"

namespace zenosphere {

template <class Real>
FirstTwo first_two(const ContactsAhead<Real>& ahead, const Real& now) {
  const Real never = std::numeric_limits<Real>::infinity();
  FirstTwo two;
  Real first = never;
  Real second = never;
  for (std::size_t k = 0; k < ahead.count; ++k) {
    const Real time = now + ahead.time[k];
    if (!(time < never)) continue;
    ++two.meetings;
    const auto comes_before = [&](const Real& other, int number) {
      return time < other ||
             (time == other && ahead.partner[k] < ahead.partner[static_cast<std::size_t>(number)]);
    };
    if (comes_before(first, two.first)) {
      two.second = two.first;
      second = first;
      two.first = static_cast<int>(k);
      first = time;
    } else if (comes_before(second, two.second)) {
      two.second = static_cast<int>(k);
      second = time;
    }
  }
  return two;
}

#define ZENOSPHERE_INSTANTIATE(Real) \
  template FirstTwo first_two(const ContactsAhead<Real>& ahead, const Real& now);
ZENOSPHERE_FOR_EACH_REAL(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
