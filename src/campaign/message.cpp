#include "campaign/message.hpp"

#include <nlohmann/json.hpp>

namespace zenosphere {

namespace {

using Json = nlohmann::json;

/// Texts of the user may hold bytes that are no UTF-8, which JSON cannot.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string to_message(const TaskMessage& task) {
  Json json = {{"run", task.run}, {"case", task.case_text}};
  if (task.wall_seconds) json["wall_seconds"] = *task.wall_seconds;
  return dump(json);
}

TaskMessage task_from_message(const std::string& text) {
  const Json json = Json::parse(text);
  TaskMessage task{json.at("run").get<std::int64_t>(), json.at("case").get<std::string>(), {}};
  if (json.contains("wall_seconds")) task.wall_seconds = json["wall_seconds"].get<double>();
  return task;
}

std::string to_message(const RunResult& result, int dimension) {
  Json json = {{"run", result.run}, {"dimension", dimension}};
  if (const auto* failure = std::get_if<Failure>(&result.outcome)) json["error"] = failure->error;
  if (const auto* summary = std::get_if<Summary>(&result.outcome)) {
    json["summary"] = to_json(*summary, dimension);
  }
  return dump(json);
}

RunResult result_from_message(const std::string& text) {
  const Json json = Json::parse(text);
  const auto run = json.at("run").get<std::int64_t>();
  if (json.contains("error")) return {run, Failure{json["error"].get<std::string>()}};
  if (!json.contains("summary")) return {run, Dropped{}};
  try {
    return {run,
            summary_from_json(json["summary"].get<std::string>(), json.at("dimension").get<int>())};
  } catch (const std::exception& error) {
    return {run, Failure{error.what()}};
  }
}

}  // namespace zenosphere
