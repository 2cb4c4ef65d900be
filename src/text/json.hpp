#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace zenosphere {

/// JSON whose keys stay in the order in which they are written. A number that is not finite becomes
/// null in its dump: JSON has no other way to say so.
using Json = nlohmann::ordered_json;

/// A value, or null.
template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace zenosphere
