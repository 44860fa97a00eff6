#include "program/run/run_pictures.h"

#include <cmath>
#include <string>
#include <vector>

#include "localization/measurement/field_map.h"
#include "workbench/views/pictures/camera_view.h"
#include "workbench/views/pictures/canvas/png_file.h"
#include "workbench/views/pictures/confidence_plot.h"
#include "workbench/views/pictures/reorientation_view.h"
#include "workbench/views/pictures/world_view.h"

namespace reorient {
namespace {

pictures::HistogramBars bars(const ColorHistogram& mean, const ColorHistogram* variance = nullptr) {
  pictures::HistogramBars result;
  for (std::size_t bin = 0; bin < mean.size(); ++bin) {
    result.share[bin] = mean[bin];
    if (variance != nullptr) result.deviation[bin] = std::sqrt((*variance)[bin]);
  }
  return result;
}

pictures::WallTile wall_tile(const Wall& wall, int tile) {
  const double from = wall.column_of(tile) * wall.column_width();
  return {from, from + wall.column_width(), wall.row_of(tile), {}};
}

void add_room(const RoomAwareness& room, const ConfidenceParameters& confidence, pictures::WorldView& view) {
  const Wall& wall = room.wall();
  view.wall_radius = wall.radius();
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    pictures::WallTile drawn = wall_tile(wall, tile);
    const TileModel& model = room.model()[tile];
    if (model.visits > 0) drawn.histogram = bars(model.mean, &model.variance);
    (model.visits > 0 ? view.model : view.untrained).push_back(drawn);
  }
  for (const PerceivedTile& perceived : room.perceived()) {
    if (!perceived.counts) continue;
    pictures::WallTile drawn = wall_tile(wall, perceived.tile);
    drawn.histogram = bars(perceived.histogram);
    view.perceived.push_back(drawn);
  }
  for (const ViewParticle& particle : room.particles()) view.view_particles.push_back(particle.azimuth);
  for (const ViewCluster& cluster : room.clusters()) {
    if (cluster.share >= 0.1) view.view_clusters.push_back({cluster.azimuth, cluster.spread});
  }
  view.view_azimuth = room.center_of_view();
  view.view_half_width = confidence.half_width;
  view.goal_area_half_width = confidence.goal_half_width;
}

/// The belief before the frame's reorientation, if it had one: what the room was looked at with.
Pose2 belief_when_looking(const FrameLoop& frame) {
  return frame.rearrangement() ? frame.rearrangement()->belief_before.pose : frame.world().pose.pose;
}

pictures::Picture draw_world(const FrameLoop& frame) {
  const World& world = frame.world();
  pictures::WorldView view;
  view.field = world.field;
  view.time = world.time;
  if (frame.rearrangement()) {
    view.note = "before the command " + std::string(to_string(frame.rearrangement()->command));
    view.pose_particles = frame.rearrangement()->particles_before;
  } else {
    frame.pose_filter().append_poses(view.pose_particles);
  }
  if (world.truth) view.truth = world.truth->pose;
  view.belief = belief_when_looking(frame);
  if (frame.room() != nullptr) add_room(*frame.room(), frame.room()->parameters().confidence, view);
  return draw_world_view(view);
}

/// Points of the field seen through the camera; pieces behind it or far outside of the image are left out.
class Projection {
 public:
  Projection(const FrameLoop& frame, const Pose2& belief)
      : camera_(frame.observation().camera),
        camera_from_field_((to_isometry(belief) * frame.robot_from_camera()).inverse()),
        field_from_camera_(camera_from_field_.inverse()) {}

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
      if (projected && !running) polylines.emplace_back();
      if (projected) polylines.back().push_back(*projected);
      running = projected.has_value();
    }
  }

  const Eigen::Isometry3d& field_from_camera() const { return field_from_camera_; }

 private:
  CameraModel camera_;
  Eigen::Isometry3d camera_from_field_;
  Eigen::Isometry3d field_from_camera_;
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

std::vector<Eigen::Vector3d> sampled_circle(double radius) {
  constexpr int kPieces = 72;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = 2.0 * kPi * i / kPieces;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return points;
}

void add_room(const RoomAwareness& room, const Projection& projection, pictures::CameraView& view) {
  const Wall& wall = room.wall();
  for (const PerceivedTile& perceived : room.perceived()) {
    pictures::ImageTile tile;
    tile.counted = perceived.counts;
    tile.perceived = bars(perceived.histogram);
    for (const Eigen::Vector3d& corner : wall.corners(perceived.tile)) {
      if (const auto pixel = projection.pixel(corner)) tile.corners.push_back(*pixel);
    }
    if (tile.corners.size() == 4) view.tiles.push_back(std::move(tile));
  }
  // A particle has no height of its own: it is drawn where its azimuth crosses the middle row of the camera.
  const Eigen::Vector3d eye = projection.field_from_camera().translation();
  const Eigen::Vector3d axis = projection.field_from_camera().linear().col(0);
  for (const ViewParticle& particle : room.particles()) {
    const Eigen::Vector2d foot(wall.radius() * std::cos(particle.azimuth), wall.radius() * std::sin(particle.azimuth));
    const double reach = axis.head<2>().norm() > 1e-6 ? (foot - eye.head<2>()).norm() / axis.head<2>().norm() : 0.0;
    if (const auto pixel = projection.pixel({foot.x(), foot.y(), eye.z() + reach * axis.z()})) {
      view.view_particles.push_back(*pixel);
    }
  }
}

