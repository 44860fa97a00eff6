// SPDX-License-Identifier: MIT
#include "perception/field/upright/goal_posts.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"
#include "geometry/square.h"
#include "perception/field/carpet/boundary.h"

namespace reorient {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kMostPosts = 8;
constexpr double kFarAway = 5.0;    // m
constexpr double kOtherHue = 12.0;  // steps of chroma

double chroma_distance(const Ycbcr& a, const Ycbcr& b) { return pinned::hypot(a.cb - b.cb, a.cr - b.cr); }

bool inside(const ImageView& image, const Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= image.width - 1 && pixel.y() <= image.height - 1;
}

/// The color at a position inside of the image.
Eigen::Vector2i pixel_of(const Vector2d& place) { return {nearest_index(place.x()), nearest_index(place.y())}; }

}  // namespace

GoalPosts::GoalPosts(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), field_(field) {
  luma_.reserve(2048);
  segments_.reserve(256);
}

void GoalPosts::find(const FieldImage& frame, FieldPercept& percept) {
  percept.goal_posts.clear();
  if (frame.image.width < 16 || frame.image.height < 16) return;
  // A post crosses everything between its foot and the horizon: the carpet, the carpet's border and the room.
  for (const double fraction : {0.0, -0.15, 0.5, 0.9}) scan(frame, fraction, percept);
}

/// Scans along a line at `fraction` of the distance from the boundary (0) to the horizon (1). Large images
/// are read at half of their size, which is sharp enough for a post and less noisy.
void GoalPosts::scan(const FieldImage& frame, double fraction, FieldPercept& percept) {
  const ImageView& image = frame.image;
  const double left = frame.view.horizon(0.0);
  const double tilt = (frame.view.horizon(image.width - 1.0) - left) / std::max(1.0, image.width - 1.0);
  const bool is_straight = frame.view.camera().is_perspective();
  const auto row_of = [&](double x) {
    const double border = std::min(boundary_at(percept.boundary, image.width, x), image.height - 1.0);
    const double horizon = is_straight ? left + tilt * x : frame.view.horizon(x);
    return static_cast<int>(std::clamp(border + fraction * (horizon - border), 1.0, image.height - 2.0));
  };
  const int step = image.width > 400 ? 2 : 1;
  luma_.resize(static_cast<std::size_t>(image.width / step));
  for (std::size_t i = 0; i < luma_.size(); ++i) {
    const int x = static_cast<int>(i) * step;
    const int y = row_of(x);
    int sum = 0;
    for (int k = -1; k <= 1; ++k) sum += image.luma(x, y + k) + image.luma(x + step - 1, y + k);
    luma_[i] = static_cast<std::int16_t>(sum);
  }
  const int contrast = static_cast<int>(6.0 * std::max(parameters_.post_contrast, 2.0 * frame.color.noise()));
  const SegmentLimits limits{
      .slope = contrast / 2, .contrast = contrast, .length = 0.25 * static_cast<double>(luma_.size())};
  find_bright_segments(luma_, limits, segments_);
  for (const BrightSegment& segment : segments_) {
    const double x = step * 0.5 * (segment.begin + segment.end) + 0.5 * (step - 1);
    consider(frame, {x, static_cast<double>(row_of(x))}, step * (segment.end - segment.begin), percept);
  }
}

void GoalPosts::consider(const FieldImage& frame, const Vector2d& pixel, double width, FieldPercept& percept) const {
  if (percept.goal_posts.size() >= kMostPosts) return;
  Candidate candidate;
  candidate.pixel = pixel;
  candidate.width = width;
  candidate.look = frame.at(pixel_of(pixel));
  if (!may_be_post(frame, pixel, candidate.look)) return;
  for (const GoalPost& known : percept.goal_posts) {
    if (std::abs(known.base.x() - candidate.pixel.x()) < 1.5 * candidate.width + 4.0) return;
  }
  candidate.foot = follow(frame, candidate, percept.boundary, 1);
  const bool cut_off = candidate.foot.y() >= frame.image.height - 2.0;
  // Most bright objects stand behind the carpet. Their tops need not be found.
  if (!cut_off && !has_carpet_before(frame, candidate, percept.boundary)) return;
  candidate.top = follow(frame, candidate, percept.boundary, -1);
  const auto post = cut_off ? post_without_foot(frame, candidate) : post_on_carpet(frame, candidate, percept.boundary);
  if (post) percept.goal_posts.push_back(*post);
}

