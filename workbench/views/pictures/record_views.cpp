#include "workbench/views/pictures/record_views.h"

#include <cmath>
#include <string>
#include <vector>

#include "geometry/field_landmarks.h"

namespace reorient::pictures {
namespace {

HistogramBars bars(const ColorHistogram& mean) {
  HistogramBars result;
  for (std::size_t bin = 0; bin < mean.size(); ++bin) result.share[bin] = mean[bin];
  return result;
}

HistogramBars bars(const TileModel& tile) {
  HistogramBars result = bars(tile.mean);
  for (std::size_t bin = 0; bin < tile.variance.size(); ++bin) result.deviation[bin] = std::sqrt(tile.variance[bin]);
  return result;
}

WallTile wall_tile(const Wall& wall, int tile) {
  const double from = wall.column_of(tile) * wall.column_width();
  return {from, from + wall.column_width(), wall.row_of(tile), {}};
}

void add_room(const RoomRecord& room, WorldView& view) {
  if (room.model.empty()) return;  // room awareness is off
  const Wall wall(room.basis.wall);
  view.wall_radius = wall.radius();
  for (int tile = 0; tile < std::min(wall.tiles(), static_cast<int>(room.model.size())); ++tile) {
    WallTile drawn = wall_tile(wall, tile);
    const TileModel& model = room.model[static_cast<std::size_t>(tile)];
    if (model.visits > 0) drawn.histogram = bars(model);
    (model.visits > 0 ? view.model : view.untrained).push_back(drawn);
  }
  for (const PerceivedTile& perceived : room.perceived) {
    if (!perceived.counts) continue;
    WallTile drawn = wall_tile(wall, perceived.tile);
    drawn.histogram = bars(perceived.histogram);
    view.perceived.push_back(drawn);
  }
  for (const ViewParticle& particle : room.particles) view.view_particles.push_back(particle.azimuth);
  const double half_cell = kPi / static_cast<double>(room.cells.size());
  for (const reorient::ViewCell& cell : room.cells)
    view.view_cells.push_back({cell.azimuth - half_cell, cell.azimuth + half_cell, cell.share});
  for (const reorient::ViewCluster& cluster : room.clusters) {
    if (cluster.share >= 0.1) view.view_clusters.push_back({cluster.azimuth, cluster.spread});
  }
  view.view_azimuth = room.center_of_view;
  view.view_half_width = room.half_width;
  view.goal_area_half_width = room.goal_half_width;
}

/// The belief before the frame's reorientation, if it had one: what the room was looked at with.
const Pose2& belief_when_looking(const FrameRecord& frame) {
  return frame.reorientation ? frame.reorientation->belief_before.pose : frame.world.pose.pose;
}

/// Points of the field seen through the camera; pieces behind it or far outside of the image are left out.
class Projection {
 public:
  Projection(const CameraModel& camera, const Isometry3& field_from_camera)
      : camera_(camera), field_from_camera_(field_from_camera), camera_from_field_(field_from_camera.inverse()) {}

  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& point) const {
    auto projected = camera_.project(camera_from_field_ * point);
    const double margin = camera_.width;
    if (!projected || std::abs(projected->x() - camera_.center.x()) > margin ||
        std::abs(projected->y() - camera_.center.y()) > margin) {
      return std::nullopt;
    }
    return projected;
  }

  /// One polyline for each run of visible points.
  void add_polyline(const std::vector<Eigen::Vector3d>& points,
                    std::vector<std::vector<Eigen::Vector2d>>& polylines) const {
    bool running = false;
    for (const Eigen::Vector3d& point : points) {
      const auto projected = pixel(point);
      // What leaves an equirectangular image on one side comes back on the other one.
      const bool wraps = running && projected && camera_.projection == CameraProjection::equirectangular &&
                         std::abs(projected->x() - polylines.back().back().x()) > kPi * camera_.focal.x();
      if (projected && (!running || wraps)) polylines.emplace_back();
      if (projected) polylines.back().push_back(*projected);
      running = projected.has_value();
    }
  }

  const Isometry3& field_from_camera() const { return field_from_camera_; }

