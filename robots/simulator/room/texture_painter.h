// SPDX-License-Identifier: MIT
// Paints a picture in linear light with soft edges. Coordinates are in meters from the bottom left corner.
#pragma once

#include <algorithm>
#include <utility>

#include "geometry/random.h"
#include "robots/simulator/room/texture.h"

namespace reorient {

/// An upright rectangle in meters.
struct Area {
  double left = 0.0;
  double bottom = 0.0;
  double right = 0.0;
  double top = 0.0;

  double width() const { return right - left; }
  double height() const { return top - bottom; }
  Area inset(double margin) const { return {left + margin, bottom + margin, right - margin, top - margin}; }
};

class TexturePainter {
 public:
  /// At least `per_meter` texels per meter; the size of the picture is valid for a Texture.
  TexturePainter(double width, double height, double per_meter, const LinearColor& color);
  /// Paints over an image of this many meters.
  TexturePainter(double width, double height, LinearImage image)
      : width_(width), height_(height), image_(std::move(image)) {}

  void rectangle(const Area& area, const LinearColor& color, double opacity = 1.0);
  void ellipse(double x, double y, double radius_x, double radius_y, const LinearColor& color, double opacity = 1.0);
  /// Multiplies the light by a factor from `below` at the area's lower edge to `above` at its upper edge.
  void shade(const Area& area, double below, double above);
  /// Multiplies the light by smooth noise with a standard deviation of about `strength` and blobs of `size` meters.
  void mottle(const Area& area, double strength, double size, Random& random);

  const LinearImage& image() const { return image_; }
  Eigen::Vector2d extent() const { return {width_, height_}; }

 private:
  /// Calls paint(color at that texel, coverage in 0...1, x, y) for every texel that the area touches.
  template <typename Paint>
  void for_each(const Area& area, Paint&& paint);

  double width_;
  double height_;
  LinearImage image_;
};

/// The color for hue (in turns), saturation and value in [0, 1], as on a screen.
LinearColor paint_of(double hue, double saturation, double value);

/// Interval from which a random number is drawn.
struct Range {
  double low = 0.0;
  double high = 1.0;
};
/// A random color: draws the value, then the saturation, then the hue unless it is given.
LinearColor any_paint(double hue, const Range& saturation, const Range& value, Random& random);
LinearColor any_paint(const Range& hue, const Range& saturation, const Range& value, Random& random);

}  // namespace reorient