/// Whether the color is white, or yellow in 2013. A post may be in the shade while light falls on the carpet.
bool GoalPosts::may_be_post(const FieldImage& frame, const Vector2d& pixel, const Ycbcr& look) const {
  constexpr double kDarkest = 0.7, kMostTint = 0.16;
  if (look.y < kDarkest * frame.color.luma()) return false;
  if (!field_.yellow_goals) return frame.color.tint_at(pixel_of(pixel), look) < kMostTint;
  const double blue = (look.cb - 128) / static_cast<double>(std::max<int>(look.y, 1));
  const double red = (look.cr - 128) / static_cast<double>(std::max<int>(look.y, 1));
  return blue < -0.15 && red > -0.15 && red < 0.3;
}

/// True for a post whose visible side has the same light as the carpet.
bool GoalPosts::is_lighter_than_carpet(const FieldImage& frame, const Ycbcr& look) const {
  constexpr double kLighter = 1.4;
  return look.y >= std::max(kLighter * frame.color.luma(), frame.color.luma() + parameters_.post_contrast);
}

bool GoalPosts::has_post_color(const FieldImage& frame, const Candidate& candidate, const Vector2d& pixel) const {
  const Eigen::Vector2i place = pixel_of(pixel);
  const Ycbcr seen = frame.at(place);
  const Ycbcr& look = candidate.look;
  const double bright = std::max<double>(seen.y, look.y);
  return std::abs(seen.y - look.y) < 8.0 + 0.25 * look.y && chroma_distance(seen, look) < 6.0 + 0.08 * bright &&
         frame.color.surface(place.x(), place.y(), seen) != Surface::carpet;
}

/// The last pixel of the candidate's color, down (1) or up (-1), between the candidate's sides. While the head turns, a
/// rolling shutter makes the image of a vertical edge lean. How much shows above the carpet's border, since on the
/// carpet a line may continue the post.
Vector2d GoalPosts::follow(const FieldImage& frame, const Candidate& candidate, const std::vector<float>& boundary,
                           int direction) const {
  constexpr int kGap = 2;          // pixels of another color that are skipped
  constexpr int kBend = 8;         // rows after which the direction is corrected
  constexpr double kWithin = 0.3;  // of the width, from the middle: still the post
  constexpr double kShift = 0.1;   // of the width
  constexpr double kMostLean = 0.25;
  double slant = frame.view.vertical_slant(candidate.pixel);
  const Vector2d aside(kWithin * candidate.width, 0.0);
  double lean = 0.0;  // pixels per row
  Vector2d last = candidate.pixel;
  int missing = 0;
  int row = 0;
  for (Vector2d pixel = last; missing <= kGap; pixel += Vector2d(direction * (slant + lean), direction)) {
    if (!inside(frame.image, pixel)) break;
    if (has_post_color(frame, candidate, pixel)) {
      last = pixel;
      missing = 0;
    } else {
      ++missing;
    }
    if (++row % kBend != 0) continue;
    if (!frame.view.camera().is_perspective()) slant = frame.view.vertical_slant(pixel);
    if (pixel.y() > boundary_at(boundary, frame.image.width, pixel.x())) continue;
    if (!inside(frame.image, pixel - aside) || !inside(frame.image, pixel + aside)) continue;
    const int right = has_post_color(frame, candidate, pixel + aside) ? 1 : 0;
    const int left = has_post_color(frame, candidate, pixel - aside) ? 1 : 0;
    pixel.x() += (right - left) * kShift * candidate.width;
    lean = std::clamp(lean + direction * (right - left) * 0.5 / kBend, -kMostLean, kMostLean);
  }
  return last;
}