 private:
  CameraModel camera_;
  Isometry3 field_from_camera_;
  Isometry3 camera_from_field_;
};

std::vector<Eigen::Vector3d> sampled(const FieldLine& line) {
  constexpr int kPieces = 40;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= kPieces; ++i) {
    const Eigen::Vector2d point = line.from + (line.to - line.from) * (static_cast<double>(i) / kPieces);
    points.emplace_back(point.x(), point.y(), 0.0);
  }
  return points;
}

/// Around a place on the field, from one direction on, rad.
std::vector<Eigen::Vector3d> sampled_circle(const Eigen::Vector2d& center, double radius, double begin, double turn) {
  constexpr double kPiece = kPi / 36.0;
  const int pieces = static_cast<int>(std::ceil(turn / kPiece));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = begin + turn * i / pieces;
    points.emplace_back(center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle), 0.0);
  }
  return points;
}

void add_circles(const FieldDimensions& field, const Projection& projection, CameraView& view) {
  projection.add_polyline(sampled_circle({0.0, 0.0}, field.center_circle_radius, 0.0, 2.0 * kPi), view.projected_lines);
  if (field.corner_arc_radius <= 0.0) return;
  const double x = 0.5 * field.length, y = 0.5 * field.width;
  const std::pair<Eigen::Vector2d, double> corners[] = {
      {{x, y}, kPi}, {{-x, y}, 1.5 * kPi}, {{-x, -y}, 0.0}, {{x, -y}, 0.5 * kPi}};
  for (const auto& [corner, begin] : corners)
    projection.add_polyline(sampled_circle(corner, field.corner_arc_radius, begin, 0.5 * kPi), view.projected_lines);
}

void add_projected_tiles(std::span<const PerceivedTile> perceived, const Wall& wall, const Projection& projection,
                         CameraView& view) {
  for (const PerceivedTile& one : perceived) {
    ImageTile tile;
    tile.counted = one.counts;
    tile.perceived = bars(one.histogram);
    for (const Eigen::Vector3d& corner : wall.corners(one.tile)) {
      if (const auto pixel = projection.pixel(corner)) tile.corners.push_back(*pixel);
    }
    if (tile.corners.size() == 4) view.tiles.push_back(std::move(tile));
  }
}

void add_room(const RoomRecord& room, const Projection& projection, CameraView& view) {
  if (room.model.empty()) return;
  const Wall wall(room.basis.wall);
  add_projected_tiles(room.perceived, wall, projection, view);
  // A viewpoint has no height of its own: it is drawn where its azimuth crosses the middle row of the camera.
  const Eigen::Vector3d eye = projection.field_from_camera().translation();
  const Eigen::Vector3d axis = projection.field_from_camera().linear().col(0);
  const auto pixel_of = [&](double azimuth) {
    const Eigen::Vector2d foot(wall.radius() * std::cos(azimuth), wall.radius() * std::sin(azimuth));
    const double reach = axis.head<2>().norm() > 1e-6 ? (foot - eye.head<2>()).norm() / axis.head<2>().norm() : 0.0;
    return projection.pixel({foot.x(), foot.y(), eye.z() + reach * axis.z()});
  };
  for (const ViewParticle& particle : room.particles) {
    if (const auto pixel = pixel_of(particle.azimuth)) view.view_particles.push_back(*pixel);
  }
  for (const reorient::ViewCell& cell : room.cells) {
    if (const auto pixel = pixel_of(cell.azimuth)) view.view_cells.push_back({*pixel, cell.share});
  }
}

}  // namespace

WorldView world_view_of(const FrameRecord& frame, const StageRecord& stage) {
  WorldView view;
  view.field = frame.world.field;
  view.time = frame.world.time;
  view.pose_particles = frame.pose_particles.particles;
  if (frame.reorientation) {
    view.note = "before the command " + std::string(to_string(frame.reorientation->reorientation));
    view.pose_particles = frame.pose_particles.before;
  }
  if (stage.truth) view.truth = stage.truth->pose;
  view.belief = belief_when_looking(frame);
  add_room(frame.room, view);
  return view;
}

