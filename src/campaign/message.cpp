#include "campaign/message.hpp"

#include <nlohmann/json.hpp>

namespace zenosphere {

namespace {

using SortedJson = nlohmann::json;

/// Texts of the user may hold bytes that are no UTF-8, which JSON cannot.
std::string dump(const SortedJson& json) {
  return json.dump(-1, ' ', false, SortedJson::error_handler_t::replace);
}

template <class T>
std::optional<T> if_there(const SortedJson& json, const char* name) {
  return json.contains(name) ? std::optional(json[name].get<T>()) : std::nullopt;
}

SortedJson json_of(const AdjudicationRequest& request) {
  SortedJson json = {{"seconds", request.seconds}};
  if (request.groups) json["groups"] = *request.groups;
  if (request.up_to) json["up_to"] = request.up_to->word();
  if (request.collisions) json["collisions"] = *request.collisions;
  return json;
}

AdjudicationRequest request_in(const SortedJson& json) {
  AdjudicationRequest request{.groups = if_there<std::int64_t>(json, "groups"),
                              .seconds = json.at("seconds").get<double>(),
                              .collisions = if_there<std::int64_t>(json, "collisions")};
  if (json.contains("up_to")) {
    request.up_to = Precision::from_word(json["up_to"].get<std::string>());
  }
  return request;
}

SortedJson json_of(const AdjudicationResult& result) {
  if (result.error) return {{"error", *result.error}};
  SortedJson cells = SortedJson::array();
  for (const Cell& cell : result.cells) {
    const auto add = [&](const auto& value) { cells.push_back(value); };
    if (const auto* integer = std::get_if<std::int64_t>(&cell)) {
      add(*integer);
    } else if (const auto* real = std::get_if<double>(&cell)) {
      add(*real);
    } else if (const auto* text = std::get_if<std::string>(&cell)) {
      add(*text);
    } else {
      add(nullptr);
    }
  }
  return {{"cells", cells}};
}

Cell cell_in(const SortedJson& json) {
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return {};
}

std::optional<AdjudicationResult> adjudication_in(const SortedJson& json) {
  if (!json.contains("adjudication")) return std::nullopt;
  const SortedJson& told = json["adjudication"];
  AdjudicationResult result{.error = if_there<std::string>(told, "error")};
  if (result.error) return result;
  for (const SortedJson& cell : told.at("cells")) result.cells.push_back(cell_in(cell));
  return result;
}

}  // namespace

std::string to_message(const TaskMessage& task) {
  SortedJson json = {{"run", task.run}, {"case", task.case_text}};
  const RunRules& rules = task.rules;
  if (rules.wall_seconds) json["wall_seconds"] = *rules.wall_seconds;
  if (rules.adjudicate) json["adjudicate"] = json_of(*rules.adjudicate);
  if (rules.done) {
    json["done"] = SortedJson::object();
    if (rules.done->collisions) json["done"]["collisions"] = *rules.done->collisions;
  }
  return dump(json);
}

TaskMessage task_from_message(const std::string& text) {
  const SortedJson json = SortedJson::parse(text);
  TaskMessage task{json.at("run").get<std::int64_t>(), json.at("case").get<std::string>(), {}};
  task.rules.wall_seconds = if_there<double>(json, "wall_seconds");
  if (json.contains("adjudicate")) task.rules.adjudicate = request_in(json["adjudicate"]);
  if (json.contains("done")) {
    task.rules.done = DoneRun{if_there<std::int64_t>(json["done"], "collisions")};
  }
  return task;
}

std::string to_message(const RunResult& result, int dimension) {
  SortedJson json = {{"run", result.run}, {"dimension", dimension}};
  if (const auto* failure = std::get_if<Failure>(&result.outcome)) json["error"] = failure->error;
  if (const auto* summary = std::get_if<Summary>(&result.outcome)) {
    json["summary"] = to_json(*summary, dimension);
  }
  if (std::holds_alternative<Unchanged>(result.outcome)) json["unchanged"] = true;
  if (result.adjudication) json["adjudication"] = json_of(*result.adjudication);
  return dump(json);
}

RunResult result_from_message(const std::string& text) {
  const SortedJson json = SortedJson::parse(text);
  const auto run = json.at("run").get<std::int64_t>();
  if (json.contains("error")) return {run, Failure{json["error"].get<std::string>()}};
  if (json.contains("unchanged")) return {run, Unchanged{}, adjudication_in(json)};
  if (!json.contains("summary")) return {run, Dropped{}};
  try {
    return {run,
            summary_from_json(json["summary"].get<std::string>(), json.at("dimension").get<int>()),
            adjudication_in(json)};
  } catch (const std::exception& error) {
    return {run, Failure{error.what()}};
  }
}

}  // namespace zenosphere