std::optional<GoalPost> GoalPosts::post_on_carpet(const FieldImage& frame, const Candidate& candidate,
                                                  const std::vector<float>& boundary) const {
  const auto foot = frame.view.ground(candidate.foot);
  if (!foot) return std::nullopt;
  const double radius = 0.5 * field_.goal_post_diameter;
  const double from_foot = frame.view.distance(*foot);
  const auto from_height = distance_from_height(frame, candidate, from_foot);
  if (!has_carpet_behind(frame, candidate, from_height.value_or(from_foot), boundary)) return std::nullopt;
  const auto post_at = [&](double distance) {
    const Vector2d position = *foot + (distance - from_foot + radius) * frame.view.away(*foot);
    return GoalPost{position, true, candidate.foot.cast<float>(), candidate.top.cast<float>()};
  };
  if (from_height && outline_agrees(frame, candidate, upright_between(frame, candidate, *from_height)) &&
      (*from_height <= kFarAway || is_lighter_than_carpet(frame, candidate.look))) {
    // Weighted by the inverse variances. Far away, the height determines the distance.
    constexpr double kTilt = 0.0175, kHeight = 0.05;  // rad; fraction
    const double height = frame.view.camera_height();
    const double of_foot = square(kTilt * (square(*from_height) + square(height)) / height);
    const double of_height = square(kHeight * *from_height);
    const double distance = (of_height * from_foot + of_foot * *from_height) / (of_height + of_foot);
    return *from_height <= parameters_.post_range ? std::optional(post_at(distance)) : std::nullopt;
  }
  // The top may be above the image, or hidden by an object of the same color, for example a wall far away.
  if (from_foot > std::min(kFarAway, parameters_.post_range) || !is_lighter_than_carpet(frame, candidate.look) ||
      !is_thick_enough(frame, candidate, from_foot)) {
    return std::nullopt;
  }
  const GoalPost post = post_at(from_foot);
  return outline_agrees(frame, candidate, upright_at(frame, candidate, post.position)) ? std::optional(post)
                                                                                       : std::nullopt;
}

/// Requires carpet behind the post, since goal lines are not at the border of the carpet.
bool GoalPosts::has_carpet_behind(const FieldImage& frame, const Candidate& candidate, double distance,
                                  const std::vector<float>& boundary) {
  constexpr double kInside = 0.25, kInsideFarAway = 0.1;  // m
  const double inside_by = distance > kFarAway ? kInsideFarAway : kInside;
  const double height = frame.view.camera_height();
  const double rows = frame.view.camera().focal.y() * height * inside_by / (square(distance) + square(height));
  return candidate.foot.y() >= boundary_at(boundary, frame.image.width, candidate.foot.x()) + rows;
}

/// Requires carpet in front of the post, all the way to the robot, since a banner may be as green and its letters
/// similar to posts. A foot beyond the border, which has_carpet_behind() would reject later, is rejected at once.
bool GoalPosts::has_carpet_before(const FieldImage& frame, const Candidate& candidate,
                                  const std::vector<float>& boundary) const {
  if (candidate.foot.y() < boundary_at(boundary, frame.image.width, candidate.foot.x())) return false;
  constexpr double kBelow = 3.0;  // pixels, smallest value
  Vector2d below = candidate.foot + Vector2d(0.0, std::max(kBelow, 0.25 * candidate.width));
  below.y() = std::min(below.y(), frame.image.height - 1.0);
  if (!inside(frame.image, below) || below.y() < candidate.foot.y() + kBelow) return false;
  const Ycbcr ground = frame.at(pixel_of(below));
  if (frame.surface(pixel_of(below)) == Surface::other) return false;
  // A post in the shade may be darker than carpet in the light, but has another hue.
  constexpr double kLightestCarpet = 1.4;  // multiple of its usual luma
  const bool is_carpet_in_light =
      ground.y < kLightestCarpet * frame.color.luma() && chroma_distance(ground, candidate.look) > kOtherHue;
  if (ground.y > candidate.look.y - parameters_.post_contrast && !is_carpet_in_light) return false;
  constexpr int kSamples = 16, kMostOther = 4;  // such as lines or a ball
  int other = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double row = below.y() + (frame.image.height - 1.0 - below.y()) * i / (kSamples - 1.0);
    const Vector2d before(below.x(), row);
    other += frame.surface(pixel_of(before)) == Surface::other ? 1 : 0;
  }
  return other <= kMostOther;
}

