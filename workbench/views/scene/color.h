// SPDX-License-Identifier: MIT
// The colors of all views, with the same meaning everywhere: blue is the believed pose, red is the mirrored pose, amber
// is the truth, magenta is the belief of the view filter.
#pragma once

#include <cstdint>

namespace reorient::scene {

/// sRGB.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  double opacity = 1.0;  ///< 0: invisible, 1: opaque

  constexpr Color with_opacity(double new_opacity) const { return {red, green, blue, new_opacity}; }
  bool operator==(const Color&) const = default;
};

/// Converts the camera's YCbCr (full-range BT.601 as in JPEG). Levels beyond a byte are clamped.
Color to_color(double luma, double cb, double cr);

/// The evidence of a tile as a color: blue for the believed pose, gray for neither, red for the mirrored pose. The
/// color is full from kFullEvidence on. `log_odds`: positive for the mirrored pose; gray if it is not finite.
Color evidence_color(double log_odds);
inline constexpr double kFullEvidence = 1.0;

namespace palette {

inline constexpr Color page{251, 251, 249};
inline constexpr Color ink{36, 42, 51};
inline constexpr Color faint_ink{112, 120, 131};
inline constexpr Color grid{226, 229, 232};
inline constexpr Color plate{207, 212, 218};  ///< behind histograms; black and white are both visible on it
inline constexpr Color empty_plate{236, 238, 240};

inline constexpr Color carpet{104, 156, 104};
inline constexpr Color carpet_border{92, 142, 93};
inline constexpr Color field_line{250, 252, 250};
inline constexpr Color white_goal{255, 255, 255};
inline constexpr Color yellow_goal{255, 214, 10};

inline constexpr Color truth{255, 179, 0};
inline constexpr Color belief{21, 88, 214};
inline constexpr Color opposite{212, 48, 52};
inline constexpr Color pose_particle{44, 50, 58, 0.62};
inline constexpr Color view_particle{224, 0, 168};
inline constexpr Color cluster{120, 126, 134};
inline constexpr Color evidence{96, 104, 116};  ///< line of the evidence; the areas below it are belief and opposite
inline constexpr Color goal_area{0, 150, 136};
inline constexpr Color unknown_tile{128, 128, 128, 0.15};
inline constexpr Color no_evidence{190, 195, 201};  ///< of a tile that supports neither pose

inline constexpr Color percept{0, 214, 255};  ///< detections in the image
inline constexpr Color landmark{90, 240, 255};
inline constexpr Color ball{255, 140, 0};
inline constexpr Color obstacle{255, 96, 32};
inline constexpr Color boundary{255, 225, 40};
inline constexpr Color horizon{190, 120, 255};
inline constexpr Color expected = belief.with_opacity(0.9);  ///< prediction of the believed pose in the image
inline constexpr Color tile_outline{255, 255, 255, 0.9};

// Bands that show the status of the room over time, behind dark text.
inline constexpr Color usable_band{191, 229, 204};     ///< the confidences count
inline constexpr Color undecided_band{247, 223, 164};  ///< the room is evaluated, but the confidences do not count
inline constexpr Color idle_band{220, 223, 227};       ///< the room is not evaluated

}  // namespace palette
}  // namespace reorient::scene
