#pragma once

#include <optional>

#include "io/case.hpp"
#include "io/records.hpp"

namespace zenosphere::verify {

/// The impulse of a logged collision of two spheres, by the law of its case and with its normal
/// speed, mass diameter/time; nothing where the log does not tell it.
///
/// \param restitution  that of the case, in its precision
inline std::optional<long double> impulse_of(const CollisionRow& row, long double restitution) {
  if (!(row.normal_speed > 0)) return 0.0L;
  return (1 + restitution) / 2 * row.normal_speed;
}

}  // namespace zenosphere::verify
