// SPDX-License-Identifier: MIT
#include "workbench/views/scene/camera_overlay.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "workbench/views/scene/field_scene.h"
#include "workbench/views/scene/histogram.h"

namespace reorient::scene {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Polylines = std::vector<std::vector<Vector2d>>;

constexpr double kFullBar = 0.6;  // fraction of the pixels whose bar is as high as its chart

double mark_size(const CameraModel& camera) { return camera.width / kMarksWidth; }

/// Appends a point, and drops a point between two others on a straight line, because a pinhole camera needs few points.
void append(const Vector2d& pixel, std::vector<Vector2d>& line) {
  constexpr double kStraight = 0.02;  // pixels
  if (line.size() > 1) {
    const Vector2d whole = pixel - line[line.size() - 2], part = line.back() - line[line.size() - 2];
    if (std::abs(whole.x() * part.y() - whole.y() * part.x()) <= kStraight * whole.norm()) line.pop_back();
  }
  line.push_back(pixel);
}

/// Projects lines of the field into the image. Pieces behind the camera or far outside of the image are omitted.
class Projection {
 public:
  Projection(const CameraModel& camera, const Isometry3& world_from_camera)
      : camera_(camera), camera_from_world_(world_from_camera.inverse()) {}

  std::optional<Vector2d> pixel(const Vector3d& point) const {
    const auto projected = camera_.project(camera_from_world_ * point);
    // False for NaN as well.
    const bool is_near = projected && (*projected - camera_.center).cwiseAbs().maxCoeff() <= camera_.width;
    return is_near ? projected : std::nullopt;
  }

  /// One polyline for each visible section of the line through `points`.
  void add_polylines(const std::vector<Vector3d>& points, Polylines& lines) const {
    bool running = false;
    const auto add = [&](const Vector3d& point) {
      const auto projected = pixel(point);
      // A line that leaves an equirectangular image on one side continues on the other side.
      const bool wraps = running && projected && camera_.projection == CameraProjection::equirectangular &&
                         std::abs(projected->x() - lines.back().back().x()) > kPi * camera_.focal.x();
      if (projected && (!running || wraps)) lines.emplace_back();
      if (projected) append(*projected, lines.back());
      running = projected.has_value();
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
      constexpr double kPiece = 0.25, kMostPieces = 40.0;  // m; NaN makes the most pieces
      const Vector3d step = points[i] - points[i - 1];
      const int pieces = static_cast<int>(std::min(kMostPieces, std::ceil(step.norm() / kPiece)));
      for (int piece = 0; piece < pieces; ++piece) add(points[i - 1] + step * (1.0 * piece / pieces));
    }
    if (!points.empty()) add(points.back());
  }

