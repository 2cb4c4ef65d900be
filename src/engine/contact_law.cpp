#include "engine/contact_law.hpp"

#include <cassert>
#include <cmath>
#include <type_traits>
#include <variant>

#include "model/friction.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

namespace {

/// Any odd constant makes a stream apart from the others of a seed; this one is splitmix64's.
constexpr std::uint64_t other_stream = 0xbf58476d1ce4e5b9;

/// So long ago that it is before every contact duration; in the case's time unit.
constexpr double never = -1e300;

/// At least every other rotation leaves a pair that recedes: this many in vain are a case in 1e19.
constexpr int most_trials = 64;

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

/// What the laws of restitution have to know of the two spheres.
template <int Dim, class Real>
CollidingPair<Real> pair_of(const Collision<Dim, Real>& collision, const Grains<Real>& grains) {
  const std::int32_t i = collision.i;
  const std::int32_t j = collision.j;
  CollidingPair<Real> pair{.inverse_masses = grains.inverse_mass(i) + grains.inverse_mass(j)};
  if (grains.diameters.empty()) return pair;
  const Real size = grains.diameter(i);
  const Real other = grains.diameter(j);
  pair.diameter = 2 * size * other / (size + other);
  return pair;
}

}  // namespace

template <int Dim, class Real>
ContactLaw<Dim, Real>::ContactLaw(const ContactRules<Real>& rules, std::int32_t spheres,
                                  const Real& clock_unit)
    : rules_(rules),
      inertia_(rules.inertia.value_or(Real(solid_inertia<Dim>))),
      clock_unit_(clock_unit),
      random_(rules.models.seed ^ other_stream) {
  assert(Dim > 1 || rules.models.rotation_angle == 0);
  if (rules.models.contact_duration > 0) {
    last_contact_.assign(static_cast<std::size_t>(spheres), Instant<Real>{0, Real(never)});
  }
}

template <int Dim, class Real>
void ContactLaw<Dim, Real>::collide(Collision<Dim, Real>& collision,
                                    const RelativeMotion<Dim, Real>& motion,
                                    const Bodies<Dim, Real>& bodies) {
  const auto& [grains, spins] = bodies;
  auto& impact = collision.impact = touch(motion);
  const bool lasts = is_lasting(collision, collision.i) || is_lasting(collision, collision.j);
  if (!last_contact_.empty()) {
    last_contact_[static_cast<std::size_t>(collision.i)] = collision.time;
    last_contact_[static_cast<std::size_t>(collision.j)] = collision.time;
  }
  if (!(impact.normal_speed > 0)) return;
  collision.made_elastic = lasts;
  const ContactConstants<Real> constants =
      rules_.constants(grains.kind(collision.i), grains.kind(collision.j));
  const Real restitution = this->restitution(collision, constants, grains);
  const Real inverse_masses = grains.inverse_mass(collision.i) + grains.inverse_mass(collision.j);
  impact.impulse = normal_impulse(impact.normal_speed, restitution, inverse_masses);
  collision.change = impact.normal * -impact.impulse;
  if (!spins.empty()) {
    const auto turning = bodies.surface_spin(collision.i) + bodies.surface_spin(collision.j);
    rub(collision, motion.dv, turning, inverse_masses, constants);
  }
  if (rules_.models.rotation_angle > 0) rotate(collision, motion.dv, inverse_masses);
  ++counts_.collisions;
  counts_.mean_restitution += (static_cast<double>(restitution) - counts_.mean_restitution) /
                              static_cast<double>(counts_.collisions);
  counts_.made_elastic += lasts;
}

template <int Dim, class Real>
void ContactLaw<Dim, Real>::bounce(Collision<Dim, Real>& collision, Walls<Real> walls, int side,
                                   const Vector& velocity, const Bodies<Dim, Real>& bodies,
                                   const Real& least) {
  if (!last_contact_.empty()) {
    collision.made_elastic = is_lasting(collision, collision.i);
    last_contact_[static_cast<std::size_t>(collision.i)] = collision.time;
    counts_.made_elastic += collision.made_elastic;
    if (collision.made_elastic) walls.restitution = 1;
  }
  const ContactConstants<Real> rough{walls.restitution, walls.tangential_restitution,
                                     walls.friction};
  if (!bodies.spins.empty()) walls.tangential_restitution = -1;  // friction takes its place
  const auto bounce = wall_impact(walls, side, velocity, bodies.grains.mass(collision.i),
                                  bodies.grains.radius(collision.i), least);
  collision.impact = bounce.impact;
  collision.resting = bounce.rests;
  collision.change = bounce.change;
  if (bodies.spins.empty() || !(collision.impact.impulse > 0)) return;
  Vector dv = velocity * Real(-1);  // of the wall, as the sphere sees it
  dv[0] += walls.speed[static_cast<std::size_t>(side)];
  rub(collision, dv, bodies.surface_spin(collision.i), bodies.grains.inverse_mass(collision.i),
      rough);
}

