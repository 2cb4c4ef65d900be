#include "physics/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "support/gas.hpp"

namespace zenosphere {

namespace {

using Triple = std::array<long double, 3>;

long double product(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple sum(const Triple& a, long double factor, const Triple& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// The textbook root of |dr + dv t| = sigma: 64 bits of mantissa leave it 1e-18 of absolute
/// accuracy.
long double wait_for_contact(const Triple& dr, const Triple& dv, long double sigma) {
  const long double b = product(dr, dv);
  const long double v2 = product(dv, dv);
  const long double discriminant = b * b - v2 * (product(dr, dr) - sigma * sigma);
  if (b >= 0 || discriminant < 0) return std::numeric_limits<long double>::infinity();
  return (-b - std::sqrt(discriminant)) / v2;
}

}  // namespace

Oracle::Oracle(const Vec<3, double>& sides, double shear_rate, const ContactRules<double>& rules,
               const Configuration<3, double>& start, double offset)
    : sides_{sides[0], sides[1], sides[2]},
      shear_rate_(shear_rate),
      rules_(rules),
      offset_(offset) {
  for (std::size_t i = 0; i < start.positions.size(); ++i) {
    const auto& r = start.positions[i];
    const auto& v = start.velocities[i];
    positions_.push_back({r[0], r[1], r[2]});
    velocities_.push_back({v[0] + shear_rate_ * (r[1] - sides_[1] / 2), v[1], v[2]});
    const auto& grains = start.grains;
    radii_.push_back(grains.diameters.empty() ? 0.5L : grains.diameters[i] / 2.0L);
    masses_.push_back(grains.masses.empty() ? 1 : grains.masses[i]);
    if (!grains.immobile.empty() && grains.immobile[i] != 0) {
      masses_.back() = std::numeric_limits<Real>::infinity();
    }
    kinds_.push_back(grains.kinds.empty() ? 0 : grains.kinds[i]);
    spins_.push_back({});
    for (std::size_t axis = 0; axis < 3 && !start.spins.empty(); ++axis) {
      spins_.back()[axis] = start.spins[i].components[axis];
    }
  }
}

/// The nearest image and its neighbours, 27 in all.
std::vector<Oracle::Seen> Oracle::images(std::size_t i, std::size_t j) const {
  Triple dr;
  Triple dv;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    dr[axis] = positions_[j][axis] - positions_[i][axis];
    dv[axis] = velocities_[j][axis] - velocities_[i][axis];
  }
  const Real middle_y = -std::round(dr[1] / sides_[1]);
  const Real middle_z = -std::round(dr[2] / sides_[2]);
  std::vector<Seen> images;
  for (const int y : {-1, 0, 1}) {
    const Real boxes_up = middle_y + y;
    const Real x_at_zero = dr[0] + boxes_up * (offset_ + shear_rate_ * sides_[1] * time_);
    const Real middle_x = -std::round(x_at_zero / sides_[0]);
    for (const int z : {-1, 0, 1}) {
      for (const int x : {-1, 0, 1}) {
        images.push_back({{x_at_zero + (middle_x + x) * sides_[0], dr[1] + boxes_up * sides_[1],
                           dr[2] + (middle_z + z) * sides_[2]},
                          {dv[0] + boxes_up * shear_rate_ * sides_[1], dv[1], dv[2]}});
      }
    }
  }
  return images;
}

/// The earliest contact of all, good if it comes within `horizon`.
///
/// An image that is not looked at is at least 3/2 of a side away along some axis, so it cannot
/// touch before 3/2 side - the largest diameter is flown at the largest relative speed.
Oracle::Contact Oracle::earliest(Real& horizon) const {
  Contact first{std::numeric_limits<Real>::infinity(), 0, 0, {}};
  Real largest_speed = 0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    for (std::size_t j = i + 1; j < positions_.size(); ++j) {
      for (const Seen& seen : images(i, j)) {
        largest_speed = std::max(largest_speed, product(seen.dv, seen.dv));
        const Real wait = wait_for_contact(seen.dr, seen.dv, sigma(i, j));
        if (wait < first.wait) first = {wait, i, j, seen};
      }
    }
  }
  const Real room = *std::min_element(sides_.begin(), sides_.end()) * 1.5L -
                    2 * *std::max_element(radii_.begin(), radii_.end());
  horizon = room / std::sqrt(largest_speed);
  return first;
}

void Oracle::fly(Real duration) {
  time_ += duration;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions_[i][axis] += velocities_[i][axis] * duration;
    }
  }
}

