#include "result/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "result/averages_output.hpp"
#include "result/field_json.hpp"
#include "result/summary_line.hpp"
#include "result/summary_species.hpp"
#include "text/counted.hpp"
#include "text/json.hpp"

namespace zenosphere {
namespace {

/// What has ended the run, where that is no limit of its case and needs words.
std::string end_sentence(const Summary& s) {
  if (s.ended_by == EndedBy::at_rest) return "at rest: no collision will ever come";
  if (s.ended_by == EndedBy::clock) return "clock: the next collision is beyond its end";
  if (s.ended_by == EndedBy::idle) return "idle: no spheres have met for too long; set run.time";
  return word(s.ended_by);
}

/// What a reader must know before the verdict of a run that was not let go on to its end.
std::string interruption_text(const Summary& s, const std::string& kept) {
  if (s.self_check) return fmt::format("Ended by a self-check: {}\n\n", *s.self_check);
  if (s.outcome != Outcome::interrupted) return "";
  return fmt::format("Interrupted at collision {}, time {:.6g}{}.\nUp to there: ", s.collisions,
                     s.time,
                     kept.empty() ? ", and not kept (no -o)"
                                  : fmt::format("; zenosphere resume {} goes on with it", kept));
}

std::string run_lines(const Summary& s) {
  return line("outcome", fmt::format("{} (ended by: {})", word(s.outcome), end_sentence(s))) +
         line("collisions",
              fmt::format("{} ({:.6g} per sphere)", s.collisions, s.collisions_per_sphere)) +
         line("time", s.strain == 0 ? fmt::format("{:.6g}", s.time)
                                    : fmt::format("{:.6g} (strain {:.6g})", s.time, s.strain));
}

std::string separation_text(const Summary::Separation& separation) {
  if (!separation.first_collision) return "never met";
  const std::int64_t first = *separation.first_collision;
  const double time = separation.first_time.value_or(0);
  if (separation.hits == 1) return fmt::format("1 hit, collision {}, at time {:.6g}", first, time);
  return fmt::format("{} hits, collisions {} to {}, first at time {:.6g}", separation.hits, first,
                     separation.last_collision.value_or(0), time);
}

/// The first few pairs; a cluster can have hundreds.
std::string pairs_text(const std::vector<std::pair<std::int64_t, std::int64_t>>& pairs) {
  constexpr std::size_t shown = 6;
  std::string text;
  for (std::size_t k = 0; k < std::min(shown, pairs.size()); ++k) {
    text += fmt::format("{}{}-{}", k == 0 ? "" : " ", pairs[k].first, pairs[k].second);
  }
  if (pairs.size() > shown) text += fmt::format(" and {} more", pairs.size() - shown);
  return text;
}

std::string arrested_text(const Summary::Arrest& arrest) {
  const std::int64_t others = arrest.others_moving.value_or(0);
  if (others == 0) return pairs_text(arrest.pairs);
  return fmt::format("{}; {} other sphere{} still moving", pairs_text(arrest.pairs), others,
                     others == 1 ? "" : "s");
}

std::string arrest_text(const Summary::Arrest& arrest) {
  if (!arrest.met) return fmt::format("not met, window {} collisions", arrest.window);
  return fmt::format("met at collision {}, time {:.6g}, window {} collisions",
                     arrest.collision.value_or(0), arrest.time.value_or(0), arrest.window);
}

std::string series_text(const Summary::Arrest& arrest) {
  return fmt::format("{:.15g}, where flights shrink by {:.6g} from one to the next",
                     arrest.extrapolated_time.value_or(0), arrest.flight_ratio.value_or(0));
}

std::string factor_text(std::string_view name, const std::optional<double>& ratio) {
  return ratio ? fmt::format("; {} x {:.4g}", name, *ratio) : "";
}

std::string dissected_line(std::string_view name, const Summary::Dissected& d) {
  const std::string factors = factor_text("gap", d.gap_ratio) +
                              factor_text("speed", d.speed_ratio) +
                              factor_text("flight", d.flight_ratio);
  return line(name, fmt::format("{}, a chain of {}, straightness {:.6g}{}{}",
                                counted(d.spheres, "sphere"), d.chain.size(), d.straightness,
                                factors, factors.empty() ? "" : " per collision"));
}

std::string anatomy_lines(const Summary::Anatomy& anatomy) {
  return (anatomy.hit ? dissected_line("cluster at first hit", *anatomy.hit) : "") +
         (anatomy.arrest ? dissected_line("cluster at arrest", *anatomy.arrest) : "");
}

std::string criteria_lines(const Summary& s) {
  return line("separation criterion", separation_text(s.separation)) +
         line("arrest criterion", arrest_text(s.arrest)) +
         (s.arrest.met ? line("arrested pairs", arrested_text(s.arrest)) : "") +
         (s.arrest.extrapolated_time ? line("collapse time", series_text(s.arrest)) : "") +
         line("odd collisions",
              fmt::format("{} absorbed, {} overlapping, {} receding; {} overlaps ignored",
                          s.absorbed, s.overlap_collisions, s.receding, s.overlaps_ignored));
}

/// What the law of restitution and the contact models came to.
std::string contact_line(const Summary::Contact& contact) {
  if (!contact.mean_restitution) return "";
  return line("mean restitution",
              fmt::format("{:.6g} ({} made elastic, {} rotated)", *contact.mean_restitution,
                          counted(contact.made_elastic, "collision"), contact.rotated));
}

std::string cost_lines(const Summary& s) {
  constexpr double mebibyte = 1024.0 * 1024.0;
  return line("energy ledger", fmt::format("closed to {:.2g} (relative)", s.ledger_error)) +
         line("wall time", fmt::format("{:.3g} s ({:.3g} collisions/s)", s.wall_seconds,
                                       s.collisions_per_second)) +
         line("peak memory",
              fmt::format("{:.1f} MiB", static_cast<double>(s.peak_memory_bytes) / mebibyte));
}

std::string averages_text(const Summary& summary, int dimension) {
  if (summary.averages) return text_of(*summary.averages, summary.collisions, dimension);
  return fmt::format("no averages: time {:.6g} is not beyond measure.after_time\n", summary.time);
}

}  // namespace

std::string to_json(const Summary& summary, int dimension) {
  Json json = Json::object();
  Summary::fields(summary, [&]<class T>(const Field& field, const T& member) {
    if constexpr (std::is_same_v<T, std::optional<Averages>>) {
      json[field.name] = json_of(member, dimension);
    } else {
      json[field.name] = field_json(member);
    }
  });
  if (summary.species.empty()) json.erase("species");
  return json.dump();
}

std::string to_text(const Summary& summary, int dimension, const std::string& kept) {
  std::string text = interruption_text(summary, kept);
  text += verdict_sentence(summary) + "\n\n";
  text += run_lines(summary) + criteria_lines(summary);
  text += anatomy_lines(summary.anatomy) + contact_line(summary.contact) + cost_lines(summary);
  text += '\n' + averages_text(summary, dimension);
  text += species_lines(summary);
  return text;
}

}  // namespace zenosphere
