#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/field.hpp"
#include "result/ended_by.hpp"
#include "text/json.hpp"

namespace zenosphere {

template <HasFields Part>
Json json_of_fields(const Part& part);

/// A field as it stands in JSON: a choice as its word, an absent value as null, a part as an
/// object.
template <class T>
Json field_json(const T& value) {
  if constexpr (HasFields<T>) {
    return json_of_fields(value);
  } else if constexpr (std::is_enum_v<T>) {
    return word(value);
  } else {
    return Json(value);
  }
}
inline Json field_json(const std::optional<EndedBy>& ended_by) { return word(ended_by); }
template <class T>
Json field_json(const std::optional<T>& value) {
  return value ? field_json(*value) : Json(nullptr);
}
template <class T>
Json field_json(const std::vector<T>& values) {
  Json json = Json::array();
  for (const T& value : values) json.push_back(field_json(value));
  return json;
}
inline Json field_json(const std::pair<std::int64_t, std::int64_t>& pair) {
  return Json::array({pair.first, pair.second});
}

/// An object of the fields of a part, in their order.
template <HasFields Part>
Json json_of_fields(const Part& part) {
  Json json = Json::object();
  Part::fields(
      part, [&](const Field& field, const auto& member) { json[field.name] = field_json(member); });
  return json;
}

}  // namespace zenosphere
