#include "collapse/verdict.hpp"

#include <algorithm>

namespace zenosphere {

namespace {

Verdict verdict_where(bool is_left, const Course& course) {
  if (course.is_arrested) return Verdict::arrested;
  if (!course.last_hit) return Verdict::none;
  return is_left ? Verdict::temporary : Verdict::open;
}

std::int64_t collisions_since_hit(const Course& course) {
  return course.collisions - course.last_hit.value_or(0);
}

}  // namespace

bool is_left(const Course& course) {
  if (course.is_at_rest) return true;
  const double flight = course.time / course.collisions_per_sphere;
  const double longest = std::max(flight, course.longest_pause);
  if (course.last_hit_time && course.time - *course.last_hit_time > longest) return true;
  const auto since = static_cast<double>(collisions_since_hit(course));
  const double share = since / static_cast<double>(course.collisions);
  return collisions_since_hit(course) > course.window && share * course.collisions_per_sphere >= 1;
}

Verdict verdict(const Course& course) { return verdict_where(is_left(course), course); }

Verdict verdict_by_window(const Course& course) {
  return verdict_where(collisions_since_hit(course) > course.window, course);
}

}  // namespace zenosphere
