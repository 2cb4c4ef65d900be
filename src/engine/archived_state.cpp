// States of the engine to and from archives: what a checkpoint keeps, and which states can be.

#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/simulation.hpp"
#include "model/archive.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {

/// Up to which every whole number of boxes is a `double`.
constexpr double most_boxes = 0x1p53;

template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(const ShearBox<Dim, Real>& box, const Vector& acceleration,
                            ArchiveReader& archive)
    : Spheres(archive.template next<Archived>(), box, acceleration, archive) {}

template <int Dim, class Real>
Spheres<Dim, Real>::Spheres(Archived archived, const ShearBox<Dim, Real>& box,
                            const Vector& acceleration, ArchiveReader& archive)
    : Spheres(std::move(archived.first), std::move(archived.second), box, acceleration) {
  grains_.require_fit(spheres_.size());
  read_spins(archive);
  for (const Sphere& sphere : spheres_) require_possible(sphere);
  const auto whole_slide = archive.template next<std::int32_t>();
  require_archived(whole_slide >= 0 && whole_slide < box.cells()[0], "layers that left the box");
  sliding_box_.slide_to(whole_slide);
  read_images(archive);
}

template <int Dim, class Real>
void Spheres<Dim, Real>::read_spins(ArchiveReader& archive) {
  using std::isfinite;
  archive(spins_);
  require_archived(spins_.empty() || spins_.size() == spheres_.size(),
                   "spins of another number of spheres");
  for (const auto& spin : spins_) {
    for (const Real& component : spin.components) {
      require_archived(isfinite(component), "a spin that there is not");
    }
  }
}

/// Where the images of the box are, and those of each sphere.
template <int Dim, class Real>
void Spheres<Dim, Real>::read_images(ArchiveReader& archive) {
  using std::abs;
  const auto offset = archive.template next<Real>();
  const bool may_be_displaced = Dim > 1 && !box().is_closed(0) && !box().is_closed(1);
  require_archived(offset == 0 || (may_be_displaced && 2 * abs(offset) <= box().sides()[0]),
                   "images that there are not");
  sliding_box_.displace_images(offset);
  boxes_ = archive.template next<HugePageVector<Vec<Dim, double>>>();
  require_archived(boxes_.size() == spheres_.size(), "boxes of another number of spheres");
  for (const Vec<Dim, double>& boxes : boxes_) {
    for (const double number : boxes.components) {
      require_archived(std::abs(number) <= most_boxes, "a box that there is not");
    }
  }
}

template <int Dim, class Real>
void Spheres<Dim, Real>::archive_to(ArchiveWriter& archive) const {
  archive(spheres_, grains_, spins_, std::int32_t{cells().whole_slide()}, sliding_box_.offset(),
          boxes_);
}

/// Throws ArchiveError for a sphere that is nowhere in the box.
template <int Dim, class Real>
void Spheres<Dim, Real>::require_possible(const Sphere& sphere) const {
  using std::isfinite;
  bool is_possible = sphere.cell >= 0 && sphere.cell < cells().count() && isfinite(sphere.time);
  for (int axis = 0; axis < Dim; ++axis) {
    is_possible = is_possible && isfinite(sphere.velocity[axis]) && isfinite(sphere.position[axis]);
  }
  require_archived(is_possible, "a sphere that is nowhere in the box");
}

template <int Dim, class Real>
void Predictor<Dim, Real>::archive_events_to(ArchiveWriter& archive) const {
  archive(meetings_);
  std::vector<Real> times;
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    times.push_back(calendar_.time(static_cast<std::int32_t>(i)));
  }
  archive(times);
}

template <int Dim, class Real>
std::vector<Real> Predictor<Dim, Real>::read_meetings(const System<Dim, Real>& system,
                                                      ArchiveReader& archive) {
  archive(meetings_);
  auto times = archive.template next<std::vector<Real>>();
  require_archived(times.size() == meetings_.size(), "times of another number of spheres");
  require_archived(
      !meetings_.empty() && meetings_.size() == static_cast<std::size_t>(system.count()),
      "events of another number of spheres");
  return times;
}