/// The coefficient of restitution of a pair that approaches.
template <int Dim, class Real>
Real ContactLaw<Dim, Real>::restitution(const Collision<Dim, Real>& collision,
                                        const ContactConstants<Real>& constants,
                                        const Grains<Real>& grains) const {
  const Real& speed = collision.impact.normal_speed;
  const auto& models = rules_.models;
  if (collision.made_elastic) return 1;
  if (constants.is_own) return constants.restitution;
  if (!models.law) return constants.restitution;
  const auto restitution = [&](const auto& law) -> Real {
    constexpr bool knows_pair =
        std::is_invocable_v<decltype(law), const Real&, const CollidingPair<Real>&>;
    if constexpr (knows_pair) return law(speed, pair_of(collision, grains));
    if constexpr (!knows_pair) return law(speed);
  };
  return std::visit(restitution, *models.law);
}

/// Adds what friction does to a collision whose normal impulse is known.
///
/// \param dv              velocity of the second centre minus that of the first
/// \param turning         radius x spin, summed over the two
/// \param inverse_masses  1/m_i + 1/m_j
template <int Dim, class Real>
void ContactLaw<Dim, Real>::rub(Collision<Dim, Real>& collision, const Vector& dv,
                                const Spin<Dim, Real>& turning, const Real& inverse_masses,
                                const ContactConstants<Real>& constants) const {
  if (!constants.is_rough()) return;
  const auto& impact = collision.impact;
  // With I = q m r^2 for each, 1/m_t = (1/m_i + 1/m_j) (1 + 1/q).
  const Real mass = inertia_ / ((1 + inertia_) * inverse_masses);
  const auto rubbing = zenosphere::rubbing(sliding_velocity(dv, impact.normal, turning),
                                           impact.impulse, mass, constants);
  collision.friction = rubbing.impulse * Real(-1);
  collision.change += collision.friction;
  collision.friction_loss = rubbing.loss;
  collision.sliding = rubbing.slides;
}

/// Whether the contact of the sphere before this collision is not over yet, for the TC model.
template <int Dim, class Real>
bool ContactLaw<Dim, Real>::is_lasting(const Collision<Dim, Real>& collision,
                                       std::int32_t sphere) const {
  if (last_contact_.empty()) return false;
  const auto& last = last_contact_[static_cast<std::size_t>(sphere)];
  return elapsed(last, collision.time, clock_unit_) < rules_.models.contact_duration;
}

/// Turns the relative velocity after the collision, so that the pair still recedes.
template <int Dim, class Real>
void ContactLaw<Dim, Real>::rotate(Collision<Dim, Real>& collision, const Vector& dv,
                                   const Real& inverse_masses) {
  const Vector after = dv - collision.change * inverse_masses;
  for (int trial = 0; trial < most_trials; ++trial) {
    const Vector rotated = turned(after);
    if (!(dot(collision.impact.normal, rotated) > 0)) continue;
    collision.change = (dv - rotated) * Real(1 / inverse_masses);
    ++counts_.rotated;
    return;
  }
}

/// The velocity turned by a random angle: uniform in [-most, most] in the plane, in [0, most] about
/// a random axis in space.
template <int Dim, class Real>
typename ContactLaw<Dim, Real>::Vector ContactLaw<Dim, Real>::turned(const Vector& velocity) {
  using std::sqrt;
  if constexpr (Dim == 2) {
    const Real angle = rules_.models.rotation_angle * Real(2 * random_.uniform() - 1);
    const auto [sine, cosine] = sine_and_cosine(angle);
    return {velocity[0] * cosine - velocity[1] * sine, velocity[0] * sine + velocity[1] * cosine};
  } else if constexpr (Dim == 3) {
    const Real speed = sqrt(dot(velocity, velocity));
    if (!(speed > 0)) return velocity;
    const auto [sine, cosine] =
        sine_and_cosine(Real(rules_.models.rotation_angle * Real(random_.uniform())));
    const Vector across = random_normal(velocity * Real(1 / speed), random_);
    return velocity * cosine + across * Real(speed * sine);
  } else {
    return velocity;
  }
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class ContactLaw<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
