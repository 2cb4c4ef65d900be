#include <fmt/format.h>

#include "result/summary.hpp"

namespace zenosphere {

namespace {

std::string left_sentence(const Summary& summary) {
  const auto& separation = summary.separation;
  std::string last = fmt::format("collision {}", separation.last_collision.value_or(0));
  if (separation.last_time) last += fmt::format(", time {:.6g}", *separation.last_time);
  return fmt::format(
      "No arrest: this computation met the separation criterion and left it again, the last time "
      "at\n"
      "{}. Whether the spheres had collapsed, and rounding led them out of it,\n"
      "or only came close, is for zenosphere adjudicate to tell.",
      last);
}

std::string arrest_sentence(const Summary& summary) {
  const std::string text =
      "Collapse: this computation met the arrest criterion. The same few pairs collide again and\n"
      "again without separating, and time stands still at machine precision.";
  const std::int64_t others = summary.arrest.others_moving.value_or(0);
  if (others == 0) return text;
  return text +
         fmt::format("\n{} other sphere{} still moving and held up too: all share one clock.",
                     others, others == 1 ? " was" : "s were");
}

}  // namespace

Course course_of(const Summary& summary) {
  return {.collisions = summary.collisions,
          .collisions_per_sphere = summary.collisions_per_sphere,
          .time = summary.time,
          .is_at_rest = summary.ended_by == EndedBy::at_rest,
          .is_arrested = summary.arrest.met,
          .window = summary.arrest.window,
          .last_hit = summary.separation.last_collision,
          .last_hit_time = summary.separation.last_time,
          .longest_pause = summary.separation.longest_pause};
}

std::string verdict_sentence(const Summary& summary) {
  switch (summary.verdict) {
    case Verdict::none:
      return "No collapse: no two spheres about to collide ever came as close as the threshold.";
    case Verdict::temporary:
      return left_sentence(summary);
    case Verdict::open:
      return "Undecided: this computation was still meeting the separation criterion when it "
             "ended,\nand had not met the arrest criterion; a longer run decides.";
    case Verdict::arrested:
      return arrest_sentence(summary);
  }
  return "";
}

}  // namespace zenosphere
