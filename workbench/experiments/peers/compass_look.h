// What the compared methods said in one stretch of looking about: plain data.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace reorient {

inline constexpr std::array<std::string_view, 7> kCompassMethods{
    "room awareness",      "its paper recipe",   "colour transitions", "horizon features",
    "single row of tiles", "four rows of tiles", "half icosahedron"};

/// After how many seconds of looking about a method is asked; 0: after a single frame.
inline constexpr std::array<double, 3> kLookTimes{0.0, 1.0, 3.0};

/// What one method said at each of these times.
struct CompassScores {
  std::array<double, kLookTimes.size()> if_right{};      ///< of a belief that is right
  std::array<double, kLookTimes.size()> if_reflected{};  ///< of the reflection of that belief
};
/// One stretch of looking about, by method.
using CompassLook = std::array<CompassScores, kCompassMethods.size()>;

/// Its numbers in their order, to be read or written.
template <typename Visit, typename Look>
void visit_scores(Visit&& visit, Look& look) {
  for (auto& scores : look) {
    for (auto& score : scores.if_right) visit(score);
    for (auto& score : scores.if_reflected) visit(score);
  }
}

}  // namespace reorient
