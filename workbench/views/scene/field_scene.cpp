// SPDX-License-Identifier: MIT
#include "workbench/views/scene/field_scene.h"

#include <algorithm>
#include <utility>

#include "geometry/field_landmarks.h"

namespace reorient::scene {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d at_height(const Eigen::Vector2d& point, double height) { return {point.x(), point.y(), height}; }
Eigen::Vector3d on_ground(const Eigen::Vector2d& point) { return at_height(point, 0.0); }

Points arc_on_ground(const Eigen::Vector2d& center, double radius, double from, double to) {
  constexpr int kSteps = 48;
  Points points;
  for (int i = 0; i <= kSteps; ++i)
    points.push_back(on_ground(center + radius * unit_vector(from + (to - from) * i / kSteps)));
  return points;
}

SceneLayer goals(const FieldDimensions& field) {
  const Color color = field.yellow_goals ? palette::yellow_goal : palette::white_goal;
  SceneLayer layer{"goals"};
  for (const double side : {-1.0, 1.0}) {
    const auto outline = goal_outline(field, side);
    const double front = outline[0].x(), y = outline[0].y(), height = field.goal_height;
    layer.shapes.push_back(
        {{on_ground(outline[0]), on_ground(outline[1]), on_ground(outline[2]), on_ground(outline[3])},
         color.with_opacity(0.8),
         0.02,
         true,
         color.with_opacity(0.28)});
    layer.shapes.push_back({{{front, -y, height}, {front, y, height}}, color, field.goal_post_diameter});
    const char* const name = side > 0.0 ? "opponent" : "own";
    layer.labels.push_back({{front + side * field.border, 0.0, height + 0.3}, name, 0.3, color});
  }
  for (const Eigen::Vector2d& post : goal_posts(field))
    layer.circles.push_back({on_ground(post), field.goal_post_diameter / 2.0, color, 0.0, field.goal_height});
  return layer;
}

/// The opacity of a feature: full if it fits the field, and if its fit is unknown.
double opacity_of(const std::vector<float>& fits, std::size_t feature) {
  constexpr double kRejected = 0.4, kUnused = 0.2;
  if (feature >= fits.size()) return 1.0;
  if (fits[feature] < 0.0F) return kUnused;
  return fits[feature] < 1.0F ? 1.0 : kRejected;
}

}  // namespace

SceneLayer field_line_layer(const FieldDimensions& field) {
  SceneLayer layer{"field lines"};
  const auto add = [&](Points points) {
    layer.shapes.push_back({std::move(points), palette::field_line, field.line_width});
  };
  for (const FieldLine& line : field_lines(field)) add({on_ground(line.from), on_ground(line.to)});
  std::vector<Eigen::Vector2d> marks = penalty_marks(field);
  marks.emplace_back(0.0, 0.0);
  const double half = 0.5 * field.penalty_mark_size;
  for (const Eigen::Vector2d& mark : marks) {
    for (const Eigen::Vector2d& arm : {Eigen::Vector2d(half, 0.0), Eigen::Vector2d(0.0, half)})
      add({on_ground(mark - arm), on_ground(mark + arm)});
  }
  add(arc_on_ground({0.0, 0.0}, field.center_circle_radius, 0.0, 2.0 * kPi));
  for (const auto& [corner, begin] : corner_arcs(field))
    add(arc_on_ground(corner, field.corner_arc_radius, begin, begin + 0.5 * kPi));
  return layer;
}

Scene field_scene(const FieldDimensions& field) {
  SceneLayer carpet{"carpet"};
  const auto add = [&](const Eigen::Vector2d& half_size, double height, Color color) {  // below the lines
    const double x = half_size.x(), y = half_size.y();
    carpet.shapes.push_back(
        {{{-x, -y, height}, {x, -y, height}, {x, y, height}, {-x, y, height}}, {}, 0.0, true, color});
  };
  add(carpet_half_size(field), -0.02, palette::carpet_border);
  add(field_half_size(field), -0.01, palette::carpet);
  return {std::move(carpet), field_line_layer(field), goals(field)};
}

std::vector<ViewShare> view_shares(const RoomRecord& room) {
  std::vector<ViewShare> shares;
  for (const ViewCell& cell : room.cells) shares.push_back({cell.azimuth, cell.share});
  for (const ViewParticle& particle : room.particles) shares.push_back({particle.azimuth, 1.0});
  double most = 0.0;
  for (const ViewShare& one : shares) most = std::max(most, one.share);
  std::erase_if(shares, [most](const ViewShare& one) { return one.share < 0.01 * most; });
  for (ViewShare& one : shares) one.share /= most;
  return shares;
}

