#include "collapse/verdict.hpp"

namespace zenosphere {

Verdict verdict(std::int64_t collisions, std::optional<std::int64_t> last_hit, bool arrest_is_met,
                std::int64_t window) {
  if (arrest_is_met) return Verdict::arrested;
  if (!last_hit) return Verdict::none;
  return collisions - *last_hit > window ? Verdict::temporary : Verdict::open;
}

const char* word(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return "none";
    case Verdict::temporary:
      return "temporary";
    case Verdict::open:
      return "open";
    case Verdict::arrested:
      return "true";
  }
  return "";
}

}  // namespace zenosphere
