#include "verify/snapshot_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/case_box.hpp"
#include "flow/overlaps.hpp"

namespace zenosphere::verify {
namespace {

/// Relative errors that sums over a long run may gather by rounding; the longest stay below 1e-11.
constexpr double gathered_rounding = 1e-8;

std::string place(const Snapshot& snapshot) {
  return fmt::format("snapshot at collision {}, time {}", snapshot.step, snapshot.time);
}

}  // namespace

SnapshotCheck::SnapshotCheck(const Case& values, double last_time, const Grains<double>& grains)
    : values_(values),
      last_time_(last_time),
      grains_(grains),
      sides_(box_sides(values)),
      acceleration_(values.gravity.acceleration),
      closed_(closed_axis(values)) {
  acceleration_.resize(sides_.size(), 0.0);
  const auto spheres = static_cast<std::size_t>(values.system.spheres);
  for (std::size_t i = 0; i < spheres; ++i) mass_ += mobile_mass(i);
}

/// Of an immobile sphere nothing counts.
SnapshotCheck::Number SnapshotCheck::mobile_mass(std::size_t i) const {
  const auto sphere = static_cast<std::int32_t>(i);
  return grains_.is_immobile(sphere) ? 0 : Number(grains_.mass(sphere));
}

SnapshotCheck::Number SnapshotCheck::turning_energy(const Snapshot& snapshot) const {
  const Number inertia = reduced_moment_of_inertia(values_);
  const std::size_t axes = sides_.size() == 3 ? 3 : 1;
  Number sum = 0;
  for (std::size_t at = 0; at < snapshot.angular_velocities.size(); ++at) {
    const Number surface = Number(snapshot.angular_velocities[at]) *
                           grains_.radius(static_cast<std::int32_t>(at / axes));
    sum += inertia * mobile_mass(at / axes) * surface * surface / 2;
  }
  return sum;
}

bool SnapshotCheck::observe(const Snapshot& snapshot, std::optional<Number> lost,
                            Findings& findings) {
  if (!check_numbers(snapshot, findings)) return false;
  const bool may_lean = values_.start.arrangement == Arrangement::file && sides_.size() > 1;
  if (!first_ && may_lean) start_offset_ = snapshot.box_edges[sides_.size()];
  check_box(snapshot, findings);
  check_overlaps(snapshot, findings);
  Sums sums = sums_of(snapshot, lost);
  if (last_) {
    if (sums.step < last_->step || sums.time < last_->time) {
      findings.add(fmt::format("{}: comes after collision {}, time {}", place(snapshot),
                               last_->step, last_->time));
    }
    check_momentum(sums, findings);
    check_energy(sums, findings);
  }
  if (!first_) first_ = sums;
  last_ = std::move(sums);
  return true;
}

bool SnapshotCheck::check_numbers(const Snapshot& snapshot, Findings& findings) const {
  const double latest = last_time_ + 1e-3 * (1 + last_time_);  // an overlap sets the clock back
  if (!(snapshot.time >= 0 && snapshot.time <= latest && snapshot.step >= 0)) {
    findings.add(
        fmt::format("{}: is not within the run, which ends at {}", place(snapshot), last_time_));
    return false;
  }
  const std::size_t dimension = sides_.size();
  for (std::size_t at = 0; at < snapshot.positions.size(); ++at) {
    const double position = snapshot.positions[at];
    const bool is_inside = position >= 0 && position < sides_[at % dimension];
    if (is_inside && std::isfinite(snapshot.velocities[at])) continue;
    findings.add(fmt::format("{}: sphere {} is at {} with velocity {} along {} (0 <= {} < {})",
                             place(snapshot), at / dimension, position, snapshot.velocities[at],
                             axis_letter(static_cast<int>(at % dimension)),
                             axis_letter(static_cast<int>(at % dimension)),
                             sides_[at % dimension]));
    return false;
  }
  return true;
}

void SnapshotCheck::check_box(const Snapshot& snapshot, Findings& findings) const {
  const std::size_t dimension = sides_.size();
  for (std::size_t row = 0; row < dimension; ++row) {
    for (std::size_t column = 0; column < dimension; ++column) {
      const double edge = snapshot.box_edges[row * dimension + column];
      double expected = row == column ? sides_[row] : 0.0;
      double bound = 1e-12 * sides_[row];
      if (row == 1 && column == 0) {
        const double slide = values_.drive.shear_rate * sides_[1] * snapshot.time;
        expected = edge + std::remainder(start_offset_ + slide - edge, sides_[0]);
        bound = 1e-12 * (sides_[0] + slide);
      }
      if (std::abs(edge - expected) <= bound) continue;
      findings.add(fmt::format("{}: box edge {}{} = {} (the case has {})", place(snapshot),
                               axis_letter(static_cast<int>(row)),
                               axis_letter(static_cast<int>(column)), edge, expected));
    }
  }
}

void SnapshotCheck::check_overlaps(const Snapshot& snapshot, Findings& findings) const {
  const double offset = sides_.size() > 1 ? snapshot.box_edges[sides_.size()] : 0.0;
  const Overlap overlap = deepest_overlap(
      {snapshot.positions, sides_, offset, closed_, grains_.diameters, grains_.immobile});
  const double permitted = deepest_permitted(
      values_.collision.overlap, values_.collision.guard, snapshot.time,
      *std::max_element(sides_.begin(), sides_.end()), grains_.largest_diameter());
  if (overlap.depth <= permitted) return;
  findings.add(fmt::format("{}: spheres {} and {} overlap by {:.3g} diameters (at most {:.3g})",
                           place(snapshot), overlap.i, overlap.j, overlap.depth, permitted));
}

SnapshotCheck::Sums SnapshotCheck::sums_of(const Snapshot& snapshot,
                                           std::optional<Number> lost) const {
  const std::size_t dimension = sides_.size();
  Sums sums{.step = snapshot.step, .time = snapshot.time};
  sums.momentum.assign(dimension, 0);
  sums.lost = lost;
  if (!last_) sums.dissipated = lost;
  if (last_ && last_->dissipated && lost) sums.dissipated = *last_->dissipated + *lost;
  for (std::size_t at = 0; at < snapshot.positions.size(); ++at) {
    const std::size_t axis = at % dimension;
    Number velocity = snapshot.velocities[at];
    if (axis == 0 && dimension > 1) {
      velocity -= values_.drive.shear_rate * (snapshot.positions[at + 1] - sides_[1] / 2);
    }
    const Number mass = mobile_mass(at / dimension);
    sums.kinetic += mass * velocity * velocity / 2;
    sums.potential -= mass * Number(acceleration_[axis]) * snapshot.positions[at];
    sums.momentum[axis] += mass * velocity;
    sums.speeds += mass * std::abs(velocity);
  }
  sums.kinetic += turning_energy(snapshot);
  return sums;
}

/// Walls and immobile spheres take momentum up; elsewhere only gravity and the profile change it.
void SnapshotCheck::check_momentum(const Sums& sums, Findings& findings) const {
  if (closed_ || !grains_.immobile.empty()) return;
  const Number time = Number(sums.time) - last_->time;
  const Number scale = std::max(sums.speeds, last_->speeds);
  for (std::size_t axis = 0; axis < sides_.size(); ++axis) {
    const Number pull = mass_ * acceleration_[axis];
    Number expected = last_->momentum[axis] + pull * time;
    if (axis == 0 && sides_.size() > 1) {
      const Number mean = last_->momentum[1] + mass_ * acceleration_[1] * time / 2;
      expected -= values_.drive.shear_rate * mean * time;
    }
    const Number change = sums.momentum[axis] - expected;
    if (std::abs(change) <= gathered_rounding * scale) continue;
    findings.add(
        fmt::format("snapshot at collision {}: momentum along {} differs by {:.3g} from "
                    "that of the snapshot before (of speeds that sum up to {:.3g})",
                    sums.step, axis_letter(static_cast<int>(axis)), change, scale));
  }
}

/// Whether the log tells every change of energy: nothing drives the spheres but gravity between
/// walls, where the way that they fall can be read from the snapshots. Immobile spheres may move
/// and do work.
bool SnapshotCheck::energy_is_closed() const {
  if (!grains_.immobile.empty()) return false;
  const auto& walls = values_.walls;
  if (walls.motion || walls.lower_temperature || walls.upper_temperature) return false;
  for (std::size_t axis = 0; axis < acceleration_.size(); ++axis) {
    if (acceleration_[axis] != 0 && closed_ != static_cast<int>(axis)) return false;
  }
  const bool is_sheared = values_.drive.kind == DriveKind::shear && values_.drive.shear_rate > 0;
  return !is_sheared && values_.drive.kind != DriveKind::random;
}

void SnapshotCheck::check_energy(const Sums& sums, Findings& findings) {
  if (!energy_is_closed() || !sums.dissipated) return;
  ++balances_;
  const Number lost = *sums.lost;
  const Number change = sums.kinetic + sums.potential - (last_->kinetic + last_->potential);
  const Number scale = std::max({sums.kinetic, last_->kinetic, std::abs(sums.potential), lost});
  if (std::abs(change + lost) <= gathered_rounding * scale) return;
  findings.add(
      fmt::format("snapshot at collision {}: energy has changed by {:.12g} since the "
                  "snapshot before (the collisions of the log take {:.12g})",
                  sums.step, change, lost));
}

void SnapshotCheck::compare(const Summary& summary, Findings& findings) const {
  if (!last_) return;
  if (summary.collisions != last_->step || summary.time != last_->time) {
    findings.add(fmt::format("summary: collisions = {}, time = {} (the last snapshot has {}, {})",
                             summary.collisions, summary.time, last_->step, last_->time));
  }
  if (!summary.averages || summary.averages->from_time != 0 || last_->time == 0) return;
  const Averages& averages = *summary.averages;
  Number volume = last_->time;  // and the time
  for (const double side : sides_) volume *= side;
  const Number work = (Number(averages.shear_work) + averages.other_work) * volume;
  const Number lost = averages.dissipation * volume;
  if (!std::isfinite(work) || !std::isfinite(lost)) return;  // beyond double, and told as null
  const Number change = last_->kinetic - first_->kinetic;
  const Number scale = std::max({last_->kinetic, first_->kinetic, std::abs(work), lost});
  // What is averaged over a large volume and a long time may be near the end of double.
  constexpr Number underflow = 4 * std::numeric_limits<double>::denorm_min();
  const Number bound = gathered_rounding * scale + underflow * volume;
  if (!(std::abs(change - work + lost) <= bound)) {
    findings.add(
        fmt::format("summary: work {:.12g} - dissipation {:.12g} (the snapshots' kinetic "
                    "energy has changed by {:.12g})",
                    work, lost, change));
  }
  const bool is_logged = last_->dissipated && first_->dissipated;
  if (is_logged && !(std::abs(*last_->dissipated - *first_->dissipated - lost) <= bound)) {
    findings.add(fmt::format("summary: dissipation {:.12g} in all (the log has {:.12g})", lost,
                             *last_->dissipated - *first_->dissipated));
  }
}

}  // namespace zenosphere::verify