template <int Dim, class Real>
void Predictor<Dim, Real>::schedule_archived(const System<Dim, Real>& system,
                                             const std::vector<Real>& times) {
  for (std::int32_t i = 0; i < system.count(); ++i) {
    const Real& time = times[static_cast<std::size_t>(i)];
    require_possible(system, i);
    require_archived(time >= earliest_time(system.clock) && time <= meetings(i).first().time,
                     "a time that there is not");
    calendar_.schedule(i, time);
  }
}

template <int Dim, class Real>
void Predictor<Dim, Real>::require_possible(const System<Dim, Real>& system, std::int32_t i) const {
  const Real earliest = earliest_time(system.clock);
  const Real never = std::numeric_limits<Real>::infinity();
  const NextMeetings<Real>& next = meetings(i);
  for (const Meeting<Real>& meeting : {next.first(), next.second()}) {
    const bool has_none = !meeting.has_partner() && meeting.time == never;
    const bool is_possible = meeting.time >= earliest && meeting.time <= never &&  // no NaN
                             meeting.partner() < system.partners() && meeting.partner() != i;
    require_archived(is_possible && (meeting.has_partner() || has_none),
                     "an event that there is not");
  }
}

template <int Dim, class Real>
Simulation<Dim, Real>::Simulation(const ShearBox<Dim, Real>& box, const ContactRules<Real>& rules,
                                  const Surroundings<Dim, Real>& surroundings,
                                  ArchiveReader& archive)
    : system_(box, surroundings, archive), rules_(rules), predictor_(system_, rules) {
  const std::vector<Real> times = predictor_.read_meetings(system_, archive);
  typename StrideClock<Real>::State clock;
  archive_course(*this, clock, archive);
  require_counts(collisions(), rebuilds_, stale_events_, overlaps_ignored(), idle_events_);
  require_archived(std::isfinite(clock.stride) && clock.stride >= 1 &&
                       std::ldexp(1.0, std::ilogb(clock.stride)) == clock.stride &&
                       (clock.stride == 1 || !box.is_sheared()),
                   "a clock that there is not");
  system_.clock = StrideClock<Real>(box.clock_unit(), clock);
  require_archived(!stopped_before_ || is_pair(stopped_before_->i, stopped_before_->j),
                   "a pair that there is not");
  const Real earliest = predictor_.earliest_time(system_.clock);
  bool is_possible =
      clock.now.remainder >= earliest && clock.now.remainder <= 2 * system_.clock.span();
  for (const auto& instant : {last_collision_, last_change_}) {
    is_possible = is_possible && system_.clock.since(instant) >= earliest;
  }
  require_archived(is_possible, "a time that there is not");
  require_archived(!rules.table || grains().kind_count() <= rules.table->kinds(),
                   "a kind that there is not");
  make_law();
  if (law_) archive(*law_);
  if (system_.moving_walls) archive(*system_.moving_walls);
  predictor_.schedule_archived(system_, times);
}

template <int Dim, class Real>
void Simulation<Dim, Real>::archive_to(ArchiveWriter& archive) const {
  system_.spheres.archive_to(archive);
  system_.search.archive_to(archive);
  predictor_.archive_events_to(archive);
  archive_course(*this, clock().state(), archive);
  if (law_) archive(*law_);
  if (system_.moving_walls) archive(*system_.moving_walls);
}

/// Whether a sphere and one behind it, or a sphere and a wall, can collide.
template <int Dim, class Real>
bool Simulation<Dim, Real>::is_pair(std::int32_t i, std::int32_t j) const {
  return i >= 0 && i < j && i < spheres() && j < system_.partners();
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                     \
  template Spheres<Dim, Real>::Spheres(const ShearBox<Dim, Real>&, const Vec<Dim, Real>&,     \
                                       ArchiveReader&);                                       \
  template void Predictor<Dim, Real>::archive_events_to(ArchiveWriter&) const;                \
  template std::vector<Real> Predictor<Dim, Real>::read_meetings(const System<Dim, Real>&,    \
                                                                 ArchiveReader&);             \
  template void Predictor<Dim, Real>::schedule_archived(const System<Dim, Real>&,             \
                                                        const std::vector<Real>&);            \
  template Simulation<Dim, Real>::Simulation(const ShearBox<Dim, Real>&,                      \
                                             const ContactRules<Real>&,                       \
                                             const Surroundings<Dim, Real>&, ArchiveReader&); \
  template void Simulation<Dim, Real>::archive_to(ArchiveWriter&) const;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
