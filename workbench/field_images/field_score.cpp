// SPDX-License-Identifier: MIT
#include "workbench/field_images/field_score.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

// In pixels of an image that is 640 pixels wide.
constexpr double kUsualWidth = 640.0;
constexpr double kLeastPiece = 12.0;
constexpr double kOnLine = 4.0;       // largest distance of a point from the middle of its line
constexpr double kOnPost = 6.0;       // half the width of a post's mask
constexpr double kPostFound = 10.0;   // largest sideways error of the foot of a post
constexpr double kBorderFound = 8.0;  // largest error of the border
constexpr double kPieceLength = 0.1;  // m

Vector2d point_between(const Vector2d& a, const Vector2d& b, double share) { return a + share * (b - a); }

double distance_to_segment(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp((point - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (point - point_between(a, b, share)).norm();
}

double distance_to(const LabeledPixels& line, const Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    least = std::min(least, distance_to_segment(point, line[i], line[i + 1]));
  return least;
}

bool is_inside(const LabeledPixels& polygon, const Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2d &a = polygon[i], &b = polygon[j];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

bool is_inside_any(const std::vector<LabeledPixels>& polygons, const Vector2d& point) {
  return std::any_of(polygons.begin(), polygons.end(), [&](const LabeledPixels& one) { return is_inside(one, point); });
}

/// The same line through points that are at most a pixel apart.
LabeledPixels dense(const LabeledPixels& line) {
  LabeledPixels points;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const int steps = std::max(1, static_cast<int>(std::ceil((line[i + 1] - line[i]).norm())));
    for (int k = 0; k < steps; ++k)
      points.push_back(point_between(line[i], line[i + 1], static_cast<double>(k) / steps));
  }
  points.push_back(line.back());
  return points;
}

bool is_in_image(const Vector2d& pixel, const CameraModel& camera) {
  return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= camera.width - 1.0 && pixel.y() <= camera.height - 1.0;
}

/// Pieces from the start of the line; a shorter rest is left out.
LineScore score_line(const LabeledPixels& line, const std::vector<Vector2d>& points, const GroundProjection& view,
                     double scale, double line_range) {
  LineScore score;
  LabeledPixels piece;
  for (const Vector2d& pixel : dense(line)) {
    const auto ground = view.ground(pixel);
    if (!ground || view.distance(*ground) > line_range || !is_in_image(pixel, view.camera())) {
      piece.clear();
      continue;
    }
    piece.push_back(pixel);
    const auto begin = view.ground(piece.front());
    if ((pixel - piece.front()).norm() < kLeastPiece * scale || (*ground - *begin).norm() < kPieceLength) continue;
    ++score.pieces;
    const bool found = std::any_of(points.begin(), points.end(),
                                   [&](const Vector2d& point) { return distance_to(piece, point) <= kOnLine * scale; });
    score.found += found ? 1 : 0;
    piece = {pixel};
  }
  return score;
}

bool is_in_mask(const FieldLabels& labels, const Vector2d& point) {
  for (const LabeledBall& ball : labels.balls) {
    if ((point - ball.center).norm() <= ball.radius) return true;
  }
  for (const LabeledPost& post : labels.posts) {
    if (distance_to_segment(point, post.base, post.top) <= kOnPost) return true;
  }
  return is_inside_any(labels.feet, point) || is_inside_any(labels.boards, point) || is_inside_any(labels.marks, point);
}

struct Matches {
  int found = 0;      ///< labels that a detection fits
  int unlabeled = 0;  ///< detections that fit no label
};

/// `fits`: whether a detection belongs to a label.
template <typename Seen, typename Label, typename Fits>
Matches match(const std::vector<Seen>& seen, const std::vector<Label>& labels, Fits&& fits) {
  Matches matches;
  std::vector<bool> found(labels.size());
  for (const Seen& one : seen) {
    bool is_labeled = false;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (!fits(one, labels[i])) continue;
      is_labeled = true;
      found[i] = true;
    }
    matches.unlabeled += is_labeled ? 0 : 1;
  }
  matches.found = static_cast<int>(std::count(found.begin(), found.end(), true));
  return matches;
}

void score_posts(const FieldPercept& percept, const FieldLabels& labels, double to_labels, FieldScore& score) {
  const double most = kPostFound * labels.width / kUsualWidth;
  const Matches matches = match(percept.goal_posts, labels.posts, [&](const GoalPost& post, const LabeledPost& label) {
    return std::abs(to_labels * post.base.x() - label.base.x()) <= most;
  });
  score.posts = static_cast<int>(labels.posts.size());
  score.posts_found = matches.found;
  score.false_posts = matches.unlabeled;
}

/// Lower edge of the boards in a column, if any are labeled there.
std::optional<double> lower_edge(const std::vector<LabeledPixels>& boards, double column) {
  std::optional<double> lowest;
  for (const LabeledPixels& polygon : boards) {
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const Vector2d &a = polygon[i], &b = polygon[j];
      if ((a.x() > column) == (b.x() > column)) continue;
      const double row = a.y() + (column - a.x()) * (b.y() - a.y()) / (b.x() - a.x());
      lowest = std::max(lowest.value_or(row), row);
    }
  }
  return lowest;
}

void score_border(const FieldPercept& percept, const FieldLabels& labels, double to_labels, FieldScore& score) {
  const double column_width = static_cast<double>(labels.width) / static_cast<double>(percept.boundary.size());
  for (std::size_t i = 0; i < percept.boundary.size(); ++i) {
    const auto row = lower_edge(labels.boards, (static_cast<double>(i) + 0.5) * column_width);
    if (!row) continue;
    ++score.border_columns;
    if (std::abs(to_labels * percept.boundary[i] - *row) <= kBorderFound * labels.width / kUsualWidth)
      ++score.border_found;
  }
}