 private:
  CameraModel camera_;
  Isometry3 camera_from_world_;
};

/// Draws a chart on a light plate in the middle of the visible part of a tile.
void add_chart(const std::vector<Vector2d>& outline, const ColorHistogram& histogram, const CameraModel& camera,
               OverlayLayer& layer) {
  const double mark = mark_size(camera);
  Vector2d low(camera.width - 0.5, camera.height - 0.5), high(-0.5, -0.5);
  const Vector2d first = high, last = low;
  for (const Vector2d& corner : outline) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  low = low.cwiseMax(first);
  high = high.cwiseMin(last);
  const Vector2d size = high - low;
  if (size.x() < 34.0 * mark || size.y() < 26.0 * mark) return;  // too small for a readable chart
  const double width = std::min(0.72 * size.x(), 130.0 * mark);
  const Vector2d half(width / 2.0, std::min({0.6 * size.y(), 0.6 * width, 70.0 * mark}) / 2.0);
  const Vector2d middle = (low + high) / 2.0, margin = Vector2d::Constant(4.0 * mark);
  const Vector2d top_left = middle - half, bottom_right = middle + half;
  layer.shapes.push_back({{top_left, {bottom_right.x(), top_left.y()}, bottom_right, {top_left.x(), bottom_right.y()}},
                          {},
                          0.0,
                          true,
                          palette::plate.with_opacity(0.82)});
  add_histogram({histogram, {}}, upright_chart(top_left + margin, bottom_right - margin), kFullBar, 0.5 * mark,
                layer.shapes);
}

/// Symbol of a tile, with an arbitrary histogram.
std::vector<Shape<Vector2d>> tile_symbol() {
  std::vector<Shape<Vector2d>> symbol{
      {{{-15.0, -9.0}, {15.0, -9.0}, {15.0, 9.0}, {-15.0, 9.0}}, palette::faint_ink, 1.0, true, palette::plate}};
  const HistogramBars sample{{0.1F, 0.2F, 0.0F, 0.1F, 0.3F, 0.1F, 0.5F, 0.2F, 0.4F, 0.1F, 0.2F, 0.3F, 0.1F, 0.0F}, {}};
  add_histogram(sample, upright_chart({-12.0, -6.0}, {12.0, 6.0}), kFullBar, 0.5, symbol);
  return symbol;
}

/// A view particle has no height, so it is drawn where its azimuth crosses the middle row of the camera.
OverlayLayer view_belief(const RoomRecord& room, const CameraModel& camera, const Isometry3& field_from_camera) {
  const double mark = mark_size(camera);
  const Projection projection(camera, field_from_camera);
  const Vector3d eye = field_from_camera.translation(), axis = field_from_camera.linear().col(0);
  const double level = axis.head<2>().norm();
  const double wall_radius = Wall(room.basis.wall).radius();
  OverlayLayer layer{room.cells.empty() ? "view particles" : "view cells"};
  const auto add = [&](double azimuth, double radius) {
    const Vector2d foot = wall_radius * unit_vector(azimuth);
    const double reach = level > 1e-6 ? (foot - eye.head<2>()).norm() / level : 0.0;
    if (const auto pixel = projection.pixel({foot.x(), foot.y(), eye.z() + reach * axis.z()}))
      layer.circles.push_back({*pixel, radius * mark, palette::view_particle});
  };
  for (const ViewParticle& particle : room.particles) add(particle.azimuth, 4.0);
  for (const ViewCell& cell : room.cells) {
    constexpr double kWhole = 20.0, kLeast = 0.002;  // marks, of the whole belief in one cell; smallest share
    if (cell.share >= kLeast && cell.share <= 1.0) add(cell.azimuth, kWhole * std::sqrt(cell.share));
  }
  return layer;
}

const std::optional<CameraRecord>& camera_of(const FrameRecord& frame, HeadCamera camera) {
  return camera == HeadCamera::upper ? frame.inputs.upper : frame.inputs.lower;
}

}  // namespace

OverlayLayer polylines(std::string meaning, Polylines lines, Color color, double thickness, const CameraModel& camera) {
  OverlayLayer layer{std::move(meaning)};
  for (auto& line : lines) layer.shapes.push_back({std::move(line), color, thickness * mark_size(camera)});
  return layer;
}

OverlayLayer expected_lines(const FieldDimensions& field, const CameraModel& camera,
                            const Isometry3& field_from_camera) {
  const Projection projection(camera, field_from_camera);
  Polylines lines;
  for (const Shape<Vector3d>& line : field_line_layer(field).shapes) projection.add_polylines(line.points, lines);
  return polylines("lines as believed", std::move(lines), palette::expected, 1.5, camera);
}

OverlayLayer line_points(std::span<const LinePoint> points, const CameraModel& camera,
                         const Isometry3& robot_from_camera) {
  const double mark = mark_size(camera);
  const Projection projection(camera, robot_from_camera);
  OverlayLayer layer{"line points"};
  for (const LinePoint& point : points) {
    constexpr double kStep = 0.05;  // m across the line
    const Vector2d beside = point.position + kStep * unit_vector(point.normal), center = point.pixel.cast<double>();
    if (const auto pixel = projection.pixel({beside.x(), beside.y(), 0.0})) {
      const Vector2d half = 12.0 * mark * (*pixel - center).normalized();
      layer.shapes.push_back({{center - half, center + half}, palette::percept, 1.5 * mark});
    }
    layer.circles.push_back({center, 3.4 * mark, palette::percept});
  }
  return layer;
}

