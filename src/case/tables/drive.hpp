#pragma once

#include <array>

#include "model/case_key.hpp"
#include "model/word_table.hpp"

namespace zenosphere {

enum class DriveKind { none, shear, random };
inline constexpr std::array drive_words{Word{"none", DriveKind::none},
                                        Word{"shear", DriveKind::shear},
                                        Word{"random", DriveKind::random}};
inline const auto& words_of(DriveKind) { return drive_words; }

namespace case_format {

inline constexpr When only_sheared{"drive.kind", "",
                                   [](const auto& c) { return c.drive.kind == DriveKind::shear; },
                                   "drive.kind = \"shear\""};
inline constexpr When only_kicked{"drive.kind", "",
                                  [](const auto& c) { return c.drive.kind == DriveKind::random; },
                                  "drive.kind = \"random\""};

/// The table [drive]: what feeds energy to the spheres.
struct Drive {
  DriveKind kind = DriveKind::none;
  double shear_rate = 0;      ///< 1/time
  double noise_strength = 0;  ///< variance of velocity gained per time, diameter^2/time^3
  double kick_interval = 0;   ///< time between kicks

  template <class Visitor>
  void keys(Visitor&& visit) {
    visit(CaseKey{"kind", required, any, "what feeds energy to the spheres"}, kind);
    visit(CaseKey{"shear_rate", required, at_least(0), "gradient of the mean velocity [1/time]"},
          shear_rate, only_sheared);
    visit(CaseKey{"noise_strength", required, above(0),
                  "variance of each velocity component gained per time [diameter^2/time^3]"},
          noise_strength, only_kicked);
    visit(CaseKey{"kick_interval", required, above(0), "time between kicks [time]"}, kick_interval,
          only_kicked);
  }
};

}  // namespace case_format
}  // namespace zenosphere