bool GoalPosts::is_thick_enough(const FieldImage& frame, const Candidate& candidate, double distance) const {
  constexpr double kThinnest = 0.7;  // fraction of the expected width
  const double width =
      frame.view.pixels_per_radian(candidate.pixel) * field_.goal_post_diameter / std::max(distance, 0.1);
  return candidate.width >= kThinnest * width - 1.0;
}

/// Distance along the ground from the angle between foot and top, which does not depend on the tilt of the camera.
/// Empty if foot or thickness contradict it by more than an error of the tilt explains. `from_foot`: distance computed
/// from the foot, m.
std::optional<double> GoalPosts::distance_from_height(const FieldImage& frame, const Candidate& candidate,
                                                      double from_foot) const {
  constexpr double kMostTilt = 0.04;  // rad
  if (candidate.top.y() < 2.0) return std::nullopt;
  const Vector3d foot = frame.view.camera().ray(candidate.foot), top = frame.view.camera().ray(candidate.top);
  const double below = frame.view.camera_height(), above = field_.goal_height - below;
  // Solves the tangent of the sum of both angles, below / d and above / d, for d.
  const double tangent = foot.cross(top).norm() / foot.dot(top);
  const double root = square(field_.goal_height) + 4.0 * square(tangent) * below * above;
  if (!(tangent > 1e-3) || root < 0.0) return std::nullopt;
  const double distance = (field_.goal_height + std::sqrt(root)) / (2.0 * tangent);
  const double tilt = below * (distance - from_foot) / (distance * from_foot + square(below));  // its tangent
  if (std::abs(tilt) > kMostTilt || !is_thick_enough(frame, candidate, distance)) return std::nullopt;
  return distance;
}

/// From the height of the top. The thickness must confirm the distance.
std::optional<GoalPost> GoalPosts::post_without_foot(const FieldImage& frame, const Candidate& candidate) const {
  constexpr double kAgreement = 0.25;
  constexpr double kRange = 2.0;  // m; farther away, the foot is in view or the top is too close to the horizon
  if (candidate.top.y() < 2.0 || field_.goal_height - frame.view.camera_height() < 0.1) return std::nullopt;
  if (!is_lighter_than_carpet(frame, candidate.look)) return std::nullopt;
  const auto top = frame.view.at_height(candidate.top, field_.goal_height);
  if (!top) return std::nullopt;
  const double distance = frame.view.distance(*top);
  const double from_width = frame.view.pixels_per_radian(candidate.pixel) * field_.goal_post_diameter / candidate.width;
  if (distance > kRange || std::abs(from_width - distance) > kAgreement * distance) return std::nullopt;
  const Vector2d position = *top + 0.5 * field_.goal_post_diameter * frame.view.away(*top);
  if (!outline_agrees(frame, candidate, upright_at(frame, candidate, position))) return std::nullopt;
  return GoalPost{position, false, candidate.foot.cast<float>(), candidate.top.cast<float>()};
}

/// A post at a position on the ground, leaning as the candidate does in the image.
GoalPosts::Upright GoalPosts::upright_at(const FieldImage& frame, const Candidate& candidate,
                                         const Vector2d& position) const {
  constexpr double kLeastRows = 16.0;  // of which the lean can be measured
  Upright upright{frame.view.in_camera({position.x(), position.y(), 0.0}),
                  frame.view.in_camera({position.x(), position.y(), field_.goal_height})};
  const Vector2d down = candidate.foot - candidate.top;
  if (down.y() < kLeastRows) return upright;
  const double lean = down.x() / down.y() - frame.view.vertical_slant(0.5 * (candidate.foot + candidate.top));
  upright.top.y() += lean * (upright.top.z() - upright.foot.z());
  return upright;
}

