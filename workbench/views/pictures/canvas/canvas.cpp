// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/canvas/canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace reorient::pictures {
namespace {

constexpr int kOversampling = 2;
constexpr int kFractionBits = 4;  // of OpenCV's fixed-point coordinates
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontHeight = 30.0;  // of that font at scale 1, in the unit of TextStyle::size
constexpr double kFarAway = 20000.0;  // pixels; corners of polygons beyond it are clamped

bool finite(const Pixel& point) { return point.allFinite(); }

cv::Scalar scalar(Color color) { return {double(color.red), double(color.green), double(color.blue)}; }

int surface_thickness(double thickness) {
  return std::clamp(static_cast<int>(std::lround(thickness * kOversampling)), 1, 200);
}

// (0, 0) is the center of the first pixel in OpenCV, and its corner here.
cv::Point fixed_point(const Pixel& point, cv::Point origin) {
  const auto convert = [](double value, int start) {
    const double near = std::clamp(value, -kFarAway, kFarAway);
    return static_cast<int>(std::lround((near * kOversampling - 0.5 - start) * (1 << kFractionBits)));
  };
  return {convert(point.x(), origin.x), convert(point.y(), origin.y)};
}

Box bounds_of(std::span<const Pixel> points, double margin) {
  Pixel low = Pixel::Constant(kFarAway);
  Pixel high = Pixel::Constant(-kFarAway);
  for (const Pixel& point : points) {
    if (!finite(point)) continue;
    low = low.cwiseMin(point.cwiseMax(-kFarAway));
    high = high.cwiseMax(point.cwiseMin(kFarAway));
  }
  return {low.x() - margin, low.y() - margin, high.x() - low.x() + 2.0 * margin, high.y() - low.y() + 2.0 * margin};
}

cv::Rect surface_rectangle(const Box& box) {
  const auto round = [](double value) {
    return static_cast<int>(std::lround(std::clamp(value, -kFarAway, kFarAway) * kOversampling));
  };
  const int left = round(box.left);
  const int top = round(box.top);
  return {left, top, std::max(0, round(box.right()) - left), std::max(0, round(box.bottom()) - top)};
}

// Liang-Barsky: clips a segment to [-margin, size + margin].
bool clip_segment(Pixel& from, Pixel& to, const Pixel& size, double margin) {
  const Pixel step = to - from;
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = -margin - from[axis];
    const double high = size[axis] + margin - from[axis];
    if (step[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const double first = low / step[axis];
    const double second = high / step[axis];
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  if (enter > leave) return false;
  const Pixel start = from;
  from = start + enter * step;
  to = start + leave * step;
  return finite(from) && finite(to);
}

struct Letters {
  double scale = 1.0;
  int thickness = 1;
};

Letters letters(const TextStyle& style) {
  const double size = std::clamp(style.size, 4.0, 200.0) * kOversampling;
  return {size / kFontHeight, std::max(1, static_cast<int>(std::lround(size * (style.bold ? 0.105 : 0.068))))};
}

std::string printable(std::string_view words) {
  std::string result(words);
  for (char& letter : result)
    if (letter < ' ' || letter > '~') letter = '?';
  return result;
}

}  // namespace

Canvas::Canvas(int width, int height, Color page)
    : width_(std::max(1, width)),
      height_(std::max(1, height)),
      surface_(height_ * kOversampling, width_ * kOversampling, CV_8UC3, scalar(page)),
      clip_(0, 0, surface_.cols, surface_.rows) {}

void Canvas::paint(Color color, const Box& bounds,
                   const std::function<void(cv::Mat&, cv::Point, const cv::Scalar&)>& draw) {
  if (!(color.opacity > 0.0)) return;
  const cv::Rect area = surface_rectangle(bounds) & clip_;
  if (area.empty()) return;
  cv::Mat target = surface_(area);
  if (color.opacity >= 1.0) {
    draw(target, area.tl(), scalar(color));
    return;
  }
  cv::Mat mask = cv::Mat::zeros(area.size(), CV_8UC1);
  draw(mask, area.tl(), cv::Scalar(255));
  const float paint[3] = {float(color.red), float(color.green), float(color.blue)};
  const float full = static_cast<float>(color.opacity) / 255.0F;
  for (int y = 0; y < target.rows; ++y) {
    const std::uint8_t* cover = mask.ptr<std::uint8_t>(y);
    std::uint8_t* pixel = target.ptr<std::uint8_t>(y);
    for (int x = 0; x < target.cols; ++x, pixel += 3) {
      if (cover[x] == 0) continue;
      const float share = full * static_cast<float>(cover[x]);
      for (int channel = 0; channel < 3; ++channel) {
        const float beneath = pixel[channel];
        pixel[channel] = cv::saturate_cast<std::uint8_t>(beneath + share * (paint[channel] - beneath));
      }
    }
  }
}

void Canvas::line(const Pixel& from, const Pixel& to, Color color, double thickness) {
  const Pixel ends[] = {from, to};
  polyline(ends, color, thickness);
}

void Canvas::dashed_line(const Pixel& from, const Pixel& to, Color color, double thickness, double dash) {
  const double length = (to - from).norm();
  if (!std::isfinite(length) || !(dash >= 1.0) || length > kFarAway) return;
  const int dashes = static_cast<int>(std::ceil(length / (2.0 * dash)));
  for (int i = 0; i < dashes; ++i) {
    const double start = 2.0 * i * dash;
    const double end = std::min(start + dash, length);
    line(from + (to - from) * (start / length), from + (to - from) * (end / length), color, thickness);
  }
}

void Canvas::polyline(std::span<const Pixel> points, Color color, double thickness, bool closed) {
  if (points.size() < 2) return;
  const double margin = thickness + 2.0;
  const Pixel size(width_, height_);
  paint(color, bounds_of(points, margin), [&](cv::Mat& target, cv::Point origin, const cv::Scalar& value) {
    const std::size_t segments = closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < segments; ++i) {
      Pixel from = points[i];
      Pixel to = points[(i + 1) % points.size()];
      if (!finite(from) || !finite(to) || !clip_segment(from, to, size, 4.0 * margin)) continue;
      cv::line(target, fixed_point(from, origin), fixed_point(to, origin), value, surface_thickness(thickness),
               cv::LINE_AA, kFractionBits);
    }
  });
}

void Canvas::fill(std::span<const Pixel> polygon, Color color) {
  if (polygon.size() < 3 || !std::all_of(polygon.begin(), polygon.end(), finite)) return;
  paint(color, bounds_of(polygon, 1.0), [&](cv::Mat& target, cv::Point origin, const cv::Scalar& value) {
    std::vector<cv::Point> corners;
    corners.reserve(polygon.size());
    for (const Pixel& point : polygon) corners.push_back(fixed_point(point, origin));
    cv::fillPoly(target, std::vector<std::vector<cv::Point>>{corners}, value, cv::LINE_AA, kFractionBits);
  });
}

void Canvas::fill_box(const Box& box, Color color) {
  if (!finite({box.left, box.top}) || !finite({box.width, box.height})) return;
  paint(color, box, [](cv::Mat& target, cv::Point, const cv::Scalar& value) { target.setTo(value); });
}

void Canvas::disc(const Pixel& center, double radius, Color color) {
  if (!finite(center) || !(radius > 0.0) || radius > kFarAway || center.cwiseAbs().maxCoeff() > kFarAway) return;
  const Box bounds{center.x() - radius - 1.0, center.y() - radius - 1.0, 2.0 * radius + 2.0, 2.0 * radius + 2.0};
  paint(color, bounds, [&](cv::Mat& target, cv::Point origin, const cv::Scalar& value) {
    const int size = static_cast<int>(std::lround(radius * kOversampling * (1 << kFractionBits)));
    cv::circle(target, fixed_point(center, origin), size, value, cv::FILLED, cv::LINE_AA, kFractionBits);
  });
}

void Canvas::ring(const Pixel& center, double radius, Color color, double thickness) {
  ellipse(center, {radius, radius}, 0.0, color, thickness);
}

void Canvas::ellipse(const Pixel& center, const Pixel& half_axes, double turn, Color color, double thickness) {
  if (!finite(center) || !finite(half_axes) || !std::isfinite(turn) || half_axes.maxCoeff() > kFarAway) return;
  constexpr int kCorners = 96;
  std::vector<Pixel> outline(kCorners);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * CV_PI * i / kCorners;
    const double along = half_axes.x() * std::cos(angle);
    const double across = half_axes.y() * std::sin(angle);
    outline[static_cast<std::size_t>(i)] = center + Pixel(along * std::cos(turn) - across * std::sin(turn),
                                                          -along * std::sin(turn) - across * std::cos(turn));
  }
  polyline(outline, color, thickness, true);
}

