// SPDX-License-Identifier: MIT
// Corners of a gray image: FAST-9 (Rosten and Drummond, "Machine learning for high-speed corner detection", ECCV 2006)
// with non-maximum suppression, and a steered binary descriptor of 256 comparisons (BRIEF: Calonder et al., ECCV 2010;
// steered by the intensity centroid: Rublee et al., "ORB", ICCV 2011). One scale, and integers only, so that one image
// gives the same features on every processor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/image.h"

namespace reorient {

/// The luma of an image, without its colors.
struct LumaPlane {
  LumaPlane() = default;
  explicit LumaPlane(const ImageView& image);

  std::uint8_t at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }

  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  std::vector<std::uint8_t> pixels;
};

/// Distance in pixels that a corner keeps from the image's border, so that its patch lies inside of the image.
inline constexpr int kCornerMargin = 18;

struct Corner {
  int x = 0;      ///< pixels
  int y = 0;      ///< pixels
  int score = 0;  ///< largest contrast (luma steps) at which it is still a corner, minus 1
  bool operator==(const Corner&) const = default;
};

/// The corners in the first `rows` rows of an image, in the order of rows and columns. 9 contiguous pixels of a circle
/// of 16 around a corner are all brighter, or all darker, than the corner by more than `contrast` luma steps. Of
/// adjacent corners only the one with the best score is returned. Empty for an image that is smaller than a patch.
std::vector<Corner> find_corners(const LumaPlane& image, int rows, int contrast);

/// One bit for each comparison of two pixels in the patch.
using CornerDescriptor = std::array<std::uint64_t, 4>;

/// Number of bits that differ, 0 to 256.
int distance(const CornerDescriptor& a, const CornerDescriptor& b);

/// Describes corners of one image, which must outlive this object.
class CornerDescriber {
 public:
  /// Prepares the first `rows` rows and what the patches of their corners need below.
  CornerDescriber(const LumaPlane& image, int rows);

  /// Direction from the corner to the patch's center of brightness, in 32nds of a turn from the image's x axis to its y
  /// axis; 0 in an even patch. `corner` keeps kCornerMargin from the borders, as those of find_corners() do.
  int direction_of(const Corner& corner) const;
  /// The comparisons, turned with the patch by its direction.
  CornerDescriptor describe(const Corner& corner) const;

 private:
  int smoothed(int x, int y) const {
    return sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_->width) + static_cast<std::size_t>(x)];
  }

  const LumaPlane* image_;
  std::vector<std::uint16_t> sums_;  // of the 5x5 pixels around each pixel; 0 near the border
};

}  // namespace reorient
