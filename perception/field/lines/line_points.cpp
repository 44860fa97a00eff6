// SPDX-License-Identifier: MIT
#include "perception/field/lines/line_points.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"
#include "geometry/transform.h"
#include "perception/field/carpet/boundary.h"
#include "perception/field/field_image.h"
#include "perception/field/lines/hiding.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kMostCandidates = 600;
constexpr int kFarthestReach = 4;  // pixels

/// `step` (pixels between scan lines), limited to the widest even number of pixels (at least 2) that spans at most
/// `widest` (rad) with this lens.
int limited_step(const GroundProjection& view, int step, double widest) {
  const double most = widest * view.camera().focal.x();
  return step <= most ? step : std::max(static_cast<int>(most) & ~1, 2);
}

/// Sums of products of the slopes of luma at 5 x 5 pixels. Their main direction is perpendicular to the edges there.
struct StructureTensor {
  double xx = 0.0, xy = 0.0, yy = 0.0;

  /// `step`: pixels between neighbors.
  void add(const ImageView& image, const Vector2d& center, int step) {
    const int reach = 2 * step, margin = reach + step;
    const int x0 = std::clamp(nearest_index(center.x()), margin, image.width - margin - 1);
    const int y0 = std::clamp(nearest_index(center.y()), margin, image.height - margin - 1);
    for (int y = y0 - reach; y <= y0 + reach; y += step) {
      for (int x = x0 - reach; x <= x0 + reach; x += step) {
        const double dx = image.luma(x + step, y) - image.luma(x - step, y);
        const double dy = image.luma(x, y + step) - image.luma(x, y - step);
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
      }
    }
  }
  /// Unit vector along the edges.
  Vector2d tangent() const {
    const double across = 0.5 * pinned::atan2(2.0 * xy, xx - yy);
    const auto [sine, cosine] = pinned::sincos(across);
    return {-sine, cosine};
  }
  /// 1: all slopes have the same direction; 0: no preferred direction.
  double coherence() const {
    const double sum = xx + yy;
    return sum > 0.0 ? pinned::hypot(xx - yy, 2.0 * xy) / sum : 0.0;
  }
};

/// Distance (pixels) from an edge of a stripe with this width (pixels) at which its slope is measured. A rotating head
/// blurs the edges of a wide, so near stripe over many pixels. Then noise is steeper than they are from one pixel to
/// the next.
int reach_for(double width) {
  constexpr double kPart = 0.25;  // of the width, so that its two edges remain apart
  return std::clamp(static_cast<int>(kPart * width), 1, kFarthestReach);
}

/// Pixels over which the image of an edge is blurred.
double blur_of(const ImageView& image) { return 1.0 + image.width / 320.0; }

double half_turn_angle(const Vector2d& direction) {
  const double angle = direction_of(direction);
  if (angle > 0.5 * kPi) return angle - kPi;
  return angle <= -0.5 * kPi ? angle + kPi : angle;
}

/// Normal on the ground of a stripe with the direction `tangent` in the image.
std::optional<Vector2d> ground_normal(const GroundProjection& view, const Vector2d& pixel, const Vector2d& tangent) {
  const auto a = view.ground(pixel - 2.0 * tangent);
  const auto b = view.ground(pixel + 2.0 * tangent);
  if (!a || !b) return std::nullopt;
  const Vector2d along = *b - *a;
  const double length = along.norm();
  if (!(length > 1e-9)) return std::nullopt;
  return Vector2d(-along.y() / length, along.x() / length);
}

struct NearestPixel {
  Ycbcr color;
  const CarpetPart& carpet;  ///< at that pixel

  Surface surface() const { return carpet.surface(color.y, color.cb, color.cr); }
};

/// (blue, red), without the offset of 128.
Vector2d chroma_of(const Ycbcr& color) { return {color.cb - 128.0, color.cr - 128.0}; }

NearestPixel nearest_pixel(const ImageView& image, const CarpetColor& color, const Vector2d& where) {
  const int x = nearest_index(std::clamp(where.x(), 0.0, image.width - 1.0));
  const int y = nearest_index(std::clamp(where.y(), 0.0, image.height - 1.0));
  return {image.at(x, y), color.at(x, y)};
}

/// Surface of the mean color of some pixels in a row in this direction. Their chroma has less noise than that of one.
Surface mean_surface_along(const ImageView& image, const CarpetColor& color, const Vector2d& middle,
                           const Vector2d& direction) {
  constexpr int kReach = 2, kCount = 2 * kReach + 1;
  constexpr double kStep = 2.0;  // pixels, since two neighbors in a row have the same chroma
  int luma = 0, blue = 0, red = 0;
  for (int i = -kReach; i <= kReach; ++i) {
    const Ycbcr pixel = nearest_pixel(image, color, middle + i * kStep * direction).color;
    luma += pixel.y;
    blue += pixel.cb;
    red += pixel.cr;
  }
  return nearest_pixel(image, color, middle).carpet.surface(luma / kCount, blue / kCount, red / kCount);
}

}  // namespace