/// An obstacle belongs to feet if its middle is within their columns.
void score_obstacles(const FieldPercept& percept, const FieldLabels& labels, double to_labels, FieldScore& score) {
  const Matches matches = match(percept.obstacles, labels.feet, [&](const Obstacle& seen, const LabeledPixels& feet) {
    const double middle = to_labels * 0.5 * (seen.left + seen.right);
    const auto [left, right] = std::minmax_element(feet.begin(), feet.end(),
                                                   [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x(); });
    return middle >= left->x() && middle <= right->x();
  });
  score.robots = static_cast<int>(labels.feet.size());
  score.robots_found = matches.found;
  score.false_obstacles = matches.unlabeled;
}

/// Whether a square of this half width around a point is inside of the labeled image.
bool is_whole(const FieldLabels& labels, const Vector2d& middle, double reach, double height) {
  return middle.x() >= reach && middle.y() >= reach && middle.x() + reach <= labels.width &&
         middle.y() + reach <= height;
}

void score_ball(const FieldPercept& percept, const FieldLabels& labels, double to_labels, double height,
                FieldScore& score) {
  bool is_known = false;
  for (const LabeledBall& ball : labels.balls) {
    const bool found =
        percept.ball && (to_labels * percept.ball->pixel.cast<double>() - ball.center).norm() <= ball.radius;
    is_known = is_known || found;
    if (!is_whole(labels, ball.center, ball.radius, height)) continue;
    ++score.balls;
    score.balls_found += found ? 1 : 0;
  }
  score.false_balls = percept.ball && !is_known ? 1 : 0;
}

void score_marks(const FieldPercept& percept, const FieldLabels& labels, double to_labels, double height,
                 FieldScore& score) {
  const auto lies_in = [&](const PenaltyMark& mark, const LabeledPixels& polygon) {
    return is_inside(polygon, to_labels * mark.pixel.cast<double>());
  };
  for (const LabeledPixels& polygon : labels.marks) {
    if (!std::all_of(polygon.begin(), polygon.end(),
                     [&](const Vector2d& corner) { return is_whole(labels, corner, 1.0, height); })) {
      continue;
    }
    ++score.marks;
    score.marks_found += std::any_of(percept.penalty_marks.begin(), percept.penalty_marks.end(),
                                     [&](const PenaltyMark& mark) { return lies_in(mark, polygon); })
                             ? 1
                             : 0;
  }
  for (const PenaltyMark& mark : percept.penalty_marks) {
    score.false_marks += std::none_of(labels.marks.begin(), labels.marks.end(),
                                      [&](const LabeledPixels& polygon) { return lies_in(mark, polygon); })
                             ? 1
                             : 0;
  }
}

}  // namespace

FieldScore operator+(FieldScore a, const FieldScore& b) {
  a.lines.insert(a.lines.end(), b.lines.begin(), b.lines.end());
  a.line_points += b.line_points;
  a.on_lines += b.on_lines;
  a.in_masks += b.in_masks;
  a.posts += b.posts;
  a.posts_found += b.posts_found;
  a.false_posts += b.false_posts;
  a.border_columns += b.border_columns;
  a.border_found += b.border_found;
  a.robots += b.robots;
  a.robots_found += b.robots_found;
  a.false_obstacles += b.false_obstacles;
  a.balls += b.balls;
  a.balls_found += b.balls_found;
  a.false_balls += b.false_balls;
  a.marks += b.marks;
  a.marks_found += b.marks_found;
  a.false_marks += b.false_marks;
  a.shows_carpet = a.shows_carpet || b.shows_carpet;
  return a;
}

CameraModel camera_of(const FieldLabels& labels, int width, int height) {
  const double vertical = 2.0 * pinned::atan2(std::tan(0.5 * labels.field_of_view) * height, width);
  return CameraModel::from_fields_of_view(width, height, labels.field_of_view, vertical);
}

FieldScore score_of(const FieldPercept& percept, const FieldLabels& labels, const GroundProjection& view,
                    double line_range) {
  FieldScore score;
  const double to_labels = static_cast<double>(labels.width) / view.camera().width;
  const auto in_image = [&](const LabeledPixels& line) {
    LabeledPixels pixels;
    for (const Vector2d& pixel : line) pixels.emplace_back(pixel / to_labels);
    return pixels;
  };
  std::vector<Vector2d> points;
  for (const LinePoint& point : percept.line_points) points.emplace_back(point.pixel.cast<double>());
  const double scale = std::max(1.0, view.camera().width / kUsualWidth);
  for (const LabeledPixels& line : labels.lines)
    score.lines.push_back(score_line(in_image(line), points, view, scale, line_range));

  for (const Vector2d& point : points) {
    const Vector2d pixel = to_labels * point;
    if (is_inside_any(labels.ignored, pixel)) continue;
    ++score.line_points;
    const bool on_line = std::any_of(labels.lines.begin(), labels.lines.end(), [&](const LabeledPixels& line) {
      return distance_to(line, pixel) <= kOnLine * scale * to_labels;
    });
    if (on_line)
      ++score.on_lines;
    else if (is_in_mask(labels, pixel))
      ++score.in_masks;
  }
  score_posts(percept, labels, to_labels, score);
  score_border(percept, labels, to_labels, score);
  score_obstacles(percept, labels, to_labels, score);
  const double height = to_labels * view.camera().height;
  score_ball(percept, labels, to_labels, height, score);
  score_marks(percept, labels, to_labels, height, score);
  score.shows_carpet = shows_carpet(percept.boundary, view.camera().height);
  return score;
}

}  // namespace reorient
