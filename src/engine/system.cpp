#include "engine/system.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim, class Real>
System<Dim, Real>::System(const ShearBox<Dim, Real>& box, Configuration<Dim, Real> start,
                          const Surroundings<Dim, Real>& around)
    : frame(box, around.common_acceleration()),
      spheres(box, std::move(start), around.acceleration - frame.acceleration()),
      search(spheres),
      surroundings(around),
      clock(box.clock_unit()) {
  assert(around.all_fall == (spheres.grains().immobile.empty() || around.acceleration == Vector{}));
  make_walls();
}

template <int Dim, class Real>
System<Dim, Real>::System(const ShearBox<Dim, Real>& box, const Surroundings<Dim, Real>& around,
                          ArchiveReader& archive)
    : frame(box, around.common_acceleration()),
      spheres(box, around.acceleration - frame.acceleration(), archive),
      search(spheres, archive),
      surroundings(around),
      clock(box.clock_unit()) {
  make_walls();
}

template <int Dim, class Real>
void System<Dim, Real>::make_walls() {
  const auto& walls = surroundings.walls;
  assert(!walls ? !box().closed_axis() : box().is_closed(walls->axis));
  if (!walls || !MovingWalls<Dim, Real>::are_needed(*walls)) return;
  moving_walls.emplace(*walls, count(), box().clock_unit());
}

template <int Dim, class Real>
Configuration<Dim, Real> System<Dim, Real>::configuration() const {
  const Instant<Real>& now = clock.now();
  Configuration<Dim, Real> state = spheres.configuration(now.units, now.remainder);
  if (!frame.moves()) return state;
  const auto origin = frame.place(now, state.offset);
  const Vector velocity = frame.velocity(now);
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    typename MovingFrame<Dim, Real>::Place place{state.positions[i] + origin.in_box,
                                                 state.boxes[i] + origin.boxes};
    frame.wrap(place, state.offset);
    state.positions[i] = place.in_box;
    state.boxes[i] = place.boxes;
  }
  for (Vector& own : state.velocities) own += velocity;
  return state;
}

template <int Dim, class Real>
typename System<Dim, Real>::CountedGap System<Dim, Real>::oscillating_gap(std::int32_t i) const {
  const auto& oscillation = *surroundings.walls->oscillation;
  const int axis = surroundings.walls->axis;
  const Real& acceleration = surroundings.acceleration[axis];
  const auto& sphere = spheres[i];
  const auto& departure = moving_walls->departure(i);
  if (departure.collisions != 0 && departure.collisions == sphere.collisions) {
    const Real phase = moving_walls->phase(departure.time);
    return {{oscillation, phase, Real(0), departure.speed, acceleration},
            clock.remainder_at(departure.time)};
  }
  const Real phase = moving_walls->phase({clock.now().units, sphere.time});
  const auto state = oscillation.at(phase);
  return {{oscillation, phase, wall_place(i, sphere.time) - state.height,
           sphere.velocity[axis] - state.speed, acceleration},
          sphere.time};
}

template <int Dim, class Real>
Real System<Dim, Real>::wall_place(std::int32_t i, const Real& when) const {
  return spheres.position_at(i, when)[surroundings.walls->axis] - radius(i);
}

template <int Dim, class Real>
Real System<Dim, Real>::wall_gap(std::int32_t i, int wall, const Real& when) const {
  if (surroundings.walls->oscillates(wall)) {
    const auto [gap, from] = oscillating_gap(i);
    return gap.at(when - from).gap;
  }
  const int axis = surroundings.walls->axis;
  const Real place = spheres.position_at(i, when)[axis];
  const Real radius = this->radius(i);
  return wall == 0 ? place - radius : (box().sides()[axis] - radius) - place;
}

template <int Dim, class Real>
Real System<Dim, Real>::widest_wall_gap(std::int32_t i, int wall, const Real& from,
                                        const Real& contact) const {
  if (surroundings.walls->oscillates(wall)) {
    const auto [gap, start] = oscillating_gap(i);
    const Real half_way = (contact - start) / 2 + (from - start) / 2;
    return std::max(gap.at(from - start).gap, gap.at(half_way).gap);
  }
  const int axis = surroundings.walls->axis;
  const Real outward = wall == 0 ? -1 : 1;
  return widest_gap<Real>(wall_gap(i, wall, from), -outward * spheres.velocity_at(i, from)[axis],
                          -outward * surroundings.acceleration[axis]);
}

template <int Dim, class Real>
Vec<Dim, Real> System<Dim, Real>::wall_velocity(int side) const {
  const Walls<Real>& walls = *surroundings.walls;
  Vector velocity;
  if (walls.axis != 0) velocity[0] = walls.speed[static_cast<std::size_t>(side)];
  if (walls.oscillates(side)) {
    velocity[walls.axis] = walls.oscillation->at(moving_walls->phase(clock.now())).speed;
  }
  return velocity;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template struct System<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
