// SPDX-License-Identifier: MIT
// The paper's color histogram (Section 3.2, Fig. 3): black, white, and 3 slices of luma x 4 quadrants of chroma.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/const_or.h"
#include "geometry/image.h"

namespace reorient {

/// Bin 0 is black, bin 1 white, bin 2 + 4 * slice + quadrant a color; slice 0 is the darkest, and quadrant is
/// (Cb above neutral ? 1 : 0) + (Cr above neutral ? 2 : 0).
inline constexpr int kColorBins = 14;

/// Fractions of the bins. Their sum is 1, or all are 0 if nothing was counted.
using ColorHistogram = std::array<float, kColorBins>;
/// Numbers of pixels in the bins.
using ColorCounts = std::array<std::uint32_t, kColorBins>;

struct ColorParameters {
  double dark_below = 85.0;     ///< c1
  double bright_above = 170.0;  ///< c2
  double gray_within = 5.0;     ///< c3
  double blur = 0.0;
};
template <typename Visit>
void describe(ColorParameters& p, Visit&& visit) {
  visit("dark_below", p.dark_below, 1.0, 254.0, "", "c1: luma below which a color is in the darkest slice");
  visit("bright_above", p.bright_above, 1.0, 255.0, "",
        "c2: luma at and above which a color is in the brightest slice");
  visit("gray_within", p.gray_within, 0.0, 64.0, "",
        "c3: distance of chroma from neutral below which a pixel is black or white");
  visit("blur", p.blur, 0.0, 0.25, "", "fraction of a bin that each of its four neighbors gets");
}

/// The room's light as the camera shows it: means over the wall, which are assumed to be medium gray.
struct Light {
  double luma = 115.0;
  double cb = 128.0;
  double cr = 128.0;
};
template <typename Visit, ConstOr<Light> T>
void fields(Visit&& visit, T& light) {
  visit(light.luma, light.cb, light.cr);
}
/// Whether all three values are possible for a byte.
bool is_sound(const Light& light);

/// The light at one position relative to the light of the room. It does not change with exposure and white balance.
struct RelativeLight {
  double luma = 1.0;  ///< fraction of the room's
  double cb = 0.0;    ///< difference from the room's
  double cr = 0.0;    ///< the same
};
template <typename Visit, ConstOr<RelativeLight> T>
void fields(Visit&& visit, T& light) {
  visit(light.luma, light.cb, light.cr);
}
RelativeLight relative(const Light& place, const Light& room);

/// Thresholds of the 14 regions for image bytes. They follow the light, so that pixels need no correction.
struct ColorThresholds {
  std::uint8_t medium = 85;          ///< luma at and above which a color is in slice 1
  std::uint8_t bright = 170;         ///< luma at and above which a color is in slice 2
  std::uint8_t white = 128;          ///< luma at and above which a gray pixel is white
  std::uint8_t cb_neutral = 128;     ///< Cb at and above which a color is in quadrant 1 or 3
  std::uint8_t cr_neutral = 128;     ///< Cr at and above which a color is in quadrant 2 or 3
  std::uint8_t cb_gray_first = 124;  ///< gray: both chroma values are within first...last
  std::uint8_t cb_gray_last = 132;
  std::uint8_t cr_gray_first = 124;
  std::uint8_t cr_gray_last = 132;
  bool operator==(const ColorThresholds&) const = default;
};

/// Thresholds under a given light: luma scaled by light.luma / 115, chroma relative to the light's.
ColorThresholds color_thresholds(const ColorParameters& parameters, const Light& light = {});

/// The bin of one pixel by the definition, for readers and tests.
int color_bin(const Ycbcr& pixel, const ColorThresholds& thresholds);

ColorHistogram normalized(const ColorCounts& counts);

/// Moves `fraction` of each bin to each of its four neighbors: the slices above and below (black below the
/// darkest slice, white above the brightest) and the two quadrants that differ in one sign. The sum is unchanged.
ColorHistogram blurred(const ColorHistogram& histogram, double fraction);

}  // namespace reorient