void add_percept(const FieldPercept& percept, const FrameLoop& frame, pictures::CameraView& view) {
  const CameraModel& camera = frame.observation().camera;
  const Eigen::Isometry3d camera_from_robot = frame.robot_from_camera().inverse();
  for (const LinePoint& point : percept.line_points) {
    constexpr double kStep = 0.05;  // m across the line
    const Eigen::Vector2d beside =
        point.position + kStep * Eigen::Vector2d(std::cos(point.normal), std::sin(point.normal));
    const auto pixel = camera.project(camera_from_robot * Eigen::Vector3d(beside.x(), beside.y(), 0.0));
    const Eigen::Vector2d place = point.pixel.cast<double>();
    view.line_points.push_back({place, pixel ? Eigen::Vector2d(*pixel - place) : Eigen::Vector2d::Zero()});
  }
  for (const GoalPost& post : percept.goal_posts) {
    view.goal_posts.push_back({post.base.cast<double>(), post.top.cast<double>()});
  }
  for (const Obstacle& obstacle : percept.obstacles) {
    view.obstacles.push_back({static_cast<double>(obstacle.left), static_cast<double>(obstacle.top),
                              static_cast<double>(obstacle.right), static_cast<double>(obstacle.bottom)});
  }
  const double columns = static_cast<double>(percept.boundary.size());
  for (std::size_t i = 0; i < percept.boundary.size(); ++i) {
    view.boundary.emplace_back((static_cast<double>(i) + 0.5) * camera.width / columns, percept.boundary[i]);
  }
}

pictures::Picture draw_camera(const FrameLoop& frame) {
  pictures::CameraView view;
  view.image = frame.observation().image;
  view.time = frame.world().time;
  const Projection projection(frame, belief_when_looking(frame));
  for (const FieldLine& line : field_lines(frame.world().field)) {
    projection.add_polyline(sampled(line), view.projected_lines);
  }
  projection.add_polyline(sampled_circle(frame.world().field.center_circle_radius), view.projected_lines);
  add_percept(frame.percept(), frame, view);
  if (frame.room() != nullptr) add_room(*frame.room(), projection, view);
  return draw_camera_view(view);
}

template <typename Holds>
void add_intervals(const std::vector<FrameSample>& samples, pictures::Condition condition, Holds holds,
                   std::vector<pictures::ConditionInterval>& intervals) {
  bool running = false;
  for (const FrameSample& sample : samples) {
    const bool now = holds(sample);
    if (now && !running) intervals.push_back({condition, sample.time, sample.time});
    if (now) intervals.back().to = sample.time;
    running = now;
  }
}

std::string short_name(Command command) {
  const std::string name(to_string(command));
  return name.substr(0, name.find('_'));
}

pictures::Picture draw_confidences(const RunHistory& history) {
  using pictures::Condition;
  pictures::ConfidencePlot plot;
  for (const FrameSample& sample : history.samples()) {
    const Confidences& c = sample.confidence;
    plot.samples.push_back({sample.time, c.current, c.opposite, c.raw_current, c.raw_opposite});
  }
  for (const CommandRecord& record : history.commands()) {
    const Command command = record.request.command;
    if (command == Command::pause_training || command == Command::pause_evaluation) continue;
    plot.commands.push_back({record.time, short_name(command), record.verdict == Verdict::granted});
  }
  const auto add = [&](Condition condition, auto holds) {
    add_intervals(history.samples(), condition, holds, plot.conditions);
  };
  add(Condition::training, [](const FrameSample& s) { return s.training; });
  add(Condition::evaluation_paused, [](const FrameSample& s) { return !s.evaluating; });
  add(Condition::belief_reflected,
      [](const FrameSample& s) { return s.truth && is_correct(reflect(s.belief.pose), s.truth->pose); });
  add(Condition::carried, [](const FrameSample& s) { return s.carried; });
  add(Condition::fallen, [](const FrameSample& s) { return s.fallen; });
  return draw_confidence_plot(plot);
}

pictures::Picture draw_reorientations(const FieldDimensions& field, const RunHistory& history) {
  std::vector<pictures::Reorientation> drawn;
  for (const Rearrangement& rearrangement : history.rearrangements()) {
    const std::optional<Pose2> truth =
        rearrangement.truth ? std::optional<Pose2>(rearrangement.truth->pose) : std::nullopt;
    drawn.push_back({short_name(rearrangement.command),
                     rearrangement.time,
                     {rearrangement.particles_before, truth, rearrangement.belief_before.pose},
                     {rearrangement.particles_after, truth, rearrangement.belief_after.pose}});
  }
  return draw_reorientation_view(field, drawn);
}

}  // namespace

void RunPictures::look(const FrameLoop& frame) {
  if (world_ || !frame.rearrangement()) return;
  world_ = draw_world(frame);
  camera_ = draw_camera(frame);
}

void RunPictures::write(const FrameLoop& frame, const RunHistory& history, const std::filesystem::path& folder) const {
  write_png(folder / "world_view.png", world_ ? *world_ : draw_world(frame));
  write_png(folder / "camera_view.png", camera_ ? *camera_ : draw_camera(frame));
  write_png(folder / "confidences.png", draw_confidences(history));
  write_png(folder / "reorientations.png", draw_reorientations(frame.world().field, history));
}

}  // namespace reorient
