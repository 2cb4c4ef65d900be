// The gaps that a log tells, compared with those of the replay.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/instantiate.hpp"
#include "verify/replay.hpp"

namespace zenosphere::verify {

/// The distance that the pair of a row had to close at the last change: in the image that it
/// meets, or as far as it gets from the wall before it falls back. Nothing is said where it is not
/// known which image that was: their places at contact tell.
template <int Dim>
typename Replay<Dim>::Gap Replay<Dim>::gap_before(const CollisionRow& row) {
  if (criteria_version_ < 2) return shortest_gap_before(row);
  if (wall(row.j) == 0 && lower_wall_.oscillates()) return gap_to_oscillating_wall(row);
  const Meeting<Dim> then = meeting_at(row, last_change_, row.time);
  const Number flown = then.speed * motion_.clock_error(row.time);
  if (const auto side = wall(row.j)) return apex(then, *side);
  const Meeting<Dim> contact = meeting_at(row, row.time, row.time);
  if (!(contact.error <= motion_.shortest_side() / 4)) return {then.gap, Motion<Dim>::unknown};
  const auto gap_of = [&](const Meeting<Dim>& meeting) {
    return Gap{meeting.gap, (meeting.error + flown) / meeting.sigma +
                                4 * double_rounding * std::abs(meeting.gap)};
  };
  const Gap gap = gap_of(then);
  if (body(row.i).is_held == body(row.j).is_held) return gap;
  // One falls off the other and back: the wider one of the gaps then and half-way.
  const Gap half_way = gap_of(meeting_at(row, (last_change_ + Number(row.time)) / 2, row.time));
  return {std::max(gap.value, half_way.value), std::max(gap.error, half_way.error)};
}

/// The same as files of the first version have it: where the two were nearest then. Of spheres far
/// apart nothing is said: which image was that?
template <int Dim>
typename Replay<Dim>::Gap Replay<Dim>::shortest_gap_before(const CollisionRow& row) {
  const Meeting<Dim> then = meeting_at(row, last_change_, last_change_);
  if (!wall(row.j) && then.gap > 0.45L * motion_.shortest_side() - 1) {
    return {then.gap, Motion<Dim>::unknown};
  }
  return {then.gap, then.error + then.speed * motion_.clock_error(row.time) +
                        4 * double_rounding * std::abs(then.gap)};
}

/// How far from a wall a sphere gets that gravity leads back to it: rise^2 / (2 G) above where it
/// is. Whether it rises may be in doubt by the error of its speed.
template <int Dim>
typename Replay<Dim>::Gap Replay<Dim>::apex(const Meeting<Dim>& then, int wall) const {
  const Number outward = wall == 0 ? -1 : 1;
  const Number pull =
      motion_.closed_axis() ? outward * motion_.acceleration()[*motion_.closed_axis()] : Number(0);
  const Number rise = std::max<Number>(-then.closing, 0);
  Gap gap{then.gap, then.error + then.speed * motion_.clock_error(last_change_) +
                        4 * double_rounding * std::abs(then.gap)};
  if (!(pull > 0)) return gap;
  gap.value += rise * rise / (2 * pull);
  gap.error +=
      (rise + then.closing_error / 2) * then.closing_error / pull + 4 * double_rounding * gap.value;
  return gap;
}

/// Compares the gap that the row before has for this pair.
template <int Dim>
void Replay<Dim>::check_last_gap(const CollisionRow& row, Findings& findings) {
  if (!last_ || std::isnan(last_->gap)) return;
  const Gap then = gap_before(row);
  if (!(then.error <= most_error) || std::abs(then.value - last_->gap) <= then.error) return;
  findings.add(fmt::format(
      "collision {}: gap = {} (spheres {} and {}, which collide next, have {:.6g} to close within "
      "{:.2g})",
      last_->k, last_->gap, row.i, row.j, static_cast<double>(then.value),
      static_cast<double>(then.error)));
}

#define ZENOSPHERE_INSTANTIATE(Dim)                                                \
  template typename Replay<Dim>::Gap Replay<Dim>::gap_before(const CollisionRow&); \
  template void Replay<Dim>::check_last_gap(const CollisionRow&, Findings&);
ZENOSPHERE_FOR_EACH_DIMENSION(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere::verify
