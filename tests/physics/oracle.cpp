#include "physics/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace zenosphere {

namespace {

using Triple = std::array<long double, 3>;

long double product(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The textbook root of |dr + dv t| = 1: 64 bits of mantissa leave it 1e-18 of absolute accuracy.
long double wait_for_contact(const Triple& dr, const Triple& dv) {
  const long double b = product(dr, dv);
  const long double v2 = product(dv, dv);
  const long double discriminant = b * b - v2 * (product(dr, dr) - 1);
  if (b >= 0 || discriminant < 0) return std::numeric_limits<long double>::infinity();
  return (-b - std::sqrt(discriminant)) / v2;
}

}  // namespace

Oracle::Oracle(const Vec<3, double>& sides, double shear_rate, double restitution,
               const Configuration<3, double>& start, double offset)
    : sides_{sides[0], sides[1], sides[2]},
      shear_rate_(shear_rate),
      restitution_(restitution),
      offset_(offset) {
  for (std::size_t i = 0; i < start.positions.size(); ++i) {
    const auto& r = start.positions[i];
    const auto& v = start.velocities[i];
    positions_.push_back({r[0], r[1], r[2]});
    velocities_.push_back({v[0] + shear_rate_ * (r[1] - sides_[1] / 2), v[1], v[2]});
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
/// touch before 3/2 side - 1 is flown at the largest relative speed.
Oracle::Contact Oracle::earliest(Real& horizon) const {
  Contact first{std::numeric_limits<Real>::infinity(), 0, 0, {}};
  Real largest_speed = 0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    for (std::size_t j = i + 1; j < positions_.size(); ++j) {
      for (const Seen& seen : images(i, j)) {
        largest_speed = std::max(largest_speed, product(seen.dv, seen.dv));
        const Real wait = wait_for_contact(seen.dr, seen.dv);
        if (wait < first.wait) first = {wait, i, j, seen};
      }
    }
  }
  const Real room = *std::min_element(sides_.begin(), sides_.end()) * 1.5L - 1;
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

/// Reverses the relative velocity along the line of centres and multiplies it by the restitution.
void Oracle::collide(const Contact& contact) {
  const Triple& dr = contact.seen.dr;
  const Real closing = product(dr, contact.seen.dv) / product(dr, dr);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Real half_change = (1 + restitution_) / 2 * closing * dr[axis];
    velocities_[contact.i][axis] += half_change;
    velocities_[contact.j][axis] -= half_change;
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
                static_cast<double>(-product(contact.seen.dr, contact.seen.dv)), 0};
    collide(contact);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      contact.seen.dr[axis] -= contact.seen.dv[axis] * (time_ - time_before);
    }
    event.gap_before =
        static_cast<double>(std::sqrt(product(contact.seen.dr, contact.seen.dr)) - 1);
    return event;
  }
  throw std::runtime_error("no collision for long");
}

}  // namespace zenosphere