LinePoints::LinePoints(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), field_(field) {
  luma_.reserve(2048);
  segments_.reserve(256);
  candidates_.reserve(kMostCandidates);
  lone_.reserve(kMostCandidates);
  colors_.reserve(kMostCandidates);
  mean_colors_.reserve(kMostCandidates);
  sorted_.reserve(kMostCandidates);
}

void LinePoints::find(const ImageView& image, const GroundProjection& view, CarpetColor& color, FieldPercept& percept) {
  constexpr int kSmallest = 8 * kFarthestReach;  // pixels; smaller images have no room for a line and both of its sides
  candidates_.clear();
  lone_.clear();
  colors_.clear();
  mean_colors_.clear();
  percept.line_points.clear();
  if (std::min(image.width, image.height) < kSmallest) return;
  const Frame frame{image, view, color, percept};
  scan_columns(frame);
  scan_rows(frame);
  keep_supported(percept);
  const auto usual = usual_stripe();
  if (usual) color.observe_white({usual->contrast, usual->less_carpet.x(), usual->less_carpet.y()});
  keep_white(color, usual ? usual->contrast : 0.0, percept);
}

/// Scans down from the boundary in evenly spaced columns. Near the robot, every second or fourth column is enough.
void LinePoints::scan_columns(const Frame& frame) {
  constexpr int kScans = 80;
  constexpr double kWidestStep = 0.016;  // rad; 80 scans of a NAO's camera are 0.0134 apart
  const int step = limited_step(frame.view, std::max(2, frame.image.width / kScans & ~1), kWidestStep);
  const auto lowest_row = [&](int every) {
    // A pixel's width at distance d is about d / focal.
    const double near = parameters_.line_spacing * frame.view.camera().focal.x() / (step * every);
    const Vector2d foot = Vector2d(frame.image.width * 0.5, 0.0);
    int row = frame.image.height;
    while (row > 0) {
      const auto ground = frame.view.ground({foot.x(), static_cast<double>(row - 1)});
      if (!ground || frame.view.distance(*ground) >= near) break;
      row -= 4;
    }
    return std::max(row, 0);
  };
  const int ends[] = {lowest_row(1), lowest_row(2), frame.image.height};
  int index = 0;
  for (int x = step / 2 & ~1; x + 1 < frame.image.width; x += step, ++index) {
    const int bottom = ends[index % 4 == 0 ? 2 : index % 2 == 0 ? 1 : 0];
    const int top = static_cast<int>(boundary_at(frame.percept.boundary, frame.image.width, x)) + 1;
    luma_.clear();
    const std::uint8_t* pair = frame.image.data + static_cast<std::ptrdiff_t>(top) * frame.image.stride + 2 * x;
    for (int y = top; y < bottom; ++y, pair += frame.image.stride)
      luma_.push_back(static_cast<std::int16_t>(pair[0] + pair[2]));
    search(frame, {x + 0.5, top}, {0.0, 1.0}, 1);
  }
}

/// Scans across the image in rows that are evenly spaced on the ground, but at least some pixels apart.
void LinePoints::scan_rows(const Frame& frame) {
  const double spacing = 2.0 * parameters_.line_spacing;
  constexpr double kWidestStep = 0.008;  // rad
  const int least_step = limited_step(frame.view, std::max(2, frame.image.height / 120), kWidestStep);
  const float highest = *std::min_element(frame.percept.boundary.begin(), frame.percept.boundary.end());
  const double middle = 0.5 * frame.image.width;
  double reached = -spacing;
  int last = frame.image.height + least_step;
  for (int y = frame.image.height - 2; y > static_cast<int>(highest); --y) {
    if (last - y < least_step) continue;
    const auto ground = frame.view.ground({middle, y + 0.5});
    if (!ground) break;
    const double distance = frame.view.distance(*ground);
    if (distance > parameters_.line_range) break;
    if (distance < reached + spacing) continue;
    reached = distance;
    last = y;
    luma_.clear();
    const std::uint8_t* upper = frame.image.row(y);
    const std::uint8_t* lower = frame.image.row(y + 1);
    for (int x = 0; x < frame.image.width; ++x) luma_.push_back(static_cast<std::int16_t>(upper[2 * x] + lower[2 * x]));
    const double line_width = field_.line_width * frame.view.camera().focal.x() / std::max(distance, 0.01);  // pixels
    search(frame, {0.0, y + 0.5}, {1.0, 0.0}, reach_for(line_width));
  }
}

