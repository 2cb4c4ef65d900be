#include "io/info.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/summary.hpp"

namespace zenosphere {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string to_json(const OutputInfo& info) {
  Json json = info.summary ? Json::parse(to_json(summary_from_json(*info.summary), info.dimension))
                           : Json::object();
  json["file"] = {{"complete", info.complete},
                  {"format_version", info.format_version},
                  {"program_version", info.program_version},
                  {"git_hash", info.git_hash},
                  {"spheres", info.spheres},
                  {"snapshots", info.snapshots},
                  {"logged_collisions", info.logged_collisions},
                  {"last_collision", info.last_collision},
                  {"last_time", info.last_time}};
  return json.dump();
}

std::string to_text(const OutputInfo& info) {
  std::string text;
  if (info.summary) {
    text = to_text(summary_from_json(*info.summary), info.dimension) + '\n';
  } else {
    text = fmt::format(
        "Unfinished: the run was cut off, or is still going on.\n\n"
        "  written up to          collision {}, time {:.6g}\n",
        info.last_collision, info.last_time);
  }
  text += fmt::format("  snapshots               {} of {} spheres\n", info.snapshots, info.spheres);
  text += fmt::format("  logged collisions       {}{}\n", info.logged_collisions,
                      info.log_complete ? " (all)" : "");
  text += fmt::format("  program                 zenosphere {} ({})\n", info.program_version,
                      info.git_hash);
  text += fmt::format("  compiler                {} {}\n", info.compiler, info.compiler_flags);
  return text + '\n' + info.resolved_case;
}

}  // namespace zenosphere
