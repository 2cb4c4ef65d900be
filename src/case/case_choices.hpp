#pragma once

#include <array>

#include "case/case.hpp"
#include "model/word_table.hpp"

namespace zenosphere::case_format {

// The words that keys take.
inline constexpr std::array arrangement_words{
    Word{"fcc", Arrangement::fcc}, Word{"random", Arrangement::random},
    Word{"given", Arrangement::given}, Word{"file", Arrangement::file}};
inline constexpr std::array drive_words{Word{"none", DriveKind::none},
                                        Word{"shear", DriveKind::shear},
                                        Word{"random", DriveKind::random}};
inline constexpr std::array axis_words{Word{"x", Axis::x}, Word{"y", Axis::y}, Word{"z", Axis::z}};
inline constexpr std::array overlap_words{
    Word{"rewind", OverlapRule::rewind}, Word{"immediate", OverlapRule::immediate},
    Word{"guarded", OverlapRule::guarded}, Word{"stop", OverlapRule::stop}};
inline constexpr std::array law_words{
    Word{"constant", RestitutionLaw::constant}, Word{"viscoelastic", RestitutionLaw::viscoelastic},
    Word{"fixed-loss", RestitutionLaw::fixed_loss}, Word{"two-valued", RestitutionLaw::two_valued}};
inline constexpr std::array log_words{Word{"all", CollisionLog::all},
                                      Word{"window", CollisionLog::window},
                                      Word{"none", CollisionLog::none}};
inline constexpr std::array distribution_words{Word{"uniform", SizeDistribution::uniform},
                                               Word{"normal", SizeDistribution::normal},
                                               Word{"lognormal", SizeDistribution::lognormal}};
inline constexpr std::array motion_words{Word{"sinusoidal", OscillationShape::sinusoidal},
                                         Word{"parabolic", OscillationShape::parabolic}};
inline constexpr std::array spacing_words{Word{"linear", SnapshotSpacing::linear},
                                          Word{"log", SnapshotSpacing::logarithmic}};

/// All words of a choice.
inline const auto& words_of(Arrangement) { return arrangement_words; }
inline const auto& words_of(DriveKind) { return drive_words; }
inline const auto& words_of(Axis) { return axis_words; }
inline const auto& words_of(OverlapRule) { return overlap_words; }
inline const auto& words_of(RestitutionLaw) { return law_words; }
inline const auto& words_of(CollisionLog) { return log_words; }
inline const auto& words_of(SnapshotSpacing) { return spacing_words; }
inline const auto& words_of(OscillationShape) { return motion_words; }
inline const auto& words_of(SizeDistribution) { return distribution_words; }

/// The word for a choice.
template <class Choice>
const char* word_for(Choice choice) {
  return word_in(words_of(choice), choice);
}

}  // namespace zenosphere::case_format
