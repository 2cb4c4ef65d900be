#include "result/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "model/errors.hpp"
#include "support/summaries.hpp"

namespace zenosphere {
namespace {

using test::collapsed_summary;
using test::planar_averages;

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> result;
  for (const auto& item : object.items()) result.push_back(item.key());
  return result;
}

TEST(Summary, JsonHasTheFixedKeysInTheirOrderAndOursBehindThem) {
  const auto json = Json::parse(to_json(collapsed_summary(), 2));
  EXPECT_EQ(keys(json), (std::vector<std::string>{"collisions",
                                                  "collisions_per_sphere",
                                                  "time",
                                                  "strain",
                                                  "outcome",
                                                  "verdict",
                                                  "separation",
                                                  "arrest",
                                                  "absorbed",
                                                  "averages",
                                                  "ledger_error",
                                                  "wall_seconds",
                                                  "collisions_per_second",
                                                  "peak_memory_bytes",
                                                  "ended_by",
                                                  "overlap_collisions",
                                                  "overlaps_ignored",
                                                  "receding",
                                                  "contact",
                                                  "anatomy",
                                                  "self_check"}));
  EXPECT_EQ(keys(json["separation"]),
            (std::vector<std::string>{"hits", "first_collision", "first_time", "last_collision",
                                      "last_time", "longest_pause"}));
  EXPECT_EQ(keys(json["arrest"]),
            (std::vector<std::string>{"met", "collision", "time", "window", "pairs",
                                      "extrapolated_time", "flight_ratio", "others_moving"}));
  EXPECT_EQ(
      keys(json["averages"]),
      (std::vector<std::string>{
          "granular_temperature", "temperature_diagonal", "pressure", "pressure_tensor",
          "collision_rate", "dissipation", "compressibility_factor", "shear_work", "normal_speed",
          "other_work", "wall_pressure", "from_time", "to_time", "blocks", "steady",
          "steady_reason", "streak_amplitude", "temperature_without_streak", "standard_error"}));
}

TEST(Summary, JsonIsOneLine) {
  EXPECT_EQ(to_json(collapsed_summary(), 2).find('\n'), std::string::npos);
}

TEST(Summary, JsonTellsACollapseWithItsPairs) {
  const auto json = Json::parse(to_json(collapsed_summary(), 2));
  EXPECT_EQ(json["verdict"], "true");
  EXPECT_EQ(json["separation"].dump(),
            R"({"hits":12,"first_collision":70,"first_time":0.25,"last_collision":90,)"
            R"("last_time":0.5,"longest_pause":0.125})");
  EXPECT_EQ(json["arrest"].dump(),
            R"({"met":true,"collision":88,"time":0.5,"window":10,"pairs":[[0,3],[1,3]],)"
            R"("extrapolated_time":null,"flight_ratio":null,"others_moving":1})");
}

TEST(Summary, JsonHasNullWhereACriterionWasNeverMet) {
  Summary summary;
  summary.arrest.window = 10;
  const auto json = Json::parse(to_json(summary, 3));
  EXPECT_EQ(json["separation"].dump(),
            R"({"hits":0,"first_collision":null,"first_time":null,"last_collision":null,)"
            R"("last_time":null,"longest_pause":0.0})");
  EXPECT_EQ(json["arrest"].dump(),
            R"({"met":false,"collision":null,"time":null,"window":10,"pairs":[],)"
            R"("extrapolated_time":null,"flight_ratio":null,"others_moving":null})");
}

TEST(Summary, JsonHasTensorsAsArraysOfRows) {
  auto summary = collapsed_summary();
  summary.averages = planar_averages();
  const auto averages = Json::parse(to_json(summary, 2))["averages"];
  EXPECT_EQ(averages["temperature_diagonal"].dump(), "[0.125,0.075]");
  EXPECT_EQ(averages["pressure_tensor"].dump(), "[[1.0,2.0],[3.0,4.0]]");
}

TEST(Summary, JsonHasAveragesOfNullsWhereNothingWasAveraged) {
  const auto averages = Json::parse(to_json(collapsed_summary(), 2))["averages"];
  ASSERT_EQ(averages.size(), 19u);
  for (const auto& [key, value] : averages.items()) {
    EXPECT_EQ(value.is_null(), key != "standard_error") << key;
  }
  for (const auto& value : averages["standard_error"]) EXPECT_TRUE(value.is_null());
}

TEST(Summary, JsonHasNullForANumberThatIsNotFinite) {
  auto summary = collapsed_summary();
  summary.collisions_per_second = std::numeric_limits<double>::infinity();
  summary.separation.first_time = std::nan("");
  summary.averages = planar_averages();
  summary.averages->temperature_diagonal[1] = std::nan("");
  const auto json = Json::parse(to_json(summary, 2));
  EXPECT_TRUE(json["collisions_per_second"].is_null());
  EXPECT_TRUE(json["separation"]["first_time"].is_null());
  EXPECT_EQ(json["averages"]["temperature_diagonal"].dump(), "[0.125,null]");
}

TEST(Summary, JsonKeepsEveryBitOfANumber) {
  auto summary = collapsed_summary();
  // Numbers that 15 or 16 digits lose, the smallest double, and a count beyond 2^53.
  for (const double value : {0.1 + 0.2, 1.0 / 3, 5e-324, 1e-16, std::nextafter(1.0, 2.0)}) {
    summary.time = value;
    EXPECT_EQ(Json::parse(to_json(summary, 2))["time"].get<double>(), value);
  }
  summary.collisions = (std::int64_t{1} << 53) + 1;
  EXPECT_EQ(Json::parse(to_json(summary, 2))["collisions"].get<std::int64_t>(), summary.collisions);
}

TEST(Summary, IsReadBackFromItsJson) {
  Summary summary = collapsed_summary();
  const std::string without = to_json(summary, 2);
  EXPECT_EQ(to_json(summary_from_json(without, 2), 2), without);
  summary.averages = planar_averages();
  EXPECT_EQ(to_json(summary_from_json(to_json(summary, 2), 2), 2), to_json(summary, 2));
  summary.averages->blocks = 20;
  summary.averages->standard_error = planar_averages();
  summary.averages->standard_error->normal_speed = std::nan("");
  const std::string with = to_json(summary, 2);
  EXPECT_EQ(to_json(summary_from_json(with, 2), 2), with);
  EXPECT_THROW(summary_from_json("{}", 2), InputError);
  EXPECT_THROW(summary_from_json("[1, 2", 2), InputError);
}

TEST(Summary, ErrorsHaveTheKeysAndShapesOfTheAverages) {
  auto summary = collapsed_summary();
  summary.averages = planar_averages();
  summary.averages->standard_error = planar_averages();
  summary.averages->standard_error->pressure = std::nan("");
  const auto averages = Json::parse(to_json(summary, 2))["averages"];
  for (const auto& [key, error] : averages["standard_error"].items()) {
    EXPECT_EQ(error.is_array(), averages[key].is_array()) << key;
    const std::size_t size = error.is_array() ? averages[key].size() : error.size();
    EXPECT_EQ(error.size(), size) << key;
  }
  EXPECT_EQ(averages["standard_error"]["pressure_tensor"].dump(), "[[1.0,2.0],[3.0,4.0]]");
  EXPECT_TRUE(averages["standard_error"]["pressure"].is_null());
}

TEST(Summary, IsReadBackWhereAveragesAreNoNumbersOfDouble) {
  Summary summary = collapsed_summary();
  summary.averages = planar_averages();
  summary.averages->dissipation = summary.averages->temperature_diagonal[1] =
      summary.averages->pressure_tensor[2] = std::numeric_limits<double>::infinity();
  const std::string text = to_json(summary, 2);
  EXPECT_EQ(to_json(summary_from_json(text, 2), 2), text);
  EXPECT_TRUE(Json::parse(text)["averages"]["pressure_tensor"][1][0].is_null());
}

Summary::Dissected dissected_chain() {
  Summary::Dissected found;
  found.collision = 70;
  found.time = 0.25;
  found.clusters = 2;
  found.spheres = 5;
  found.contacts = 4;
  found.chain = {4, 2, 3, 8, 9};
  found.straightness = 0.995;
  found.cycle = 4;
  found.gap_ratio = 0.5;
  found.collapse_time = 0.25000001;
  found.collapse_time_error = 1e-9;
  return found;
}

TEST(Summary, KeepsTheAnatomyInItsJsonAndTellsItInWords) {
  Summary summary = collapsed_summary();
  EXPECT_TRUE(Json::parse(to_json(summary, 2))["anatomy"]["hit"].is_null());
  summary.anatomy.hit = dissected_chain();
  const std::string json = to_json(summary, 2);
  EXPECT_EQ(Json::parse(json)["anatomy"]["hit"]["chain"].dump(), "[4,2,3,8,9]");
  EXPECT_TRUE(Json::parse(json)["anatomy"]["hit"]["speed_ratio"].is_null());
  EXPECT_EQ(to_json(summary_from_json(json, 2), 2), json);
  EXPECT_NE(to_text(summary, 2)
                .find("cluster at first hit    5 spheres, a chain of 5, straightness "
                      "0.995; gap x 0.5 per collision\n"),
            std::string::npos);
}

TEST(Summary, IsReadFromAFileThatHasNoAnatomyOrContactModels) {
  auto json = Json::parse(to_json(collapsed_summary(), 2));
  json.erase("anatomy");
  json.erase("contact");
  EXPECT_FALSE(summary_from_json(json.dump(), 2).anatomy.hit);
}

TEST(Summary, WithoutAFieldThatEveryVersionWroteIsRefused) {
  const auto whole = Json::parse(to_json(collapsed_summary(), 2));
  EXPECT_NO_THROW(summary_from_json(whole.dump(), 2));
  for (const char* key : {"collisions", "absorbed", "ledger_error", "receding"}) {
    auto json = whole;
    json.erase(key);
    EXPECT_THROW(summary_from_json(json.dump(), 2), InputError) << key;
  }
  auto json = whole;
  json["separation"].erase("hits");
  EXPECT_THROW(summary_from_json(json.dump(), 2), InputError);
}

TEST(Summary, WithAListThatIsNoneIsRefused) {
  auto json = Json::parse(to_json(collapsed_summary(), 2));
  json["arrest"]["pairs"] = 7;
  EXPECT_THROW(summary_from_json(json.dump(), 2), InputError);
}

TEST(Summary, PressureOnWallsIsThatOnTwoOrNone) {
  Summary summary;
  summary.averages = planar_averages();
  auto json = Json::parse(to_json(summary, 2));
  json["averages"]["wall_pressure"] = std::vector<double>{0.5, 0.25};
  EXPECT_NO_THROW(summary_from_json(json.dump(), 2));
  json["averages"]["wall_pressure"] = std::vector<double>{0.5};
  EXPECT_THROW(summary_from_json(json.dump(), 2), InputError);
}

/// What is said of a summary whose member `key` is `word`.
std::string refusal(const char* key, const char* word) {
  auto json = Json::parse(to_json(collapsed_summary(), 2));
  json[key] = word;
  try {
    summary_from_json(json.dump(), 2);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Summary, WordThatIsInNoTableIsRefusedWithThoseThatAre) {
  EXPECT_EQ(refusal("verdict", "maybe"),
            "/zenosphere/summary: verdict = \"maybe\", which is none of \"none\", \"temporary\", "
            "\"open\", \"true\" (the file is damaged); run the case again");
  EXPECT_NE(refusal("outcome", "lost").find("outcome = \"lost\", which is none of"),
            std::string::npos);
  EXPECT_NE(refusal("ended_by", "lunch").find("ended_by = \"lunch\", which is none of"),
            std::string::npos);
  EXPECT_EQ(refusal("ended_by", "at rest"), "");
}

TEST(Summary, ReadsBackEveryWordAndARunThatHasNotEnded) {
  Summary summary = collapsed_summary();
  for (const auto& word : ended_by_words) {
    summary.ended_by = word.choice;
    summary.outcome = outcome_of(summary.ended_by);
    const Summary read = summary_from_json(to_json(summary, 2), 2);
    EXPECT_EQ(read.ended_by, word.choice) << word.text;
    EXPECT_EQ(read.outcome, summary.outcome) << word.text;
  }
  summary.ended_by.reset();
  EXPECT_EQ(Json::parse(to_json(summary, 2))["ended_by"], "");
  EXPECT_FALSE(summary_from_json(to_json(summary, 2), 2).ended_by);
}

}  // namespace
}  // namespace zenosphere
