#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "model/contact.hpp"

namespace zenosphere {

/// c[0] + c[1] t + c[2] t^2 + ...
template <int Degree, class Real>
struct Polynomial {
  std::array<Real, Degree + 1> c;

  Real operator()(const Real& t) const {
    Real sum = c[Degree];
    for (int power = Degree - 1; power >= 0; --power) {
      sum = sum * t + c[static_cast<std::size_t>(power)];
    }
    return sum;
  }

  Polynomial<Degree - 1, Real> derivative() const {
    Polynomial<Degree - 1, Real> slope;
    for (std::size_t power = 1; power <= Degree; ++power) {
      slope.c[power - 1] = Real(static_cast<int>(power) * c[power]);
    }
    return slope;
  }
};

/// Where a polynomial that is monotonic from `low` to `high`, and has different signs there, is 0.
///
/// Newton's steps, and halves of the interval where these lead out of it.
template <int Degree, class Real>
Real crossing(const Polynomial<Degree, Real>& polynomial, Real low, Real high) {
  using std::abs;
  const auto slope = polynomial.derivative();
  const bool rises = polynomial(high) > 0;
  Real t = low + (high - low) / 2;
  for (;;) {
    const Real value = polynomial(t);
    if (value == 0) return t;
    if ((value < 0) == rises) {
      low = t;
    } else {
      high = t;
    }
    const Real step = value / slope(t);
    Real next = t - step;
    if (abs(step) <= std::numeric_limits<Real>::epsilon() * abs(t)) return t;
    if (!(next > low && next < high)) next = low + (high - low) / 2;
    if (!(next > low && next < high)) return high;
    t = next;
  }
}

/// Times after 0 and in ascending order, of which there are few.
template <class Real>
struct FewTimes {
  std::array<Real, 4> times;
  std::size_t count = 0;

  void add(const Real& time) { times[count++] = time; }
  const Real* begin() const { return times.data(); }
  const Real* end() const { return times.data() + count; }
};

/// Where c[0] + c[1] t + c[2] t^2, c[2] > 0, is 0 at a time after 0: no root is the difference of
/// nearly equal numbers.
template <class Real>
FewTimes<Real> zeros(const Polynomial<2, Real>& polynomial) {
  using std::sqrt;
  const auto& [c0, c1, c2] = polynomial.c;
  FewTimes<Real> zeros;
  const Real discriminant = c1 * c1 - 4 * c2 * c0;
  if (!(discriminant > 0)) return zeros;
  const Real root = sqrt(discriminant);
  const Real sum = c1 > 0 ? Real(-c1 - root) : Real(root - c1);  // its size is not 0
  const Real one = sum / (2 * c2);
  const Real other = 2 * c0 / sum;
  const Real& first = one < other ? one : other;
  const Real& second = one < other ? other : one;
  if (first > 0) zeros.add(first);
  if (second > 0) zeros.add(second);
  return zeros;
}

/// Where a polynomial of the third degree changes its sign before `far`, and `far` itself.
template <class Real>
FewTimes<Real> turns_until(const Real& far, const Polynomial<3, Real>& slope) {
  FewTimes<Real> turns;
  Real begin = 0;
  const auto look_until = [&](const Real& end) {
    const Real here = slope(begin);  // from 0 on it cannot change its sign: it is monotonic
    const Real there = slope(end);
    if ((here < 0 && there > 0) || (here > 0 && there < 0)) {
      turns.add(crossing(slope, begin, end));
    }
    begin = end;
  };
  for (const Real& bend : zeros(slope.derivative())) {
    if (bend < far) look_until(bend);
  }
  look_until(far);
  turns.add(far);
  return turns;
}

/// Time until two spheres touch of which one falls and the other does not, or nothing if they never
/// do.
///
/// The square of their distance less sigma^2 is a polynomial of the fourth degree in the time. It
/// rises or falls all the way between the zeros of its derivative, and so does that between the
/// zeros of the second one, for which there is a formula. So every stretch on which the spheres
/// approach is found, and a contact is where one begins outside and ends inside: none is missed.
///
/// A pair that overlaps while closing touches as one that flies straight (see contact()). One that
/// overlaps while it parts touches again at the depth that it has now: a hop of which rounding has
/// hidden the height ends when it should.
///
/// \param pull  of gravity on the second less that on the first, not 0, diameters/time^2
template <int Dim, class Real>
std::optional<Contact<Real>> falling_contact(const RelativeMotion<Dim, Real>& motion,
                                             const Vec<Dim, Real>& pull, const Real& sigma) {
  using std::sqrt;
  const auto [b, v2, r2] = approach(motion);
  const Real distance = sqrt(r2);
  const Real c = (distance - sigma) * (distance + sigma);
  if (c <= 0 && b < 0) return contact(approach(motion), sigma);
  const Real pull2 = dot(pull, pull);
  const Polynomial<4, Real> excess{
      {c > 0 ? c : Real(0), 2 * b, v2 + dot(motion.dr, pull), dot(motion.dv, pull), pull2 / 4}};
  // From here on the fall alone has led further than where they were, and than sigma.
  const Real size = sqrt(pull2);
  const Real far = 2 * (sqrt(v2) + sqrt(Real(v2 + 2 * size * (distance + sigma)))) / size;
  Real begin = 0;
  for (const Real& end : turns_until(far, excess.derivative())) {
    if (excess(begin) >= 0 && excess(end) < 0) {
      const Real time = excess(begin) > 0 ? crossing(excess, begin, end) : begin;
      return Contact<Real>{time, c <= 0 && !(time > 0), b};
    }
    begin = end;
  }
  return std::nullopt;
}

}  // namespace zenosphere