/// A post from the candidate's foot to its top at this distance.
GoalPosts::Upright GoalPosts::upright_between(const FieldImage& frame, const Candidate& candidate,
                                              double distance) const {
  const double below = frame.view.camera_height(), above = field_.goal_height - below;
  return {pinned::hypot(distance, below) * frame.view.camera().ray(candidate.foot).normalized(),
          pinned::hypot(distance, above) * frame.view.camera().ray(candidate.top).normalized()};
}

/// Compares a post with the image at some heights. Its middle must have the candidate's color, and the pixels on both
/// sides must not. At some height above its top, in the image or above it, the color must have ended.
bool GoalPosts::outline_agrees(const FieldImage& frame, const Candidate& candidate, const Upright& upright) const {
  constexpr int kHeights = 12;
  constexpr double kEnds[] = {1.03, 1.06, 1.09,
                              1.12, 1.16, 1.2};  // of a post's height; at one of them, the post has ended
  constexpr double kLeastVisible = 0.6;          // fraction of its heights that must be in the image
  constexpr double kBelowBar = 0.86;             // fraction of its height
  constexpr double kLeastOfOneSide = 0.7, kLeastOfBothSides = 1.85;  // fraction of the heights that must agree
  const Vector3d side_step = 0.5 * field_.goal_post_diameter * upright.foot.cross(upright.top).normalized();
  const auto point_at = [&](double fraction) -> Vector3d {
    return upright.foot + fraction * (upright.top - upright.foot);
  };
  const auto project = [&](const Vector3d& point) -> std::optional<Vector2d> {
    auto pixel = frame.view.camera().project(point);
    if (pixel && !inside(frame.image, *pixel)) pixel.reset();
    return pixel;
  };
  const auto differs = [&](const Vector2d& pixel, const Ycbcr& post) {
    const Ycbcr seen = frame.at(pixel_of(pixel));
    return std::abs(seen.y - post.y) > 0.7 * parameters_.post_contrast || chroma_distance(seen, post) > kOtherHue;
  };
  int visible = 0, in_post = 0, left_free = 0, right_free = 0;
  for (int i = 0; i < kHeights; ++i) {
    const Vector3d point = point_at(kBelowBar * (i + 0.5) / kHeights);
    const auto middle = project(point);
    const auto side = frame.view.camera().project(point + side_step);
    if (!middle || !side) continue;
    ++visible;
    const double half = std::abs(side->x() - middle->x());
    const Ycbcr post = frame.at(pixel_of(*middle));
    const Vector2d beyond(1.3 * half + 2.0, 0.0);
    const Vector2d within(0.5 * half, 0.0);
    in_post += has_post_color(frame, candidate, *middle) ? 1 : 0;
    const bool left_inside = inside(frame.image, *middle - beyond) && inside(frame.image, *middle - within);
    const bool right_inside = inside(frame.image, *middle + beyond) && inside(frame.image, *middle + within);
    left_free +=
        left_inside && differs(*middle - beyond, post) && has_post_color(frame, candidate, *middle - within) ? 1 : 0;
    right_free +=
        right_inside && differs(*middle + beyond, post) && has_post_color(frame, candidate, *middle + within) ? 1 : 0;
  }
  const double needed = parameters_.post_agreement * visible;
  if (visible < kLeastVisible * kHeights || in_post < needed) return false;
  // An object as bright as the post may be behind it on one side: a line, the net, a board. Far away, this is not
  // enough.
  const bool is_near = upright.foot.norm() <= kFarAway;
  const double of_one = is_near ? kLeastOfOneSide : 1.0, of_both = is_near ? kLeastOfBothSides : 2.0;
  if (std::min(left_free, right_free) < of_one * needed || left_free + right_free < of_both * needed) return false;
  return std::any_of(std::begin(kEnds), std::end(kEnds), [&](double end) {
    const auto above = project(point_at(end));
    return !above || differs(*above, candidate.look);
  });
}

}  // namespace reorient
