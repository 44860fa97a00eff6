// SPDX-License-Identifier: MIT
// Results of the compared methods in one period of looking around: plain data.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace reorient {

inline constexpr std::array<std::string_view, 8> kCompassMethods{
    "room awareness",      "its paper recipe",   "colour transitions", "horizon features",
    "single row of tiles", "four rows of tiles", "half icosahedron",   "corner landmarks"};
/// Whether a rule is known by which the method flips the pose.
inline constexpr std::array<bool, kCompassMethods.size()> kHasFlipRule{true,  true,  false, false,
                                                                       false, false, false, true};

/// After how many seconds of looking around a method is evaluated; 0: after a single frame.
inline constexpr std::array<double, 3> kLookTimes{0.0, 1.0, 3.0};

/// Results of one method at each of these times.
struct CompassScores {
  std::array<double, kLookTimes.size()> if_right{};      ///< of a belief that is right
  std::array<double, kLookTimes.size()> if_reflected{};  ///< of the reflection of that belief
  /// 1: its own rule has flipped the pose by then; 0: it has not, or no rule is known.
  std::array<double, kLookTimes.size()> flips_if_right{};
  std::array<double, kLookTimes.size()> flips_if_reflected{};
};
/// One period of looking around, by method.
using CompassLook = std::array<CompassScores, kCompassMethods.size()>;

/// Visits its numbers in a fixed order, for reading and writing.
template <typename Visit, typename Look>
void visit_scores(Visit&& visit, Look& look) {
  for (auto& scores : look) {
    for (auto& score : scores.if_right) visit(score);
    for (auto& score : scores.if_reflected) visit(score);
    for (auto& flips : scores.flips_if_right) visit(flips);
    for (auto& flips : scores.flips_if_reflected) visit(flips);
  }
}

}  // namespace reorient