void Canvas::text(const Pixel& baseline, std::string_view words, const TextStyle& style) {
  if (words.empty() || !finite(baseline)) return;
  const std::string clean = printable(words);
  const double width = text_width(clean, style);
  const double left = baseline.x() - (style.align == Align::left     ? 0.0
                                      : style.align == Align::center ? width / 2.0
                                                                     : width);
  const Box bounds{left - style.size, baseline.y() - 1.5 * style.size, width + 2.0 * style.size, 2.5 * style.size};
  const Letters shape = letters(style);
  const auto write = [&](Color color, int thickness) {
    paint(color, bounds, [&](cv::Mat& target, cv::Point origin, const cv::Scalar& value) {
      const cv::Point start(static_cast<int>(std::lround(left * kOversampling)) - origin.x,
                            static_cast<int>(std::lround(baseline.y() * kOversampling)) - origin.y);
      cv::putText(target, clean, start, kFont, shape.scale, value, thickness, cv::LINE_AA);
    });
  };
  if (style.halo) write(*style.halo, shape.thickness + 3 * kOversampling);
  write(style.color, shape.thickness);
}

void Canvas::image(const Picture& picture, const Box& box) {
  const cv::Rect area = surface_rectangle(box);
  const cv::Rect visible = area & clip_;
  if (picture.width <= 0 || picture.height <= 0 || visible.empty() || area.area() > 100'000'000) return;
  // OpenCV has no view of constant bytes, but this one is only read.
  const cv::Mat source(picture.height, picture.width, CV_8UC3, const_cast<std::uint8_t*>(picture.bytes.data()));
  cv::Mat scaled;
  const bool shrinks = area.width < picture.width;
  cv::resize(source, scaled, area.size(), 0.0, 0.0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  scaled(visible - area.tl()).copyTo(surface_(visible));
}

void Canvas::within(const Box& box, const std::function<void()>& draw) {
  const cv::Rect before = clip_;
  clip_ = before & surface_rectangle(box);
  draw();
  clip_ = before;
}

Picture Canvas::finish() const {
  cv::Mat small;
  cv::resize(surface_, small, cv::Size(width_, height_), 0.0, 0.0, cv::INTER_AREA);
  return {width_, height_, {small.datastart, small.dataend}};
}

double Canvas::text_width(std::string_view words, const TextStyle& style) {
  const Letters shape = letters(style);
  int below = 0;
  const cv::Size size = cv::getTextSize(printable(words), kFont, shape.scale, shape.thickness, &below);
  return static_cast<double>(size.width) / kOversampling;
}

std::vector<Pixel> arc(const Pixel& center, double radius, double from, double to) {
  if (!finite(center) || !std::isfinite(radius) || !std::isfinite(from) || !std::isfinite(to)) return {};
  const double turn = std::clamp(to - from, -2.0 * CV_PI, 2.0 * CV_PI);
  const int steps = std::clamp(static_cast<int>(std::abs(turn) * std::abs(radius) / 4.0), 2, 720);
  std::vector<Pixel> points;
  points.reserve(static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + turn * i / steps;
    points.emplace_back(center + radius * Pixel(std::cos(angle), -std::sin(angle)));
  }
  return points;
}

std::vector<Pixel> ring_sector(const Pixel& center, double inner, double outer, double from, double to) {
  std::vector<Pixel> outline = arc(center, outer, from, to);
  const std::vector<Pixel> back = arc(center, inner, to, from);
  outline.insert(outline.end(), back.begin(), back.end());
  return outline;
}

std::string shortened(std::string_view words, double width, const TextStyle& style) {
  std::string result = printable(words.substr(0, 400));
  if (Canvas::text_width(result, style) <= width) return result;
  while (!result.empty() && Canvas::text_width(result + "...", style) > width) result.pop_back();
  return result + "...";
}

}  // namespace reorient::pictures
