#pragma once

#include <string_view>

namespace zenosphere {

/// The page without data: HTML with the programs it needs, made from page/ when this program was
/// built. Empty where it was built without npm.
std::string_view page_template();

/// The comment in it that data takes the place of.
inline constexpr std::string_view data_mark = "<!-- zenosphere: data -->";

}  // namespace zenosphere
