#include "report/run_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "case/case_choices.hpp"
#include "case/case_grains.hpp"
#include "report/samples_json.hpp"
#include "storage/info.hpp"
#include "text/json.hpp"

namespace zenosphere {
namespace {

Json json_of(const std::optional<DecayRate>& rate) {
  if (!rate) return {};
  return {{"ratio", rate->ratio}, {"spread", rate->spread}};
}

Json json_of(const Decay& decay) {
  Json json{{"cycle", decay.cycle},
            {"resolution", decay.resolution},
            {"gap", json_of(decay.gap)},
            {"speed", json_of(decay.speed)},
            {"flight", json_of(decay.flight)},
            {"exact", nullptr},
            {"collapse_time", or_null(decay.collapse_time)},
            {"collapse_time_error", decay.error_since_start()}};
  if (decay.exact) {
    json["exact"] = {
        {"gap", decay.exact->gap}, {"speed", decay.exact->speed}, {"flight", decay.exact->flight}};
  }
  return json;
}

Json json_of(const Cluster& cluster) {
  Json contacts = Json::array();
  for (const auto& contact : cluster.contacts) {
    contacts.push_back({contact.i, contact.j, contact.collisions});
  }
  return {{"spheres", cluster.spheres}, {"positions", cluster.positions},
          {"contacts", contacts},       {"chain", cluster.chain},
          {"bends", cluster.bends},     {"straightness", cluster.straightness}};
}

Json json_of(const ClusterCollisions& rows) {
  Json json = Json::object();
  ClusterCollisions::fields(rows,
                            [&](const char* name, const auto& column) { json[name] = column; });
  return json;
}

Json json_of(const std::optional<Dissection>& dissection) {
  if (!dissection) return {};
  Json clusters = Json::array();
  for (const auto& cluster : dissection->clusters) clusters.push_back(json_of(cluster));
  return {{"collision", dissection->collision},
          {"time", dissection->time},
          {"pairs", dissection->pairs},
          {"clusters", clusters},
          {"collisions", json_of(dissection->collisions)},
          {"decay", json_of(dissection->decay)}};
}

/// The word of the case file, but "fixed loss" as people write it.
std::string law_text(RestitutionLaw law) {
  return law == RestitutionLaw::fixed_loss ? "fixed loss" : case_format::word_for(law);
}

/// What the page needs to know of the case, in numbers and words.
Json json_of(const Case& values) {
  const auto& walls = values.walls.axis;
  const bool is_constant = values.collision.restitution_law == RestitutionLaw::constant;
  return {{"restitution", is_constant ? Json(values.system.restitution) : Json()},
          {"restitution_law", law_text(values.collision.restitution_law)},
          {"solids_volume_fraction", values.system.solids_volume_fraction},
          {"drive", case_format::word_for(values.drive.kind)},
          {"shear_rate", values.drive.kind == DriveKind::shear ? values.drive.shear_rate : 0.0},
          {"walls", walls ? Json(case_format::word_for(*walls)) : Json()},
          {"gap_threshold", values.collapse.gap_threshold.nearest_double()},
          {"window", values.collapse.window},
          {"seed", values.start.seed}};
}

/// Radii and kinds of the spheres, or null where all are unit spheres.
Json grains_json(const Case& values) {
  const Grains<double> grains = grains_of(values);
  if (grains.are_alike()) return {};
  std::vector<double> radii;
  for (const double diameter : grains.diameters) radii.push_back(diameter / 2);
  Json names = Json::array();
  for (const Species& species : values.species) names.push_back(species.name);
  return {{"radii", radii}, {"kinds", grains.kinds}, {"names", names}};
}

/// Text of a file that should be JSON, or null where it is not.
Json parsed(const std::optional<std::string>& text) {
  if (!text) return {};
  Json json = Json::parse(*text, nullptr, false);
  return json.is_discarded() ? Json() : json;
}

Json json_of(const Frames& frames) {
  return {{"step", frames.step},
          {"time", frames.time},
          {"granular_temperature", frames.granular_temperature},
          {"shown", frames.shown},
          {"box_edges", frames.box_edges}};
}

/// A number with as many digits as a plot shows; null where it is not finite.
Json short_number(double number) {
  if (!std::isfinite(number)) return {};
  return std::strtod(fmt::format("{:.7g}", number).c_str(), nullptr);
}

/// The end of each interval, and of each average its numbers, row after row.
Json json_of(const RecordedSeries& series) {
  Json columns = Json::object();
  for (const RecordedSeries::Column& column : series.columns) {
    Json& numbers = columns[column.name] = Json::array();
    for (const double number : column.values) numbers.push_back(short_number(number));
  }
  return {{"time", series.time}, {"columns", columns}};
}

Json json_of(const std::vector<StretchName>& stretches) {
  Json json = Json::array();
  for (const auto& stretch : stretches) {
    json.push_back({{"name", stretch.name},
                    {"width", stretch.width},
                    {"bins", stretch.bins},
                    {"last", stretch.last}});
  }
  return json;
}

Json json_of(const std::vector<PairCount>& pairs) {
  Json json = Json::array();
  for (const auto& pair : pairs) json.push_back({pair.i, pair.j, pair.collisions});
  return json;
}

}  // namespace

std::string run_json(const std::string& name, const RunReader& file, const Case& values,
                     const Frames& frames, const std::vector<StretchName>& stretches,
                     const std::vector<PairCount>& pairs) {
  const OutputInfo& info = file.info();
  const Anatomy anatomy = file.anatomy();
  const Json json{{"kind", "run"},
                  {"name", name},
                  {"dimension", info.dimension},
                  {"spheres", info.spheres},
                  {"case_text", info.case_text},
                  {"resolved_case", info.resolved_case},
                  {"compiler", info.compiler},
                  {"compiler_flags", info.compiler_flags},
                  {"log_complete", info.log_complete},
                  {"values", json_of(values)},
                  {"grains", grains_json(values)},
                  {"summary", Json::parse(to_json(info))},
                  {"anatomy", {{"hit", json_of(anatomy.hit)}, {"arrest", json_of(anatomy.arrest)}}},
                  {"adjudication", parsed(info.adjudication)},
                  {"snapshots", json_of(frames)},
                  {"series", json_of(file.series())},
                  {"samples", samples_json(file.samples(), values)},
                  {"log", json_of(stretches)},
                  {"pairs", json_of(pairs)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace zenosphere
