#include "engine/contact_physics.hpp"

#include <cassert>
#include <cmath>

#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Any odd constant makes a stream apart from the others of a seed; this one is splitmix64's.
constexpr std::uint64_t kOtherStream = 0xbf58476d1ce4e5b9;

/// So long ago that it is before every contact duration; in the case's time unit.
constexpr double kNever = -1e300;

/// At least every other rotation leaves a pair that recedes: this many in vain are a case in 1e19.
constexpr int kMostTrials = 64;

/// A unit vector across `direction`, which is one too, in a random sense.
template <class Real>
Vec<3, Real> random_normal(const Vec<3, Real>& direction, Random& random) {
  using std::sqrt;
  for (;;) {
    Vec<3, Real> point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = Real(2 * random.uniform() - 1);
    const Real r2 = dot(point, point);
    if (!(r2 <= 1)) continue;  // outside the ball, where not all directions are alike
    point -= direction * dot(direction, point);
    const Real across = dot(point, point);
    if (across > Real(0.01)) return point * Real(1 / sqrt(across));  // nearer, it loses digits
  }
}

}  // namespace

template <int Dim, class Real>
ContactPhysics<Dim, Real>::ContactPhysics(const ContactModels<Real>& models,
                                          const Real& restitution, std::int32_t spheres,
                                          const Real& clock_unit)
    : models_(models),
      restitution_(restitution),
      clock_unit_(clock_unit),
      random_(models.seed ^ kOtherStream) {
  assert(models.is_any());
  assert(Dim > 1 || models.rotation_angle == 0);
  if (models.contact_duration > 0) {
    last_contact_.assign(static_cast<std::size_t>(spheres), Instant<Real>{0, Real(kNever)});
  }
}

template <int Dim, class Real>
void ContactPhysics<Dim, Real>::amend(Collision<Dim, Real>& collision, const Vector& dv) {
  auto& impact = collision.impact;
  const bool lasts = is_lasting(collision, collision.i) || is_lasting(collision, collision.j);
  if (!last_contact_.empty()) {
    last_contact_[static_cast<std::size_t>(collision.i)] = collision.time;
    last_contact_[static_cast<std::size_t>(collision.j)] = collision.time;
  }
  if (!(impact.normal_speed > 0)) return;
  Real restitution = restitution_;
  if (models_.viscoelastic) restitution = (*models_.viscoelastic)(impact.normal_speed);
  if (models_.fixed_loss) restitution = (*models_.fixed_loss)(impact.normal_speed);
  if (lasts) restitution = 1;
  collision.made_elastic = lasts;
  impact.impulse = (1 + restitution) * impact.normal_speed / 2;
  collision.change = impact.normal * -impact.impulse;
  if (models_.rotation_angle > 0) rotate(collision, dv);
  ++counts_.collisions;
  counts_.mean_restitution += (static_cast<double>(restitution) - counts_.mean_restitution) /
                              static_cast<double>(counts_.collisions);
  counts_.made_elastic += lasts;
}

template <int Dim, class Real>
void ContactPhysics<Dim, Real>::amend(Collision<Dim, Real>& collision, Walls<Real>& walls) {
  if (last_contact_.empty()) return;
  collision.made_elastic = is_lasting(collision, collision.i);
  last_contact_[static_cast<std::size_t>(collision.i)] = collision.time;
  counts_.made_elastic += collision.made_elastic;
  if (collision.made_elastic) walls.restitution = 1;
}

/// Whether the contact of the sphere before this collision is not over yet, for the TC model.
template <int Dim, class Real>
bool ContactPhysics<Dim, Real>::is_lasting(const Collision<Dim, Real>& collision,
                                           std::int32_t sphere) const {
  if (last_contact_.empty()) return false;
  const auto& last = last_contact_[static_cast<std::size_t>(sphere)];
  return elapsed(last, collision.time, clock_unit_) < models_.contact_duration;
}

/// Turns the relative velocity after the collision, so that the pair still recedes.
template <int Dim, class Real>
void ContactPhysics<Dim, Real>::rotate(Collision<Dim, Real>& collision, const Vector& dv) {
  const Vector after = dv - collision.change * Real(2);
  for (int trial = 0; trial < kMostTrials; ++trial) {
    const Vector rotated = turned(after);
    if (!(dot(collision.impact.normal, rotated) > 0)) continue;
    collision.change = (dv - rotated) * Real(0.5);
    ++counts_.rotated;
    return;
  }
}

/// The velocity turned by a random angle: uniform in [-most, most] in the plane, in [0, most] about
/// a random axis in space.
template <int Dim, class Real>
typename ContactPhysics<Dim, Real>::Vector ContactPhysics<Dim, Real>::turned(
    const Vector& velocity) {
  using std::sqrt;
  if constexpr (Dim == 2) {
    const Real angle = models_.rotation_angle * Real(2 * random_.uniform() - 1);
    const auto [sine, cosine] = sine_and_cosine(angle);
    return {velocity[0] * cosine - velocity[1] * sine, velocity[0] * sine + velocity[1] * cosine};
  } else if constexpr (Dim == 3) {
    const Real speed = sqrt(dot(velocity, velocity));
    if (!(speed > 0)) return velocity;
    const auto [sine, cosine] =
        sine_and_cosine(Real(models_.rotation_angle * Real(random_.uniform())));
    const Vector across = random_normal(velocity * Real(1 / speed), random_);
    return velocity * cosine + across * Real(speed * sine);
  } else {
    return velocity;
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class ContactPhysics<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
