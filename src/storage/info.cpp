#include "storage/info.hpp"

#include <fmt/format.h>

#include "result/summary.hpp"
#include "text/counted.hpp"
#include "text/json.hpp"
#include "text/printable.hpp"

namespace zenosphere {

namespace {

/// What the run came to: in the end, or until its last checkpoint.
std::optional<Summary> summary_in(const OutputInfo& info) {
  if (info.summary) return summary_from_json(*info.summary, info.dimension);
  if (!info.checkpoint || info.checkpoint->summary.empty()) return std::nullopt;
  return summary_from_json(info.checkpoint->summary, info.dimension);
}

/// What zenosphere adjudicate has found, or null.
Json adjudication_in(const OutputInfo& info) {
  if (!info.adjudication) return {};
  Json json = Json::parse(*info.adjudication, nullptr, false);
  return json.is_object() ? json : Json();
}

std::string adjudication_line(const OutputInfo& info) {
  const Json json = adjudication_in(info);
  if (json.is_null()) return "";
  const auto text = [&](const char* key) {
    return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "?";
  };
  return fmt::format("  adjudicated             {}: {}\n", text("finding"), text("sentence"));
}

/// Nothing where it was not examined.
Json word(Integrity integrity) {
  switch (integrity) {
    case Integrity::unread:
      return {};
    case Integrity::unknown:
      return "none";
    case Integrity::values_unchanged:
      return "values unchanged";
    case Integrity::bytes_unchanged:
      return "bytes unchanged";
  }
  return {};
}

}  // namespace

std::string to_json(const OutputInfo& info) {
  Json json = Json::object();
  if (const auto summary = summary_in(info)) json = Json::parse(to_json(*summary, info.dimension));
  json["file"] = {{"complete", info.complete},
                  {"format_version", info.format_version},
                  {"program_version", info.program_version},
                  {"git_hash", info.git_hash},
                  {"spheres", info.spheres},
                  {"snapshots", info.snapshots},
                  {"logged_collisions", info.logged_collisions},
                  {"last_collision", info.last_collision},
                  {"last_time", info.last_time},
                  {"checksums", word(info.integrity)},
                  {"extended_to", info.is_extended ? Json(info.checkpoint->collisions) : Json()},
                  {"adjudication", adjudication_in(info)}};
  return json.dump();
}

std::string to_text(const OutputInfo& info, const std::string& name) {
  std::string text;
  if (!info.complete) {
    text = fmt::format(
        "Unfinished: the run was cut off, or is still going on; zenosphere resume {} goes on.\n\n"
        "  written up to           collision {}, time {:.6g}\n",
        name, info.last_collision, info.last_time);
  }
  if (const auto summary = summary_in(info)) {
    if (!info.complete) text += "\nUp to there: ";
    text += to_text(*summary, info.dimension, name) + '\n';
  }
  if (info.is_extended) {
    text +=
        fmt::format("  made longer             up to collision {}, time {:.6g}; not ended yet\n",
                    info.checkpoint->collisions, info.checkpoint->time);
  }
  text += adjudication_line(info);
  text += fmt::format("  snapshots               {} of {}\n", info.snapshots,
                      counted(info.spheres, "sphere"));
  text += fmt::format("  logged collisions       {}{}\n", info.logged_collisions,
                      info.log_complete ? " (all)" : "");
  text += fmt::format("  checksums               {}\n", sentence(info.integrity));
  text += fmt::format("  program                 zenosphere {} ({})\n", info.program_version,
                      info.git_hash);
  text += fmt::format("  compiler                {} {}\n", info.compiler, info.compiler_flags);
  return printable(text + '\n' + info.resolved_case);
}

}  // namespace zenosphere