Overlay percept_overlay(const FieldPercept& percept, const CameraModel& camera, const Isometry3& robot_from_camera) {
  const double mark = mark_size(camera);
  Polylines boundary;
  bool running = false;
  for (std::size_t i = 0; i < percept.boundary.size(); ++i) {
    const bool shows_field = percept.boundary[i] < static_cast<float>(camera.height);
    if (shows_field && !running) boundary.emplace_back();
    if (shows_field) {
      const double column =
          (static_cast<double>(i) + 0.5) * camera.width / static_cast<double>(percept.boundary.size());
      boundary.back().emplace_back(column, percept.boundary[i]);
    }
    running = shows_field;
  }
  OverlayLayer obstacles{"obstacles"}, posts{"goal posts"}, landmarks{"landmarks"}, ball{"ball"};
  for (const Obstacle& it : percept.obstacles) {
    const double left = it.left, top = it.top, right = it.right, bottom = it.bottom;
    obstacles.shapes.push_back({{{left, top}, {right, top}, {right, bottom}, {left, bottom}},
                                palette::obstacle,
                                2.0 * mark,
                                true,
                                palette::obstacle.with_opacity(0.22)});
  }
  for (const GoalPost& post : percept.goal_posts) {
    const Vector2d base = post.base.cast<double>();
    posts.shapes.push_back({{base, post.top.cast<double>()}, palette::goal_area, 5.0 * mark});
    posts.circles.push_back({base, 6.0 * mark, palette::goal_area});
  }
  const auto add = [&](OverlayLayer& layer, const Vector2d& pixel, double radius, std::string name, Color color) {
    layer.circles.push_back({pixel, radius, color, 3.0 * mark});
    layer.labels.push_back({pixel + Vector2d(radius, 0.0), std::move(name), 22.0 * mark, color});
  };
  const double ring = 9.0 * mark;
  for (const Intersection& one : percept.intersections)
    add(landmarks, one.pixel.cast<double>(), ring, name_of(one), palette::landmark);
  for (const PenaltyMark& one : percept.penalty_marks)
    add(landmarks, one.pixel.cast<double>(), ring, "mark", palette::landmark);
  if (percept.center_circle) {
    const Vector2d& center = percept.center_circle->center;
    if (const auto pixel = Projection(camera, robot_from_camera).pixel({center.x(), center.y(), 0.0}))
      add(landmarks, *pixel, ring, "center", palette::landmark);
  }
  if (percept.ball)
    add(ball, percept.ball->pixel.cast<double>(), static_cast<double>(percept.ball->radius), "ball", palette::ball);
  return {polylines("field boundary", std::move(boundary), palette::boundary, 2.0, camera),
          std::move(obstacles),
          std::move(posts),
          line_points(percept.line_points, camera, robot_from_camera),
          std::move(landmarks),
          std::move(ball)};
}

OverlayLayer perceived_tiles(std::span<const PerceivedTile> perceived, const Wall& wall, const CameraModel& camera,
                             const Isometry3& field_from_camera) {
  const double mark = mark_size(camera);
  const Projection projection(camera, field_from_camera);
  OverlayLayer layer{.meaning = "wall tiles and their colors", .symbol = tile_symbol()};
  std::vector<const PerceivedTile*> drawn;
  for (const PerceivedTile& one : perceived) {
    std::vector<Vector2d> outline;
    for (const Vector3d& corner : wall.corners(one.tile)) {
      if (const auto pixel = projection.pixel(corner)) outline.push_back(*pixel);
    }
    if (outline.size() != 4) continue;
    drawn.push_back(&one);
    const double thickness = (one.counts ? 1.5 : 1.0) * mark;
    layer.shapes.push_back({std::move(outline), palette::tile_outline, thickness, true, {0, 0, 0, 0.0}, !one.counts});
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {  // above the outlines of all tiles
    if (drawn[i]->counts) add_chart(std::vector(layer.shapes[i].points), drawn[i]->histogram, camera, layer);
  }
  return layer;
}

Overlay field_overlay(const FrameRecord& frame, HeadCamera camera) {
  const std::optional<CameraRecord>& record = camera_of(frame, camera);
  if (!record) return {};
  Overlay overlay =
      percept_overlay(frame.percepts[static_cast<std::size_t>(camera)], record->camera, record->robot_from_camera);
  const Isometry3 field_from_camera = to_isometry(observing_belief(frame)) * record->robot_from_camera;
  overlay.insert(overlay.begin(), expected_lines(frame.world.field, record->camera, field_from_camera));
  return overlay;
}

Overlay room_overlay(const FrameRecord& frame, HeadCamera camera) {
  const std::optional<CameraRecord>& record = camera_of(frame, camera);
  if (!record || frame.room.model.empty()) return {};
  const Isometry3 field_from_camera = to_isometry(observing_belief(frame)) * record->robot_from_camera;
  return {perceived_tiles(frame.room.perceived, Wall(frame.room.basis.wall), record->camera, field_from_camera),
          view_belief(frame.room, record->camera, field_from_camera)};
}

}  // namespace reorient::scene