Scene wall_scene(const RoomRecord& room) {
  const Wall wall(room.basis.wall);
  SceneLayer tiles{"wall tiles"};
  const Light shown;  // the light in which the room is shown
  for (int tile = 0; tile < std::min(wall.tiles(), static_cast<int>(room.model.size())); ++tile) {
    const TileModel& model = room.model[static_cast<std::size_t>(tile)];
    const auto corners = wall.corners(tile);
    const Color mean = to_color(shown.luma * model.light.luma, shown.cb + model.light.cb, shown.cr + model.light.cr);
    const Color color = model.light_visits > 0 ? mean.with_opacity(0.9) : palette::unknown_tile;
    tiles.shapes.push_back({{corners.begin(), corners.end()}, {}, 0.0, true, color});
  }
  return {std::move(tiles)};
}

Scene view_scene(const RoomRecord& room) {
  const Wall wall(room.basis.wall);
  SceneLayer view{"belief of the view"};
  for (const auto& [azimuth, share] : view_shares(room)) {
    constexpr double kTallest = 2.0;  // m
    const Eigen::Vector2d foot = 0.95 * wall.radius() * unit_vector(azimuth);
    view.shapes.push_back({{on_ground(foot), at_height(foot, kTallest * share)}, palette::view_particle, 0.06});
  }
  return {std::move(view)};
}

Scene percept_scene(std::span<const FieldPercept> percepts, std::span<const FeatureFits> fits) {
  SceneLayer points{"line points"}, posts{"goal posts"}, obstacles{"obstacles"}, landmarks{"landmarks"}, balls{"ball"};
  const FeatureFits unknown;
  for (std::size_t camera = 0; camera < percepts.size(); ++camera) {
    const FieldPercept& percept = percepts[camera];
    const FeatureFits& fit = camera < fits.size() ? fits[camera] : unknown;
    for (std::size_t i = 0; i < percept.line_points.size(); ++i) {
      const LinePoint& point = percept.line_points[i];
      const Eigen::Vector2d across = 0.06 * unit_vector(point.normal);
      points.shapes.push_back({{on_ground(point.position - across), on_ground(point.position + across)},
                               palette::percept.with_opacity(opacity_of(fit.line_points, i)),
                               0.02});
    }
    const auto stand = [](SceneLayer& layer, const Eigen::Vector2d& at, double height, double diameter, Color color) {
      layer.circles.push_back({on_ground(at), diameter / 2.0, color, 0.0, height});
    };
    for (std::size_t i = 0; i < percept.goal_posts.size(); ++i) {
      const GoalPost& post = percept.goal_posts[i];
      const double opacity = (post.base_visible ? 1.0 : 0.7) * opacity_of(fit.goal_posts, i);
      stand(posts, post.position, 0.8, 0.1, palette::goal_area.with_opacity(opacity));
    }
    for (const Obstacle& obstacle : percept.obstacles)
      stand(obstacles, obstacle.position, 0.3, 0.3, palette::obstacle.with_opacity(0.8));
    for (const Intersection& one : percept.intersections)
      landmarks.labels.push_back({at_height(one.position, 0.1), name_of(one), 0.15, palette::landmark});
    for (const PenaltyMark& mark : percept.penalty_marks)
      stand(landmarks, mark.position, 0.02, 0.15, palette::landmark);
    if (percept.center_circle) stand(landmarks, percept.center_circle->center, 0.02, 0.3, palette::landmark);
    if (percept.ball) stand(balls, percept.ball->position, 0.1, 0.1, palette::ball);
  }
  return {std::move(points), std::move(posts), std::move(obstacles), std::move(landmarks), std::move(balls)};
}

std::vector<PoseLayer> pose_layers(const std::vector<Pose2>& particles, const std::optional<Pose2>& truth,
                                   const std::optional<Pose2>& belief) {
  std::vector<PoseLayer> layers;
  if (!particles.empty()) layers.push_back({"pose particles", particles, palette::pose_particle, 2.6, false});
  if (truth) layers.push_back({"true pose", {*truth}, palette::truth, 12.0, true});
  if (belief) layers.push_back({"believed pose", {*belief}, palette::belief, 8.0, true});
  return layers;
}

const Pose2& observing_belief(const FrameRecord& frame) {
  return frame.reorientation ? frame.reorientation->belief_before.pose : frame.world.pose.pose;
}

}  // namespace reorient::scene