/// Finds stripes along the scan line in `luma_`, whose first value is at `start`.
void LinePoints::search(const Frame& frame, const Vector2d& start, const Vector2d& step, int reach) {
  const double noise = parameters_.noise_factor * frame.color.noise();
  const int slope = static_cast<int>(2.0 * std::max(0.6 * parameters_.line_contrast, noise));
  const int contrast = static_cast<int>(2.0 * std::max(parameters_.line_contrast, noise));
  find_bright_segments(luma_, {slope, reach, contrast, 0.25 * frame.image.width}, segments_);
  for (const BrightSegment& segment : segments_) {
    if (candidates_.size() >= kMostCandidates) return;
    const Vector2d begin = start + segment.begin * step;
    const Vector2d end = start + segment.end * step;
    Candidate candidate;
    candidate.reach = reach;
    candidate.color.contrast = 0.5 * segment.contrast;  // luma is a sum of two pixels
    const Side before{begin, start + (segment.before - 1) * step}, after{end, start + (segment.after + 1) * step};
    if (lies_on_carpet(frame, before, after, candidate)) consider(frame, begin, end, candidate);
  }
}

bool LinePoints::lies_on_carpet(const Frame& frame, const Side& before, const Side& after, Candidate& candidate) const {
  const Vector2d center = 0.5 * (before.edge + after.edge);
  if (center.y() < boundary_at(frame.percept.boundary, frame.image.width, center.x()) + 1.0) return false;
  Vector2d all = Vector2d::Zero(), sure = Vector2d::Zero();
  int sure_count = 0;
  bool is_sure = false;
  const double thin = 1.5 * blur_of(frame.image);
  const bool is_thin = (after.edge - before.edge).squaredNorm() < thin * thin;
  for (const Side& side : {before, after}) {
    const NearestPixel ground = nearest_pixel(frame.image, frame.color, side.outside);
    Surface surface = ground.surface();
    all += chroma_of(ground.color);
    if (surface == Surface::carpet) {
      sure += chroma_of(ground.color);
      ++sure_count;
    }
    if (surface == Surface::other && is_thin) surface = mean_surface(frame, side, center);
    if (surface == Surface::other) return false;
    is_sure = is_sure || surface == Surface::carpet;
  }
  // A strip of carpet between a line and the boards has their tint.
  candidate.color.carpet = sure_count > 0 ? Vector2d(sure / sure_count) : Vector2d(0.5 * all);
  candidate.color.less_carpet =
      chroma_of(nearest_pixel(frame.image, frame.color, center).color) - candidate.color.carpet;
  return is_sure && !hides(frame.percept, center);
}

/// The surface of several pixels beside a thin, so distant stripe, since the chroma of one pixel may be noise. A strip
/// of carpet between a line and the boards may be so narrow that only the pixels close to the edge show it.
Surface LinePoints::mean_surface(const Frame& frame, const Side& side, const Vector2d& center) {
  const double close = blur_of(frame.image) - 1.0;  // pixels
  StructureTensor edges;
  edges.add(frame.image, center, 1);
  const Vector2d tangent = edges.tangent(), out = side.outside - side.edge;
  const double distance = out.norm();
  const Surface surface = mean_surface_along(frame.image, frame.color, side.outside, tangent);
  if (surface != Surface::other || distance <= close) return surface;
  return mean_surface_along(frame.image, frame.color, side.edge + close / distance * out, tangent);
}

/// Adds a stripe if it has the width of a line on the ground and its two edges are parallel.
void LinePoints::consider(const Frame& frame, const Vector2d& begin, const Vector2d& end, Candidate& candidate) {
  constexpr double kLeastCoherence = 0.5;
  const auto first = frame.view.ground(begin);
  const auto second = frame.view.ground(end);
  if (!first || !second) return;
  const Vector2d position = 0.5 * (*first + *second);
  const double distance = frame.view.distance(position);
  if (!(distance <= parameters_.line_range)) return;
  const double blur = blur_of(frame.image);
  const Vector2d across = *second - *first;
  const double length = across.norm();  // m along the scan line
  const double meters_per_pixel = length / std::max((end - begin).norm(), 1e-6);
  const auto is_no_line = [&] {
    if (length > field_.line_width && length < 1.5 * field_.penalty_mark_size + blur * meters_per_pixel)
      add_lone(position);
  };

  StructureTensor at_begin, at_end;
  at_begin.add(frame.image, begin, candidate.reach);
  at_end.add(frame.image, end, candidate.reach);
  constexpr double kParallel = 0.85;  // cosine
  if ((end - begin).norm() > 6.0 && std::abs(at_begin.tangent().dot(at_end.tangent())) < kParallel) return is_no_line();
  const StructureTensor both{at_begin.xx + at_end.xx, at_begin.xy + at_end.xy, at_begin.yy + at_end.yy};
  if (both.coherence() < kLeastCoherence) return is_no_line();

  candidate.position = position;
  candidate.distance = distance;
  candidate.pixel = 0.5 * (begin + end);
  candidate.tangent = both.tangent();
  const auto normal = ground_normal(frame.view, candidate.pixel, candidate.tangent);
  if (!normal) return;
  candidate.normal = *normal;
  const double width = std::abs(across.dot(*normal));
  const double pixel = width / std::max((end - begin).norm(), 1e-6);  // m across the line for one pixel along the scan
  if (width > 1.5 * field_.line_width + blur * pixel) return is_no_line();
  if (width < 0.6 * field_.line_width - 1.5 * pixel) return;
  candidates_.push_back(candidate);
}