WorldView world_view_of(const RoomRecord& room, const FieldDimensions& field) {
  WorldView view;
  view.field = field;
  add_room(room, view);
  return view;
}

void add_line_points(std::span<const LinePoint> points, const CameraModel& camera, const Isometry3& robot_from_camera,
                     CameraView& view) {
  const Isometry3 camera_from_robot = robot_from_camera.inverse();
  for (const LinePoint& point : points) {
    constexpr double kStep = 0.05;  // m across the line
    const Eigen::Vector2d beside =
        point.position + kStep * Eigen::Vector2d(std::cos(point.normal), std::sin(point.normal));
    const auto pixel = camera.project(camera_from_robot * Eigen::Vector3d(beside.x(), beside.y(), 0.0));
    const Eigen::Vector2d place = point.pixel.cast<double>();
    view.line_points.push_back({place, pixel ? Eigen::Vector2d(*pixel - place) : Eigen::Vector2d::Zero()});
  }
}

void add_percept(const FieldPercept& percept, const CameraModel& camera, const Isometry3& robot_from_camera,
                 CameraView& view) {
  add_line_points(percept.line_points, camera, robot_from_camera, view);
  for (const GoalPost& post : percept.goal_posts)
    view.goal_posts.push_back({post.base.cast<double>(), post.top.cast<double>()});
  for (const Obstacle& obstacle : percept.obstacles) {
    view.obstacles.push_back({static_cast<double>(obstacle.left), static_cast<double>(obstacle.top),
                              static_cast<double>(obstacle.right), static_cast<double>(obstacle.bottom)});
  }
  for (const Intersection& one : percept.intersections)
    view.landmarks.push_back({one.pixel.cast<double>(), 0.0, one.corner_arc ? "corner" : name_of(one.kind)});
  for (const PenaltyMark& mark : percept.penalty_marks)
    view.landmarks.push_back({mark.pixel.cast<double>(), 0.0, "mark"});
  if (percept.ball) {
    view.landmarks.push_back({percept.ball->pixel.cast<double>(), static_cast<double>(percept.ball->radius), "ball"});
  }
  if (percept.center_circle) {
    const Eigen::Vector2d& center = percept.center_circle->center;
    const auto pixel = camera.project(robot_from_camera.inverse() * Eigen::Vector3d(center.x(), center.y(), 0.0));
    if (pixel) view.landmarks.push_back({*pixel, 0.0, "center"});
  }
  const double columns = static_cast<double>(percept.boundary.size());
  const double width = view.image.empty() ? camera.width : view.image.width;
  for (std::size_t i = 0; i < percept.boundary.size(); ++i)
    view.boundary.emplace_back((static_cast<double>(i) + 0.5) * width / columns, percept.boundary[i]);
}

void add_tiles(std::span<const PerceivedTile> perceived, const Wall& wall, const CameraModel& camera,
               const Isometry3& field_from_camera, CameraView& view) {
  add_projected_tiles(perceived, wall, Projection(camera, field_from_camera), view);
}

void add_field_lines(const FieldDimensions& field, const CameraModel& camera, const Isometry3& field_from_camera,
                     CameraView& view) {
  const Projection projection(camera, field_from_camera);
  for (const FieldLine& line : field_lines(field)) projection.add_polyline(sampled(line), view.projected_lines);
  add_circles(field, projection, view);
}

CameraView camera_view_of(const FrameRecord& frame) {
  const bool is_upper = frame.inputs.upper.has_value();
  const std::optional<CameraRecord>& camera = is_upper ? frame.inputs.upper : frame.inputs.lower;
  CameraView view;
  view.time = frame.world.time;
  if (!camera) return view;
  view.image = is_upper ? frame.images.upper : frame.images.lower;
  const Isometry3 field_from_camera = to_isometry(belief_when_looking(frame)) * camera->robot_from_camera;
  add_field_lines(frame.world.field, camera->camera, field_from_camera, view);
  add_percept(frame.percepts[is_upper ? 0 : 1], camera->camera, camera->robot_from_camera, view);
  add_room(frame.room, Projection(camera->camera, field_from_camera), view);
  return view;
}

}  // namespace reorient::pictures
