// The spins of rough spheres, and what friction does to them and to velocities.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/instantiate.hpp"
#include "verify/replay.hpp"

namespace zenosphere::verify {

template <int Dim>
void Replay<Dim>::start_turning(const Snapshot& snapshot) {
  turning_.clear();
  if (!law_.is_rough() || snapshot.angular_velocities.empty()) return;
  turning_.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Number square = 0;
    for (int axis = 0; axis < spin_axes<Dim>; ++axis) {
      const Number spin =
          snapshot.angular_velocities[i * spin_axes<Dim> + static_cast<std::size_t>(axis)];
      turning_[i].spin[axis] = spin;
      square += spin * spin;
    }
    turning_[i].error = double_rounding * std::sqrt(square);
  }
}

/// The impulse of friction on the second of a row, by Walton's law: the surfaces stick, or slide
/// where the row says so. Gives both their spins.
///
/// The error of a sliding impulse, mu J along a direction that is known to within
/// error / |slip|, is no larger than that of a sticking one, since sliding begins where mu J is
/// below (1 + beta0) m_t |slip|.
///
/// \param error  bound on that of the normal impulse; becomes that of both
template <int Dim>
typename Replay<Dim>::Vector Replay<Dim>::rub(const CollisionRow& row, const Meeting<Dim>& meeting,
                                              Number impulse,
                                              const ContactConstants<Number>& constants,
                                              Number& error, Findings& findings) {
  if (turning_.empty() || !constants.is_rough()) return {};
  std::vector<std::int32_t> partners{row.i};
  if (!wall(row.j)) partners.push_back(row.j);
  Vector slip = meeting.velocity;
  Number slip_error = meeting.speed * meeting.normal_error + meeting.closing_error;
  Number sign = 1;
  for (const std::int32_t sphere : partners) {
    const Turning& turning = turning_[static_cast<std::size_t>(sphere)];
    const Number radius = body(sphere).radius;
    // The point of contact lies along the normal from the first, against it from the second.
    slip -= turning_velocity<Dim, Number>(turning.spin, meeting.normal * (sign * radius)) * sign;
    slip_error += radius * (turning.error +
                            std::sqrt(dot(turning.spin, turning.spin)) * meeting.normal_error);
    sign = -sign;
  }
  slip -= meeting.normal * dot(meeting.normal, slip);
  const Number size = length(slip);
  const Number mass = 1 / (law_.inverse_masses(row) * (1 + 1 / law_.inertia()));
  const Number per_slip = (1 + constants.tangential_restitution) * mass;
  const bool slides = (row.flags & collision_flag::sliding) != 0;
  const Number most = constants.friction * impulse;
  const Number doubt = per_slip * slip_error + constants.friction * error;
  if (slides != (per_slip * size > most) && std::abs(per_slip * size - most) > doubt) {
    findings.add(fmt::format(
        "collision {} of spheres {} and {}: flags = {} (flag 64 is for surfaces that slide; to "
        "stick takes {:.6g}, friction gives {:.6g})",
        row.k, row.i, row.j, row.flags, static_cast<double>(per_slip * size),
        static_cast<double>(most)));
  }
  const Number rubbed = slides ? most : per_slip * size;
  const Vector friction = size > 0 ? slip * (-rubbed / size) : Vector{};
  const Number friction_error = 2 * per_slip * slip_error + 8 * double_rounding * rubbed +
                                (slides ? constants.friction * error : Number(0));
  for (const std::int32_t sphere : partners) {
    Turning& turning = turning_[static_cast<std::size_t>(sphere)];
    const Number lever = law_.inverse_mass(sphere) / (law_.inertia() * body(sphere).radius);
    // For both: the arm and the impulse of the second are the opposite of those of the first.
    turning.spin += angular_impulse<Dim, Number>(meeting.normal, friction * Number(-1)) * lever;
    turning.error += lever * (friction_error + rubbed * meeting.normal_error) +
                     4 * motion_.rounding() * std::sqrt(dot(turning.spin, turning.spin));
  }
  error += friction_error;
  return friction;
}

template <int Dim>
void Replay<Dim>::compare_spin(std::int32_t i, const Snapshot& snapshot, Findings& findings) const {
  const auto at = static_cast<std::size_t>(i);
  const Turning& turning = turning_[at];
  Number square = 0;
  Number size = 0;
  for (int axis = 0; axis < spin_axes<Dim>; ++axis) {
    const Number stored =
        snapshot.angular_velocities[at * spin_axes<Dim> + static_cast<std::size_t>(axis)];
    square += (stored - turning.spin[axis]) * (stored - turning.spin[axis]);
    size = std::max(size, std::abs(stored));
  }
  const Number bound = turning.error + 8 * double_rounding * size;
  if (std::sqrt(square) <= bound) return;
  findings.add(fmt::format(
      "snapshot at collision {}: the angular velocity of sphere {} differs by {:.3g} "
      "from what the log leads to (0 within {:.2g})",
      snapshot.step, i, static_cast<double>(std::sqrt(square)), static_cast<double>(bound)));
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                                \
  template void Replay<Dim>::start_turning(const Snapshot&);                                       \
  template typename Replay<Dim>::Vector Replay<Dim>::rub(const CollisionRow&, const Meeting<Dim>&, \
                                                         Number, const ContactConstants<Number>&,  \
                                                         Number&, Findings&);                      \
  template void Replay<Dim>::compare_spin(std::int32_t, const Snapshot&, Findings&) const;
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