void LinePoints::add_lone(const Vector2d& position) {
  if (lone_.size() < kMostCandidates) lone_.push_back(position);
}

/// Keeps points that other points continue: noise and marks are isolated, lines are not. The continuing points also
/// give a better direction than the gradient at one point, since far away a pixel is a large step along the line of
/// sight.
void LinePoints::keep_supported(FieldPercept& percept) {
  constexpr double kSlant = 0.12;    // largest tangent of the angle between a line and the tangent at a point on it
  constexpr double kParallel = 0.9;  // cosine
  for (const Candidate& candidate : candidates_) {
    const double reach = std::clamp(0.12 * candidate.distance, 0.2, 0.4);
    int support = 0;
    double least = 0.0, most = 0.0;
    StripeColor colors = candidate.color;
    Vector2d sum = candidate.position;
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const Candidate& other : candidates_) {
      if (&other == &candidate) continue;
      const Vector2d offset = other.position - candidate.position;
      if (std::abs(offset.x()) > reach || std::abs(offset.y()) > reach) continue;
      const Vector2d chord = other.pixel - candidate.pixel;
      if (std::abs(cross(chord, candidate.tangent)) > candidate.reach + kSlant * chord.norm()) continue;
      if (std::abs(candidate.tangent.dot(other.tangent)) < kParallel) continue;
      const double along = -offset.x() * candidate.normal.y() + offset.y() * candidate.normal.x();
      least = std::min(least, along);
      most = std::max(most, along);
      colors.contrast += other.color.contrast;
      colors.carpet += other.color.carpet;
      colors.less_carpet += other.color.less_carpet;
      sum += offset;
      squares += offset * offset.transpose();
      ++support;
    }
    if (support < parameters_.line_support || most - least < 2.0 * field_.penalty_mark_size) {
      add_lone(candidate.position);
      continue;
    }
    const int count = support + 1;
    const Vector2d mean = (sum - candidate.position) / count;
    const Eigen::Matrix2d spread = squares / count - mean * mean.transpose();
    const double along_angle = 0.5 * pinned::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));
    const auto [sine, cosine] = pinned::sincos(along_angle);
    percept.line_points.push_back(
        {candidate.position, half_turn_angle({-sine, cosine}), candidate.pixel.cast<float>()});
    colors_.push_back(candidate.color);
    mean_colors_.push_back({colors.carpet / count, colors.less_carpet / count, colors.contrast / count});
  }
}

/// The medians of the points.
std::optional<LinePoints::StripeColor> LinePoints::usual_stripe() {
  constexpr std::size_t kFewest = 12;
  if (colors_.size() < kFewest) return std::nullopt;
  const auto median = [this](auto&& value_of) {
    sorted_.clear();
    for (const StripeColor& color : colors_) sorted_.push_back(value_of(color));
    const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
    std::nth_element(sorted_.begin(), middle, sorted_.end());
    return *middle;
  };
  StripeColor usual;
  for (const int channel : {0, 1})
    usual.less_carpet[channel] = median([&](const StripeColor& color) { return color.less_carpet[channel]; });
  usual.contrast = median([](const StripeColor& color) { return color.contrast; });
  return usual;
}

/// Removes bright carpet, which has the carpet's color. If white differs from that color by hardly more than noise,
/// every point stays. A distant line is mixed with the carpet around it in luma and chroma, so the limit is lower for a
/// fainter stripe. `usual_contrast`: 0 if unknown.
void LinePoints::keep_white(const CarpetColor& color, double usual_contrast, FieldPercept& percept) const {
  constexpr double kLeastFraction = 0.2, kNoise = 2.0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mean_colors_.size(); ++i) {
    const StripeColor& stripe = mean_colors_[i];
    const Vector2d white = color.white_less_carpet(stripe.carpet);
    const double norm = white.norm();
    const double faintness = usual_contrast > 0.0 ? std::min(1.0, stripe.contrast / usual_contrast) : 1.0;
    const double least = faintness * kLeastFraction * norm * norm;
    if (norm > kNoise * color.deviation() && stripe.less_carpet.dot(white) < least) continue;
    percept.line_points[kept++] = percept.line_points[i];
  }
  percept.line_points.resize(kept);
}

}  // namespace reorient
