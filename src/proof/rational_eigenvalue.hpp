#pragma once

#include <optional>

#include "proof/invariant_cone.hpp"
#include "proof/round_of_contacts.hpp"

namespace zenosphere {

/// The collapse time of a proven round as a fraction, where its largest eigenvalue is one.
///
/// With the left eigenvector l of that eigenvalue, u grows and shrinks as l u and c as l c, while
/// all else of them dies out faster: contact times -c_j/u_j go to -(l c)/(l u). So in general it
/// lies in the number field of the eigenvalue; the fraction is checked exactly, or there is none.
///
/// \param largest  between which numbers the eigenvalue lies, as narrow as possible
std::optional<Rational> rational_collapse_time(const RationalMatrix& round,
                                               const Enclosure& largest, const RowState& state);

/// The fraction of the smallest denominator in an interval of positive numbers.
Rational simplest_between(const Enclosure& interval);

}  // namespace zenosphere
