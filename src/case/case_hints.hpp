#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include "case/case.hpp"

namespace zenosphere::case_format {

/// What users of other programs type, and where it is here.
struct Hint {
  std::string_view typed, instead;
};

inline constexpr std::array drive_hints{
    Hint{"gravity", "gravity has a table of its own: [gravity] acceleration"},
    Hint{"vibration", "a plate that vibrates is a wall: [walls] motion"},
    Hint{"vibrated", "a plate that vibrates is a wall: [walls] motion"},
    Hint{"walls", "walls have a table of their own: [walls] axis"},
    Hint{"thermal",
         "walls can be thermal ([walls] lower_temperature); \"random\" kicks all spheres"},
    Hint{"thermostat", "\"random\" kicks all spheres"}};

/// Keys that there are not, with their table.
inline constexpr std::array key_hints{Hint{"system.box", "system.sides"},
                                      Hint{"system.length", "system.sides"},
                                      Hint{"system.size", "system.sides"},
                                      Hint{"system.density", "system.solids_volume_fraction"},
                                      Hint{"system.phi", "system.solids_volume_fraction"},
                                      Hint{"system.particles", "system.spheres"},
                                      Hint{"system.n", "system.spheres"},
                                      Hint{"system.N", "system.spheres"},
                                      Hint{"system.e", "system.restitution"},
                                      Hint{"system.gravity", "gravity.acceleration"},
                                      Hint{"drive.gravity", "gravity.acceleration"},
                                      Hint{"drive.amplitude", "walls.amplitude"},
                                      Hint{"drive.frequency", "walls.frequency"},
                                      Hint{"run.strain", "run.time"}};

template <std::size_t Size>
std::optional<std::string_view> hint_among(const std::array<Hint, Size>& hints,
                                           std::string_view typed) {
  for (const Hint& hint : hints) {
    if (hint.typed == typed) return hint.instead;
  }
  return std::nullopt;
}

/// What to write in place of a word that a choice does not have; nothing where none is known.
template <class Choice>
std::optional<std::string_view> hint_for_word(std::string_view typed) {
  if constexpr (std::is_same_v<Choice, DriveKind>) return hint_among(drive_hints, typed);
  return std::nullopt;
}

}  // namespace zenosphere::case_format
