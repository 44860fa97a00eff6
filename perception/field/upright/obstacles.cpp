// SPDX-License-Identifier: MIT
#include "perception/field/upright/obstacles.h"

#include <algorithm>
#include <cmath>

namespace reorient {
namespace {

constexpr std::size_t kMostObstacles = 20;

/// Whether the object here is the ball.
bool is_ball(const FieldPercept& percept, double x, double row) {
  if (!percept.ball) return false;
  constexpr double kMargin = 1.5;  // multiple of the radius
  return (percept.ball->pixel.cast<double>() - Eigen::Vector2d(x, row)).norm() <
         kMargin * static_cast<double>(percept.ball->radius);
}

bool is_post(const FieldPercept& percept, double x, double column_width) {
  for (const GoalPost& post : percept.goal_posts) {
    const double half = 0.1 * std::abs(post.base.y() - post.top.y()) + column_width;
    if (std::abs(x - post.base.x()) <= half) return true;
  }
  return false;
}

}  // namespace

Obstacles::Obstacles(const FieldFeatureParameters& parameters) : parameters_(parameters) {}

void Obstacles::find(const CarpetMap& map, const GroundProjection& view, const KnownLines& lines, double least_height,
                     FieldPercept& percept) {
  constexpr int kMostLines = 3;       // lines that are skipped
  constexpr double kSameThing = 2.0;  // a hand at half of the camera's height seems to be twice as far away as the feet
  constexpr double kGap = 0.12;       // m of carpet between two legs
  percept.obstacles.clear();
  for (int i = 0; i < CarpetMap::kColumns; ++i) {
    farthest_[static_cast<std::size_t>(i)] = farthest_in(map, view, percept, i);
    Foot& foot = feet_[static_cast<std::size_t>(i)];
    foot = foot_in(map, view, percept, i, map.rows() - 1, least_height);
    // Cells of a line below a foot are not carpet either. Search again above the line.
    for (int again = 0; again < kMostLines && foot.row >= 0; ++again) {
      const int row = above_line(map, view, lines, i, foot.row / map.step() - 1);
      if (row >= foot.row / map.step() - 1) break;
      foot = foot_in(map, view, percept, i, row, least_height);
    }
  }
  int first = -1;
  int last = -1;
  double nearest = 0.0;
  for (int i = 0; i < CarpetMap::kColumns; ++i) {
    const Foot& foot = feet_[static_cast<std::size_t>(i)];
    if (foot.row < 0) continue;
    const double scale = view.pixels_per_radian(Eigen::Vector2d(map.column_pixel(i), foot.row));
    const double gap = std::max(2.0, kGap * scale / (foot.distance * map.column_width()));
    const bool continues =
        last >= 0 && i - last <= gap && foot.distance < kSameThing * nearest && nearest < kSameThing * foot.distance;
    if (!continues) {
      if (last >= 0) add(map, view, first, last, percept);
      first = i;
    }
    nearest = continues ? std::min(nearest, foot.distance) : foot.distance;
    last = i;
  }
  if (last >= 0) add(map, view, first, last, percept);
}

/// The largest distance (m) of an obstacle in a column of the map. Negative: no obstacle can be there.
double Obstacles::farthest_in(const CarpetMap& map, const GroundProjection& view, const FieldPercept& percept,
                              int column) const {
  constexpr double kInside = 0.4;  // m, smallest distance to the border of the carpet
  const double x = map.column_pixel(column);
  if (is_post(percept, x, map.column_width())) return -1.0;
  const auto border = view.ground({x, static_cast<double>(percept.boundary[static_cast<std::size_t>(column)])});
  return std::min(parameters_.obstacle_range, border ? view.distance(*border) - kInside : 1e9);
}

Obstacles::Foot Obstacles::foot_in(const CarpetMap& map, const GroundProjection& view, const FieldPercept& percept,
                                   int column, int first_row, double least_height) const {
  const double most_gap = 0.05 / least_height;  // carpet color that does not end an obstacle: noise, knees
  constexpr double kLeastFraction = 0.5;        // fraction of its cells that certainly are not carpet
  const double x = map.column_pixel(column);
  const double border = percept.boundary[static_cast<std::size_t>(column)];
  const double farthest = farthest_[static_cast<std::size_t>(column)];
  if (farthest < 0.0) return {};
  int carpet = 0, other = 0, cells = 0;
  Foot foot;
  double head_row = 0.0;
  for (int row = first_row; row >= map.first_cell(); --row) {
    const Surface surface = map.at(column, row);
    carpet = surface == Surface::carpet ? carpet + 1 : 0;
    if (carpet * map.step() > most_gap * (foot.row - head_row)) foot = {};
    if (foot.row < 0) {
      if (map.row_pixel(row) < border) break;
      if (surface != Surface::other) continue;
      foot.row = map.row_pixel(row) + map.step();
      other = cells = 0;
      const auto ground = view.ground({x, static_cast<double>(foot.row)});
      if (!ground || view.distance(*ground) > farthest || is_ball(percept, x, foot.row)) break;
      const auto head = view.pixel({ground->x(), ground->y(), least_height});
      if (!head) break;
      foot.distance = view.distance(*ground);
      head_row = head->y();
    }
    ++cells;
    other += surface == Surface::other ? 1 : 0;
    if (map.row_pixel(row) > head_row || surface == Surface::carpet) continue;
    return other >= kLeastFraction * cells ? foot : Foot{};
  }
  return {};
}

/// The first row of cells, from this one up, that is on none of the lines.
int Obstacles::above_line(const CarpetMap& map, const GroundProjection& view, const KnownLines& lines, int column,
                          int row) const {
  const double x = map.column_pixel(column);
  for (; row > map.first_cell(); --row) {
    const auto ground = view.ground({x, static_cast<double>(map.row_pixel(row))});
    if (!ground || !lines.at(*ground)) break;
  }
  return row;
}

/// For an object as narrow as a ball: whether it is taller than any ball, and well inside the border, which may have a
/// dent.
bool Obstacles::is_sure(const CarpetMap& map, const GroundProjection& view, const FieldPercept& percept, int first,
                        int last) const {
  constexpr double kTall = 0.3;    // m
  constexpr double kInside = 0.8;  // m
  for (int i = first; i <= last; ++i) {
    const Foot& foot = feet_[static_cast<std::size_t>(i)];
    if (foot.row < 0) continue;
    const auto border = view.ground(
        {static_cast<double>(map.column_pixel(i)), static_cast<double>(percept.boundary[static_cast<std::size_t>(i)])});
    if (border && view.distance(*border) < foot.distance + kInside) return false;
  }
  for (int i = first; i <= last; ++i) {
    const Foot& foot = feet_[static_cast<std::size_t>(i)];
    if (foot.row >= 0 && foot_in(map, view, percept, i, foot.row / map.step() - 1, kTall).row >= 0) return true;
  }
  return false;
}

void Obstacles::add(const CarpetMap& map, const GroundProjection& view, int first, int last,
                    FieldPercept& percept) const {
  constexpr double kWidest = 2.5;   // m
  constexpr double kNarrow = 0.16;  // m; narrower objects need the check is_sure()
  if (percept.obstacles.size() >= kMostObstacles) return;
  const auto lowest = std::max_element(feet_.begin() + first, feet_.begin() + last + 1,
                                       [](const Foot& a, const Foot& b) { return a.row < b.row; });
  const double half_column = 0.5 * map.column_width();
  const double middle = 0.5 * (map.column_pixel(first) + map.column_pixel(last));
  const auto position = view.ground({middle, static_cast<double>(lowest->row)});
  if (!position) return;
  const double scale = view.pixels_per_radian(Eigen::Vector2d(middle, lowest->row));
  const double width = (last - first + 1) * map.column_width() * lowest->distance / scale;
  if (width < parameters_.obstacle_width || width > kWidest) return;
  if (width < kNarrow && !is_sure(map, view, percept, first, last)) return;
  const auto head = view.pixel({position->x(), position->y(), parameters_.obstacle_height});
  Obstacle obstacle;
  obstacle.position = *position;
  obstacle.left = std::max(0, static_cast<int>(map.column_pixel(first) - half_column));
  obstacle.right = std::min(view.camera().width - 1, static_cast<int>(map.column_pixel(last) + half_column));
  obstacle.bottom = std::min(lowest->row, view.camera().height - 1);
  obstacle.top = head ? static_cast<int>(std::clamp(head->y(), 0.0, 1.0 * obstacle.bottom)) : 0;
  percept.obstacles.push_back(obstacle);
}

}  // namespace reorient