/// Reverses the relative velocity along the line of centres and multiplies it by the restitution;
/// rough surfaces get the impulse that makes their velocity -beta0 of what it was, or as much of it
/// as friction allows.
void Oracle::collide(const Contact& contact, Event& event) {
  const auto [i, j] = std::pair(contact.i, contact.j);
  const auto constants = rules_.constants(kinds_[i], kinds_[j]);
  const Real length = std::sqrt(product(contact.seen.dr, contact.seen.dr));
  const Triple normal = sum({}, 1 / length, contact.seen.dr);
  const Real inverse = 1 / masses_[i] + 1 / masses_[j];
  const Real push = (1 + Real(constants.restitution)) * -product(normal, contact.seen.dv) / inverse;
  Triple impulse = sum({}, push, normal);  // on j
  const Real q = rules_.inertia.value_or(0.4);
  if (constants.friction > 0 && constants.tangential_restitution > -1) {
    // Points of the two surfaces: i's at radius along the normal, j's opposite.
    const Triple at_i = cross(spins_[i], sum({}, radii_[i], normal));
    const Triple at_j = cross(spins_[j], sum({}, -radii_[j], normal));
    Triple slip = sum(sum(contact.seen.dv, 1, at_j), -1, at_i);
    slip = sum(slip, -product(slip, normal), normal);
    const Real speed = std::sqrt(product(slip, slip));
    // An impulse P across the normal changes the slip by P (1/m_i + 1/m_j) (1 + 1/q).
    const Real wanted =
        (1 + Real(constants.tangential_restitution)) * speed / (inverse * (1 + 1 / q));
    const Real rub = std::min(wanted, Real(constants.friction) * push);
    event.sliding = rub < wanted;
    if (speed > 0) impulse = sum(impulse, -rub / speed, slip);
  }
  velocities_[i] = sum(velocities_[i], -1 / masses_[i], impulse);
  velocities_[j] = sum(velocities_[j], 1 / masses_[j], impulse);
  for (const auto& [sphere, sign] : {std::pair{i, -1}, std::pair{j, 1}}) {
    const Real inertia = q * masses_[sphere] * radii_[sphere] * radii_[sphere];
    const Triple arm = sum({}, -sign * radii_[sphere], normal);
    spins_[sphere] = sum(spins_[sphere], sign / inertia, cross(arm, impulse));
  }
}

Oracle::Event Oracle::next_collision() {
  const Real time_before = time_;
  for (int flights = 0; flights < 10000; ++flights) {
    Real horizon = 0;
    Contact contact = earliest(horizon);
    if (contact.wait > horizon) {
      fly(horizon);
      continue;
    }
    fly(contact.wait);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      contact.seen.dr[axis] += contact.seen.dv[axis] * contact.wait;
    }
    Event event{static_cast<double>(time_), static_cast<int>(contact.i),
                static_cast<int>(contact.j),
                static_cast<double>(-product(contact.seen.dr, contact.seen.dv) /
                                    sigma(contact.i, contact.j)),
                0};
    collide(contact, event);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      contact.seen.dr[axis] -= contact.seen.dv[axis] * (time_ - time_before);
    }
    event.gap_before = static_cast<double>(
        std::sqrt(product(contact.seen.dr, contact.seen.dr)) / sigma(contact.i, contact.j) - 1);
    return event;
  }
  throw std::runtime_error("no collision for long");
}

namespace {

void expect_event(const Collision<3, double>& collision, const Oracle::Event& event,
                  double tolerance) {
  ASSERT_EQ(collision.i, event.i);
  ASSERT_EQ(collision.j, event.j);
  ASSERT_NEAR(collision.impact.normal_speed, event.normal_speed,
              100 * tolerance * std::max(1.0, event.normal_speed));
  ASSERT_NEAR(collision.gap_before, event.gap_before,
              100 * tolerance * std::max(1.0, event.gap_before));
  ASSERT_EQ(collision.sliding, event.sliding);
}

void expect_spin(const Spin<3, double>& spin, const std::array<long double, 3>& expected,
                 double tolerance) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ASSERT_NEAR(spin.components[axis], static_cast<double>(expected[axis]), 1000 * tolerance);
  }
}

}  // namespace

void expect_collisions_of_oracle(Simulation<3, double>& gas, int collisions, double tolerance) {
  Oracle oracle(gas.box().sides(), gas.box().shear_rate(), gas.rules(), gas.configuration(),
                gas.lees_edwards_offset());
  const Instant<double> start = gas.now();
  for (int n = 0; n < collisions; ++n) {
    const auto collision = support::next(gas);
    SCOPED_TRACE(collision.number);
    const Oracle::Event event = oracle.next_collision();
    ASSERT_NO_FATAL_FAILURE(expect_event(collision, event, tolerance));
    ASSERT_NEAR(elapsed(start, collision.time, gas.box().clock_unit()), event.time, tolerance);
    if (gas.spins().empty()) continue;
    for (const std::int32_t i : {collision.i, collision.j}) {
      const auto at = static_cast<std::size_t>(i);
      ASSERT_NO_FATAL_FAILURE(expect_spin(gas.spins()[at], oracle.spin(at), tolerance));
    }
  }
}

}  // namespace zenosphere
