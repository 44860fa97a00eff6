// SPDX-License-Identifier: MIT
// A surface to draw on, twice as large as the finished picture, so that all edges are smooth. Coordinates are pixels of
// the finished picture, x right, y down, (0, 0) its top left corner. Coordinates that are not finite are omitted.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

using Pixel = Eigen::Vector2d;

struct Box {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
  Pixel center() const { return {left + width / 2.0, top + height / 2.0}; }
};

enum class Align { left, center, right };

struct TextStyle {
  double size = 20.0;  ///< pixels; the height of a capital letter is 0.7 of it
  Color color = palette::ink;
  Align align = Align::left;
  bool bold = false;
  std::optional<Color> halo = std::nullopt;  ///< around the letters, for a busy background
};

class Canvas {
 public:
  Canvas(int width, int height, Color page = palette::page);

  int width() const { return width_; }
  int height() const { return height_; }

  void line(const Pixel& from, const Pixel& to, Color color, double thickness);
  void dashed_line(const Pixel& from, const Pixel& to, Color color, double thickness, double dash);
  /// Points that are not finite leave a gap.
  void polyline(std::span<const Pixel> points, Color color, double thickness, bool closed = false);
  void fill(std::span<const Pixel> polygon, Color color);
  void fill_box(const Box& box, Color color);
  void disc(const Pixel& center, double radius, Color color);
  void ring(const Pixel& center, double radius, Color color, double thickness);
  /// An ellipse whose first half axis is rotated by `turn` radians from the picture's x toward its top.
  void ellipse(const Pixel& center, const Pixel& half_axes, double turn, Color color, double thickness);
  /// Draws printable ASCII; other bytes become question marks. `baseline`: position of the bottom of the letters.
  void text(const Pixel& baseline, std::string_view words, const TextStyle& style);
  /// Scales `picture` into `box`.
  void image(const Picture& picture, const Box& box);

  /// Clips everything that `draw` draws to `box`.
  void within(const Box& box, const std::function<void()>& draw);

  Picture finish() const;

  /// Width of a text in pixels.
  static double text_width(std::string_view words, const TextStyle& style);

 private:
  void paint(Color color, const Box& bounds, const std::function<void(cv::Mat&, cv::Point, const cv::Scalar&)>& draw);

  int width_;
  int height_;
  cv::Mat surface_;  // 8-bit red, green, blue
  cv::Rect clip_;    // drawable part of the surface
};

/// Points of the arc between two angles (radians, from the picture's x toward its top), for polylines and fills.
std::vector<Pixel> arc(const Pixel& center, double radius, double from, double to);

/// The outline of the part of a ring between two angles.
std::vector<Pixel> ring_sector(const Pixel& center, double inner, double outer, double from, double to);

/// The longest beginning of `words` that fits, with dots at its end if it was shortened.
std::string shortened(std::string_view words, double width, const TextStyle& style);

}  // namespace reorient::pictures
