#include "verify/log_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace zenosphere::verify {
namespace {

bool has(const CollisionRow& row, std::uint8_t flag) { return (row.flags & flag) != 0; }

template <class T>
std::string shown(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "null";
}

template <class T>
void require_equal(const std::string& key, const T& told, const T& counted, Findings& findings) {
  if (told == counted) return;
  findings.add(fmt::format("summary: {} = {} (the log has {})", key, told, counted));
}

template <class T>
void require_equal(const std::string& key, const std::optional<T>& told,
                   const std::optional<T>& counted, Findings& findings) {
  if (told == counted) return;
  findings.add(fmt::format("summary: {} = {} (the log has {})", key, shown(told), shown(counted)));
}

}  // namespace

bool LogCheck::observe(const CollisionRow& row, Findings& findings) {
  const bool is_usable = check_values(row, findings);
  check_order(row, findings);
  check_flags(row, findings);
  add(row);
  last_ = row;
  return is_usable;
}

bool LogCheck::check_values(const CollisionRow& row, Findings& findings) const {
  const std::int64_t partners = spheres_ + (values_.walls.axis ? 2 : 0);
  const bool is_pair = row.i >= 0 && row.i < row.j && row.i < spheres_ && row.j < partners;
  if (!is_pair) {
    findings.add(fmt::format("collision {}: i = {}, j = {} (must be 0 <= i < j < {}, i < {})",
                             row.k, row.i, row.j, partners, spheres_));
  }
  // An overlap sets the clock back, before the start too, and behind the end of the run: far back
  // where all but rest, from where check_order() asks for its flags.
  const double slack = 1e-3 * (1 + last_time_);
  const bool is_rewound = values_.collision.overlap == OverlapRule::rewind;
  const bool is_in_time = row.time >= -slack && std::isfinite(row.time) &&
                          (is_rewound || row.time <= last_time_ + slack) &&
                          std::isfinite(row.normal_speed);
  if (!is_in_time) {
    findings.add(fmt::format("collision {}: time = {}, normal_speed = {} (the file ends at {})",
                             row.k, row.time, row.normal_speed, last_time_));
  }
  return is_pair && is_in_time;
}

void LogCheck::check_order(const CollisionRow& row, Findings& findings) const {
  const bool stood = has(row, collision_flag::clock_stood);
  const double before = last_ ? last_->time : 0.0;
  const std::int64_t first =
      values_.output.collision_log == CollisionLog::window ? values_.output.log_first : 1;
  const std::int64_t expected = last_ ? last_->k + 1 : first;
  if (row.k != expected) {
    findings.add(fmt::format("collision {}: follows {} in the log (must be {})", row.k,
                             last_ ? fmt::format("{}", last_->k) : "nothing", expected));
    return;
  }
  if (!last_ && row.k > 1) return;
  if (row.time < before && !(has(row, collision_flag::overlap) && stood)) {
    findings.add(
        fmt::format("collision {}: time = {} (before {}, that of the collision before, "
                    "without the flags of an overlap)",
                    row.k, row.time, before));
  } else if (row.time > before && stood) {
    findings.add(
        fmt::format("collision {}: flag 16, the clock did not move (it did, from {} to {})", row.k,
                    before, row.time));
  }
}

void LogCheck::check_flags(const CollisionRow& row, Findings& findings) const {
  const double threshold = values_.collapse.gap_threshold.nearest_double();
  const bool is_hit = row.gap <= threshold;
  // A finer number may have been above it.
  const bool is_open = row.gap >= threshold && row.gap <= loosest_threshold_;
  if (is_hit != has(row, collision_flag::hit) && !is_open) {
    findings.add(fmt::format("collision {}: gap = {}, flags = {} (flag 1 is for gaps <= {})", row.k,
                             row.gap, row.flags, threshold));
  }
  if (!(row.normal_speed > 0) != has(row, collision_flag::receding)) {
    findings.add(
        fmt::format("collision {}: normal_speed = {}, flags = {} (flag 8 is for pairs that "
                    "recede)",
                    row.k, row.normal_speed, row.flags));
  }
  if (has(row, collision_flag::made_elastic) && values_.collision.contact_duration == 0) {
    findings.add(
        fmt::format("collision {}: flags = {} (flag 32 is for contacts that last, and "
                    "collision.contact_duration = 0)",
                    row.k, row.flags));
  }
  const bool may_rest = values_.walls.motion && row.j == spheres_;
  if (has(row, collision_flag::resting) && !may_rest) {
    findings.add(fmt::format(
        "collision {}: flags = {} (flag 128 is for spheres that rest on a wall that oscillates)",
        row.k, row.flags));
  }
  if (has(row, collision_flag::sliding) && !law_.is_rough()) {
    findings.add(fmt::format(
        "collision {}: flags = {} (flag 64 is for rough spheres that slide, and these are smooth)",
        row.k, row.flags));
  }
}

void LogCheck::add(const CollisionRow& row) {
  ++collisions_;
  absorbed_ += has(row, collision_flag::absorbed);
  overlapped_ += has(row, collision_flag::overlap);
  receding_ += has(row, collision_flag::receding);
  made_elastic_ += has(row, collision_flag::made_elastic);
  if (has(row, collision_flag::hit)) {
    if (++separation_.hits == 1) {
      separation_.first_collision = row.k;
      separation_.first_time = row.time;
    }
    separation_.last_collision = row.k;
    const double pause = row.time - separation_.last_time.value_or(row.time);
    separation_.longest_pause = std::max(separation_.longest_pause, pause);
    separation_.last_time = row.time;
  }
  dissipated_ += law_.loss(row);
}

std::optional<Law::Number> LogCheck::take_dissipated() {
  const bool walls_rub = values_.walls.axis && values_.walls.tangential_restitution != -1;
  if (walls_rub || !law_.tells_losses()) return std::nullopt;
  return std::exchange(dissipated_, 0);
}

void LogCheck::compare(const Summary& summary, Findings& findings) const {
  require_equal("collisions", summary.collisions, collisions_, findings);
  require_equal("absorbed", summary.absorbed, absorbed_, findings);
  require_equal("overlap_collisions", summary.overlap_collisions, overlapped_, findings);
  require_equal("receding", summary.receding, receding_, findings);
  require_equal("contact.made_elastic", summary.contact.made_elastic, made_elastic_, findings);
  const auto& told = summary.separation;
  require_equal("separation.hits", told.hits, separation_.hits, findings);
  require_equal("separation.first_collision", told.first_collision, separation_.first_collision,
                findings);
  require_equal("separation.first_time", told.first_time, separation_.first_time, findings);
  require_equal("separation.last_collision", told.last_collision, separation_.last_collision,
                findings);
  if (!told.last_time) return;  // not told by older versions
  require_equal("separation.last_time", told.last_time, separation_.last_time, findings);
  require_equal("separation.longest_pause", told.longest_pause, separation_.longest_pause,
                findings);
}

}  // namespace zenosphere::verify
