// States of the engine to and from archives: what a checkpoint keeps, and which states can be.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/simulation.hpp"
#include "model/archive.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

template <int Dim>
std::vector<std::int32_t> SlidingCells<Dim>::order() const {
  std::vector<std::int32_t> order;
  order.reserve(next_.size());
  for (std::int32_t cell = 0; cell < count(); ++cell) {
    for (std::int32_t id = first(cell); id != kNone; id = next(id)) order.push_back(id);
  }
  return order;
}

template <int Dim>
void SlidingCells<Dim>::restore(int whole_slide, const std::vector<std::int32_t>& order,
                                const std::function<std::int32_t(std::int32_t)>& cell_of) {
  whole_slide_ = whole_slide;
  for (auto id = order.rbegin(); id != order.rend(); ++id) insert(*id, cell_of(*id));
}

template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(const ShearBox<Dim, Real>& box, const Vector& acceleration,
                            ArchiveReader& archive)
    : box_(box),
      cells_(box.cells(), box.is_sheared(), 0, box.closed_axis()),
      acceleration_(acceleration),
      falls_(!(acceleration == Vector{})) {
  archive(spheres_);
  for (const Sphere& sphere : spheres_) require_possible(sphere);
  const auto order = archive.template next<std::vector<std::int32_t>>();
  std::vector<std::int32_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  require_archived(sorted.size() == spheres_.size(), "cells that hold other spheres");
  for (std::int32_t i = 0; i < count(); ++i) {
    require_archived(sorted[static_cast<std::size_t>(i)] == i, "cells that hold other spheres");
  }
  const auto whole_slide = archive.template next<std::int32_t>();
  require_archived(whole_slide >= 0 && whole_slide < box.cells()[0], "layers that left the box");
  cells_ = SlidingCells<Dim>(box.cells(), box.is_sheared(), count(), box.closed_axis());
  cells_.restore(whole_slide, order, [this](std::int32_t i) { return (*this)[i].cell; });
}

template <int Dim, class Real>
void Spheres<Dim, Real>::archive_to(ArchiveWriter& archive) const {
  archive(spheres_, cells_.order(), std::int32_t{cells_.whole_slide()});
}

/// Throws ArchiveError for a sphere that is nowhere in the box.
template <int Dim, class Real>
void Spheres<Dim, Real>::require_possible(const Sphere& sphere) const {
  using std::isfinite;
  bool is_possible = sphere.cell >= 0 && sphere.cell < cells_.count() && isfinite(sphere.time);
  for (int axis = 0; axis < Dim; ++axis) {
    const Real& place = sphere.position[axis];  // a period away: far more than rounding allows
    is_possible = is_possible && isfinite(sphere.velocity[axis]) && place >= -box_.sides()[axis] &&
                  place <= 2 * box_.sides()[axis];
  }
  require_archived(is_possible, "a sphere that is nowhere in the box");
}

template <int Dim, class Real>
Simulation<Dim, Real>::Simulation(const ShearBox<Dim, Real>& box, const ContactRules<Real>& rules,
                                  const Surroundings<Dim, Real>& surroundings,
                                  ArchiveReader& archive)
    : spheres_(box, surroundings.acceleration, archive),
      rules_(rules),
      surroundings_(surroundings),
      calendar_(spheres_.count()) {
  archive(pending_);
  require_archived(!pending_.empty() && pending_.size() == static_cast<std::size_t>(spheres()),
                   "events of another number of spheres");
  archive_clock(*this, archive);
  require_counts(collisions_, cell_crossings_, stale_events_, overlaps_ignored_);
  require_archived(!stopped_before_ || is_pair(stopped_before_->i, stopped_before_->j),
                   "a pair that there is not");
  for (const auto& instant : {now_, last_collision_, last_change_}) {
    require_archived(
        instant.remainder >= earliest_time() && instant.remainder <= 2 * this->box().clock_unit(),
        "a time that there is not");
  }
  apply_models();
  if (contact_physics_) archive(*contact_physics_);
  for (std::int32_t i = 0; i < spheres(); ++i) {
    require_possible(i);
    schedule(i);
  }
}

template <int Dim, class Real>
void Simulation<Dim, Real>::archive_to(ArchiveWriter& archive) const {
  spheres_.archive_to(archive);
  archive(pending_);
  archive_clock(*this, archive);
  if (contact_physics_) archive(*contact_physics_);
}

/// Whether a sphere and one behind it, or a sphere and a wall, can collide.
template <int Dim, class Real>
bool Simulation<Dim, Real>::is_pair(std::int32_t i, std::int32_t j) const {
  return i >= 0 && i < j && i < spheres() && j < partners();
}

/// What no event is before: an overlap leads a little into the past, which the clock counts from
/// its last whole unit; ten thousand units are far beyond any rounding.
template <int Dim, class Real>
Real Simulation<Dim, Real>::earliest_time() const {
  return -10000 * box().clock_unit();
}

/// Throws ArchiveError where sphere i has an event that no prediction makes.
template <int Dim, class Real>
void Simulation<Dim, Real>::require_possible(std::int32_t i) const {
  const Pending& event = pending_[static_cast<std::size_t>(i)];
  const Real never = std::numeric_limits<Real>::infinity();
  const bool meets = event.contact < never;
  const bool crosses = event.crossing < never;
  const bool is_possible =
      event.contact >= earliest_time() && event.contact <= never &&  // and no NaN
      event.crossing >= earliest_time() && event.crossing <= never &&
      (!meets || (event.partner >= 0 && event.partner < partners() && event.partner != i)) &&
      (!crosses || (event.axis >= 0 && event.axis < Dim && std::abs(event.direction) == 1));
  require_archived(is_possible, "an event that there is not");
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                               \
  template std::vector<std::int32_t> SlidingCells<Dim>::order() const;            \
  template void SlidingCells<Dim>::restore(int, const std::vector<std::int32_t>&, \
                                           const std::function<std::int32_t(std::int32_t)>&);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                     \
  template Simulation<Dim, Real>::Simulation(const ShearBox<Dim, Real>&,                      \
                                             const ContactRules<Real>&,                       \
                                             const Surroundings<Dim, Real>&, ArchiveReader&); \
  template void Simulation<Dim, Real>::archive_to(ArchiveWriter&) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
