#include "perception/field/upright/goal_posts.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"
#include "perception/field/carpet/boundary.h"

namespace reorient {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kMostPosts = 8;

bool inside(const ImageView& image, const Vector2d& pixel) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= image.width - 1 && pixel.y() <= image.height - 1;
}

Surface surface_at(const CarpetColor& color, const Vector2d& pixel, const Ycbcr& seen) {
  return color.surface(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())), seen);
}

/// For a pixel inside of the image.
Ycbcr pixel_at(const ImageView& image, const Vector2d& pixel) {
  return image.at(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
}

}  // namespace

GoalPosts::GoalPosts(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), field_(field) {
  luma_.reserve(2048);
  segments_.reserve(256);
}

void GoalPosts::find(const ImageView& image, const GroundProjection& view, const CarpetColor& color,
                     FieldPercept& percept) {
  percept.goal_posts.clear();
  if (image.width < 16 || image.height < 16) return;
  const Frame frame{image, view, color};
  // A post crosses everything between its foot and the horizon: in front of the carpet, of its border, of the room.
  for (const double share : {0.0, -0.15, 0.5, 0.9}) scan(frame, share, percept);
}

/// Along a line that is at `share` of the way from the boundary (0) up to the horizon (1). Large images are read at
/// half their size, which is sharp enough for a post and less noisy.
void GoalPosts::scan(const Frame& frame, double share, FieldPercept& percept) {
  const ImageView& image = frame.image;
  const double left = frame.view.horizon(0.0);
  const double tilt = (frame.view.horizon(image.width - 1.0) - left) / std::max(1.0, image.width - 1.0);
  const bool is_straight = frame.view.camera().is_perspective();
  const auto row_of = [&](double x) {
    const double border = std::min(boundary_at(percept.boundary, image.width, x), image.height - 1.0);
    const double horizon = is_straight ? left + tilt * x : frame.view.horizon(x);
    return std::clamp(static_cast<int>(border + share * (horizon - border)), 1, image.height - 2);
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
  find_bright_segments(luma_, contrast / 2, contrast, 0.25 * static_cast<double>(luma_.size()), segments_);
  for (const BrightSegment& segment : segments_) {
    const double x = step * 0.5 * (segment.begin + segment.end) + 0.5 * (step - 1);
    consider(frame, {x, static_cast<double>(row_of(x))}, step * (segment.end - segment.begin), percept);
  }
}

void GoalPosts::consider(const Frame& frame, const Vector2d& pixel, double width, FieldPercept& percept) const {
  if (percept.goal_posts.size() >= kMostPosts) return;
  Candidate candidate;
  candidate.pixel = pixel;
  candidate.width = width;
  candidate.look = pixel_at(frame.image, pixel);
  if (!may_be_post(frame, candidate.look)) return;
  for (const GoalPost& known : percept.goal_posts) {
    if (std::abs(known.base.x() - candidate.pixel.x()) < 1.5 * candidate.width + 4.0) return;
  }
  candidate.foot = follow(frame, candidate, 1);
  candidate.top = follow(frame, candidate, -1);
  const bool cut_off = candidate.foot.y() >= frame.image.height - 2.0;
  const auto post = cut_off ? post_without_foot(frame, candidate) : post_on_carpet(frame, candidate, percept.boundary);
  if (post) percept.goal_posts.push_back(*post);
}

/// White, or yellow in 2013; lighter than the carpet.
bool GoalPosts::may_be_post(const Frame& frame, const Ycbcr& look) const {
  constexpr double kLighter = 1.4;
  const double blue = (look.cb - 128) / static_cast<double>(std::max<int>(look.y, 1));
  const double red = (look.cr - 128) / static_cast<double>(std::max<int>(look.y, 1));
  if (look.y < std::max(kLighter * frame.color.luma(), frame.color.luma() + parameters_.post_contrast)) return false;
  return field_.yellow_goals ? blue < -0.15 && red > -0.15 && red < 0.3 : pinned::hypot(blue, red) < 0.16;
}

bool GoalPosts::has_post_color(const Frame& frame, const Candidate& candidate, const Vector2d& pixel) const {
  const Ycbcr seen = pixel_at(frame.image, pixel);
  const Ycbcr& look = candidate.look;
  const double chroma = pinned::hypot(seen.cb - look.cb, seen.cr - look.cr);
  const double bright = std::max<double>(seen.y, look.y);
  return std::abs(seen.y - look.y) < 8.0 + 0.25 * look.y && chroma < 6.0 + 0.08 * bright &&
         surface_at(frame.color, pixel, seen) == Surface::other;
}

/// The last pixel of the candidate's colour, downwards (1) or upwards (-1) along the image of a vertical edge.
Vector2d GoalPosts::follow(const Frame& frame, const Candidate& candidate, int direction) const {
  constexpr int kGap = 2;   // pixels of another colour that are passed
  constexpr int kBend = 8;  // rows after which the image of a vertical edge may run another way
  double slant = frame.view.vertical_slant(candidate.pixel);
  Vector2d last = candidate.pixel;
  int missing = 0;
  int row = 0;
  for (Vector2d pixel = last; missing <= kGap; pixel += Vector2d(direction * slant, direction)) {
    if (++row % kBend == 0 && !frame.view.camera().is_perspective()) slant = frame.view.vertical_slant(pixel);
    if (!inside(frame.image, pixel)) break;
    if (has_post_color(frame, candidate, pixel)) {
      last = pixel;
      missing = 0;
    } else {
      ++missing;
    }
  }
  return last;
}

std::optional<GoalPost> GoalPosts::post_on_carpet(const Frame& frame, const Candidate& candidate,
                                                  const std::vector<float>& boundary) const {
  constexpr double kInside =
      0.25;  // m of carpet that there must be behind it: goal lines are not at the carpet's border
  const auto foot = frame.view.ground(candidate.foot);
  if (!foot || frame.view.distance(*foot) > parameters_.post_range) return std::nullopt;
  const double border = boundary_at(boundary, frame.image.width, candidate.foot.x());
  const auto behind = frame.view.ground({candidate.foot.x(), border});
  if (behind && frame.view.distance(*behind) < frame.view.distance(*foot) + kInside) return std::nullopt;
  const Vector2d below = candidate.foot + Vector2d(0.0, std::max(3.0, 0.25 * candidate.width));
  if (!inside(frame.image, below)) return std::nullopt;
  const Ycbcr ground = pixel_at(frame.image, below);
  if (surface_at(frame.color, below, ground) == Surface::other ||
      ground.y > candidate.look.y - parameters_.post_contrast) {
    return std::nullopt;
  }
  const Vector2d position = *foot + 0.5 * field_.goal_post_diameter * frame.view.away(*foot);
  if (!outline_agrees(frame, candidate, position)) return std::nullopt;
  return GoalPost{position, true, candidate.foot.cast<float>(), candidate.top.cast<float>()};
}

/// From the height of its top; the thickness must confirm the distance.
std::optional<GoalPost> GoalPosts::post_without_foot(const Frame& frame, const Candidate& candidate) const {
  constexpr double kAgreement = 0.25;
  constexpr double kRange = 2.0;  // m; farther away, the foot is in view or the top is too close to the horizon
  if (candidate.top.y() < 2.0 || field_.goal_height - frame.view.camera_height() < 0.1) return std::nullopt;
  const auto top = frame.view.at_height(candidate.top, field_.goal_height);
  if (!top) return std::nullopt;
  const double distance = frame.view.distance(*top);
  const double from_width = frame.view.pixels_per_radian(candidate.pixel) * field_.goal_post_diameter / candidate.width;
  if (distance > kRange || std::abs(from_width - distance) > kAgreement * distance) return std::nullopt;
  const Vector2d position = *top + 0.5 * field_.goal_post_diameter * frame.view.away(*top);
  if (!outline_agrees(frame, candidate, position)) return std::nullopt;
  return GoalPost{position, false, candidate.foot.cast<float>(), candidate.top.cast<float>()};
}

/// Compares a post at `position` with the image at some heights: its middle has the candidate's colour, what is
/// beside it on either side has not, and above its top there is no more of it.
bool GoalPosts::outline_agrees(const Frame& frame, const Candidate& candidate, const Vector2d& position) const {
  constexpr int kHeights = 12;
  constexpr double kTallest = 1.12;      // of a post's height; there it must have ended
  constexpr double kOtherHue = 12.0;     // steps of chroma
  constexpr double kLeastVisible = 0.6;  // of its heights must be in the image
  const double radius = 0.5 * field_.goal_post_diameter;
  const Vector2d away = frame.view.away(position);
  const Vector2d left(-away.y(), away.x());
  const auto project = [&](double lateral, double height) -> std::optional<Vector2d> {
    const Vector2d point = position + lateral * left;
    auto pixel = frame.view.pixel({point.x(), point.y(), height});
    if (pixel && !inside(frame.image, *pixel)) pixel.reset();
    return pixel;
  };
  const auto differs = [&](const Vector2d& pixel, const Ycbcr& post) {
    const Ycbcr seen = pixel_at(frame.image, pixel);
    return std::abs(seen.y - post.y) > 0.7 * parameters_.post_contrast ||
           pinned::hypot(seen.cb - post.cb, seen.cr - post.cr) > kOtherHue;
  };
  int visible = 0, in_post = 0, left_free = 0, right_free = 0;
  for (int i = 0; i < kHeights; ++i) {
    const double height = field_.goal_height * (i + 0.5) / kHeights;
    const auto middle = project(0.0, height);
    const auto side = frame.view.pixel({position.x() + radius * left.x(), position.y() + radius * left.y(), height});
    if (!middle || !side) continue;
    ++visible;
    const double half = std::abs(side->x() - middle->x());
    const Ycbcr post = pixel_at(frame.image, *middle);
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
  if (visible < kLeastVisible * kHeights || in_post < needed || left_free < needed || right_free < needed) return false;
  const auto above = project(0.0, kTallest * field_.goal_height);
  return !above || differs(*above, candidate.look);
}

}  // namespace reorient
