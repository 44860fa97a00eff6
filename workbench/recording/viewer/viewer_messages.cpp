#include "workbench/recording/viewer/viewer_messages.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/script/language/world_fields.h"
#include "geometry/field_landmarks.h"
#include "workbench/recording/viewer/foxglove.h"
#include "workbench/run/log_lines.h"
#include "workbench/run/timeline.h"

namespace reorient {
namespace {

using foxglove::Color;
using foxglove::Entity;
using foxglove::Json;

constexpr std::string_view kField = "field", kRobot = "robot", kTruth = "truth";
constexpr std::array<std::string_view, 2> kCameras{"camera_upper", "camera_lower"};

constexpr Color kWhite{1.0, 1.0, 1.0, 1.0}, kYellow{1.0, 0.84, 0.04, 1.0}, kLinePoint{1.0, 0.2, 0.6, 1.0},
    kPost{1.0, 0.84, 0.04, 1.0}, kObstacle{0.9, 0.1, 0.1, 0.8}, kLandmark{0.1, 0.9, 0.9, 1.0},
    kBall{1.0, 0.45, 0.0, 1.0}, kBorder{0.2, 0.8, 1.0, 1.0}, kView{1.0, 0.55, 0.0, 1.0}, kUnknown{0.5, 0.5, 0.5, 0.15},
    kCarpet{0.11, 0.43, 0.2, 1.0};

Eigen::Vector3d on_ground(const Eigen::Vector2d& point, double height = 0.0) { return {point.x(), point.y(), height}; }

std::vector<Eigen::Vector3d> arc(const Eigen::Vector2d& center, double radius, double from, double to) {
  constexpr int kSteps = 48;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= kSteps; ++i)
    points.push_back(on_ground(center + radius * unit_vector(from + (to - from) * i / kSteps)));
  return points;
}

Json field_scene(double time, const FieldDimensions& field) {
  Entity scene(time, kField, "field");
  const double x = 0.5 * field.length, y = 0.5 * field.width, width = field.line_width;
  const auto carpet = [](double half_length, double half_width) {
    constexpr double kBelow = -0.01;  // m, so that the lines are in sight
    return Entity::Quad{{{-half_length, -half_width, kBelow},
                         {half_length, -half_width, kBelow},
                         {half_length, half_width, kBelow},
                         {-half_length, half_width, kBelow}}};
  };
  const Entity::Quad all = carpet(x + field.border, y + field.border);
  scene.quads({&all, 1}, {&kCarpet, 1});
  std::vector<Eigen::Vector3d> ends;
  for (const FieldLine& line : field_lines(field)) {
    ends.push_back(on_ground(line.from));
    ends.push_back(on_ground(line.to));
  }
  const double mark = 0.5 * field.penalty_mark_size;
  for (const double spot : {-field.penalty_mark_x, field.penalty_mark_x}) {
    for (const Eigen::Vector2d& half : {Eigen::Vector2d(mark, 0.0), Eigen::Vector2d(0.0, mark)}) {
      ends.push_back(on_ground(Eigen::Vector2d(spot, 0.0) - half));
      ends.push_back(on_ground(Eigen::Vector2d(spot, 0.0) + half));
    }
  }
  scene.segments(ends, width, kWhite);
  scene.lines(arc({0.0, 0.0}, field.center_circle_radius, 0.0, 2.0 * kPi), false, width, kWhite);
  const Color color = field.yellow_goals ? kYellow : kWhite;
  for (const Eigen::Vector2d& post : goal_posts(field))
    scene.cylinder(on_ground(post), field.goal_height, field.goal_post_diameter, color);
  for (const double side : {-1.0, 1.0}) {
    const double goal = side * x;
    for (const double end : {-1.0, 1.0}) {
      if (field.corner_arc_radius <= 0.0) continue;
      const double inwards = direction_of({-side, -end});
      scene.lines(arc({goal, end * y}, field.corner_arc_radius, inwards - 0.25 * kPi, inwards + 0.25 * kPi), false,
                  width, kWhite);
    }
    scene.lines({{goal, -field.goal_post_y, field.goal_height}, {goal, field.goal_post_y, field.goal_height}}, false,
                field.goal_post_diameter, color);
    scene.text({goal + side * field.border, 0.0, field.goal_height + 0.3}, side > 0.0 ? "opponent" : "own", 0.3, color);
  }
  return std::move(scene).update();
}

/// ITU-R BT.601, as cameras' YCbCr is.
Color color_of(double luma, double cb, double cr) {
  const auto share = [](double level) { return std::clamp(level / 255.0, 0.0, 1.0); };
  return {share(luma + 1.402 * (cr - 128.0)), share(luma - 0.344 * (cb - 128.0) - 0.714 * (cr - 128.0)),
          share(luma + 1.772 * (cb - 128.0)), 0.9};
}

Json wall_scene(double time, const RoomRecord& room) {
  Entity scene(time, kField, "wall");
  const Wall wall(room.basis.wall);
  std::vector<Entity::Quad> quads;
  std::vector<Color> colors;
  const Light shown;  // a room as bright as this
  for (int tile = 0; tile < wall.tiles() && tile < static_cast<int>(room.model.size()); ++tile) {
    const TileModel& model = room.model[static_cast<std::size_t>(tile)];
    quads.push_back(wall.corners(tile));
    colors.push_back(model.light_visits > 0
                         ? color_of(shown.luma * model.light.luma, shown.cb + model.light.cb, shown.cr + model.light.cr)
                         : kUnknown);
  }
  scene.quads(quads, colors);
  // How much of the belief of the view lies where.
  constexpr double kTallest = 2.0;  // m
  std::vector<std::pair<double, double>> shares;
  for (const ViewCell& cell : room.cells) shares.emplace_back(cell.azimuth, cell.share);
  for (const ViewParticle& particle : room.particles) shares.emplace_back(particle.azimuth, 1.0);
  double most = 0.0;
  for (const auto& [azimuth, share] : shares) most = std::max(most, share);
  std::vector<Eigen::Vector3d> rods;
  for (const auto& [azimuth, share] : shares) {
    if (share < 0.01 * most) continue;
    const Eigen::Vector2d foot = 0.95 * wall.radius() * unit_vector(azimuth);
    rods.push_back(on_ground(foot));
    rods.push_back(on_ground(foot, kTallest * share / most));
  }
  scene.segments(rods, 0.06, kView);
  return std::move(scene).update();
}

Json percepts_scene(double time, const std::array<FieldPercept, 2>& percepts) {
  Entity scene(time, kRobot, "percepts");
  std::vector<Eigen::Vector3d> across;
  constexpr double kHalf = 0.06;                        // m of each dash across a line
  constexpr double kAboveGround = 0.1, kLetter = 0.15;  // m
  for (const FieldPercept& percept : percepts) {
    for (const LinePoint& point : percept.line_points) {
      const Eigen::Vector2d dash = kHalf * unit_vector(point.normal);
      across.push_back(on_ground(point.position - dash));
      across.push_back(on_ground(point.position + dash));
    }
    for (const GoalPost& post : percept.goal_posts) {
      Color color = kPost;
      if (!post.base_visible) color.a = 0.4;
      scene.cylinder(on_ground(post.position), 0.8, 0.1, color);
    }
    for (const Obstacle& obstacle : percept.obstacles)
      scene.cylinder(on_ground(obstacle.position), 0.3, 0.3, kObstacle);
    for (const Intersection& one : percept.intersections)
      scene.text(on_ground(one.position, kAboveGround), name_of(one.kind), kLetter, kLandmark);
    for (const PenaltyMark& mark : percept.penalty_marks)
      scene.cylinder(on_ground(mark.position), 0.02, 0.15, kLandmark);
    if (percept.center_circle) scene.cylinder(on_ground(percept.center_circle->center), 0.02, 0.3, kLandmark);
    if (percept.ball) scene.cylinder(on_ground(percept.ball->position), 0.1, 0.1, kBall);
  }
  scene.segments(across, 0.02, kLinePoint);
  return std::move(scene).update();
}

Json annotations(double time, const CameraRecord& camera, const FieldPercept& percept) {
  foxglove::Annotations drawn(time);
  std::vector<Eigen::Vector2d> pixels;
  for (const LinePoint& point : percept.line_points) pixels.emplace_back(point.pixel.cast<double>());
  const double size = std::max(1.0, camera.width / 160.0);
  drawn.points(pixels, size, kLinePoint);
  for (const GoalPost& post : percept.goal_posts)
    drawn.line({post.base.cast<double>(), post.top.cast<double>()}, false, 2.0 * size, kPost);
  for (const Obstacle& it : percept.obstacles) {
    drawn.line({{it.left, it.top}, {it.right, it.top}, {it.right, it.bottom}, {it.left, it.bottom}}, true, size,
               kObstacle);
  }
  std::vector<Eigen::Vector2d> landmarks;
  for (const Intersection& one : percept.intersections) landmarks.emplace_back(one.pixel.cast<double>());
  for (const PenaltyMark& mark : percept.penalty_marks) landmarks.emplace_back(mark.pixel.cast<double>());
  drawn.points(landmarks, 3.0 * size, kLandmark);
  if (percept.ball) {
    constexpr int kCorners = 16;
    std::vector<Eigen::Vector2d> outline(kCorners);
    for (int i = 0; i < kCorners; ++i) {
      outline[static_cast<std::size_t>(i)] =
          percept.ball->pixel.cast<double>() +
          static_cast<double>(percept.ball->radius) * unit_vector(2.0 * kPi * i / kCorners);
    }
    drawn.line(outline, true, size, kBall);
  }
  std::vector<Eigen::Vector2d> border;
  const auto columns = static_cast<double>(percept.boundary.size());
  for (std::size_t i = 0; i < percept.boundary.size(); ++i) {
    if (percept.boundary[i] < static_cast<float>(camera.height))
      border.emplace_back((static_cast<double>(i) + 0.5) * camera.width / columns, percept.boundary[i]);
  }
  drawn.line(border, false, size, kBorder);
  return std::move(drawn).json();
}

Json world_json(const World& world) {
  std::vector<double> values;
  append_world(world, values);
  Json json = Json::object();
  const std::span<const WorldField> all = world_fields();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const WorldField& field = all[i];
    if (!std::isfinite(values[i])) continue;
    Json& value = json[std::string(field.table)][std::string(field.name)];
    const auto index = static_cast<std::size_t>(values[i]);
    if (field.type == WorldField::Type::boolean) {
      value = values[i] != 0.0;
    } else if (field.type == WorldField::Type::name) {
      value = index < field.names.size() ? field.names[index] : std::string();
    } else {
      value = values[i];
    }
  }
  return json;
}

Json machines_json(const FrameRecord& frame) {
  Json machines = Json::array(), published = Json::array();
  for (const MachineStatus& machine : frame.machines) {
    machines.push_back({{"name", frame.name(machine.machine)},
                        {"state", frame.name(machine.state)},
                        {"seconds", frame.world.time - machine.entered_at},
                        {"stopped", machine.stopped},
                        {"errors", machine.errors}});
  }
  for (const NameId flag : frame.published) published.push_back(frame.name(flag));
  return {{"machines", std::move(machines)}, {"published", std::move(published)}};
}

Json event_json(const TimelineEvent& event) {
  return {{"machine", event.machine},
          {"state", event.state},
          {"command", event.command},
          {"verdict", event.verdict},
          {"reason", event.reason}};
}

Json request_json(const FrameRecord& frame) {
  const Request& request = frame.answer.request;
  Json head = Json::object();
  if (request.head) {
    head = {{"yaw", request.head->angles.yaw}, {"pitch", request.head->angles.pitch}, {"speed", request.head->speed}};
  }
  return {{"walk", {{"forward", request.walk.forward}, {"left", request.walk.left}, {"turn", request.walk.turn}}},
          {"head", std::move(head)},
          {"get_up", request.get_up},
          {"command", frame.reorientation ? to_string(frame.reorientation->reorientation) : std::string_view()}};
}

Json costs_json(const FrameRecord& extra, const StageRecord& stage) {
  Json stages = Json::object(), machines = Json::array();
  for (int i = 0; i < kStageCount; ++i) {
    stages[std::string(to_string(static_cast<Stage>(i)))] = 1e3 * extra.costs.seconds[static_cast<std::size_t>(i)];
  }
  for (const MachineCost& machine : extra.costs.machines) {
    machines.push_back({{"name", extra.name(machine.machine)},
                        {"microseconds", machine.microseconds},
                        {"instructions", machine.instructions},
                        {"memory", machine.memory}});
  }
  return {{"milliseconds", std::move(stages)},
          {"frame_milliseconds", 1e3 * stage.stepping},
          {"machines", std::move(machines)}};
}

Json parameters_json(const std::vector<Parameter>& parameters) {
  Json all = Json::array();
  for (const Parameter& parameter : parameters)
    all.push_back({{"name", parameter.name}, {"value", to_text(parameter.value)}, {"unit", parameter.unit}});
  return {{"parameters", std::move(all)}};
}

Json transforms_json(const FrameRecord& frame, const StageRecord& stage) {
  const double time = frame.world.time;
  Json all = Json::array();
  all.push_back(foxglove::transform(time, kField, kRobot, foxglove::on_the_ground(frame.world.pose.pose)));
  const std::optional<CameraRecord>* const cameras[] = {&frame.inputs.upper, &frame.inputs.lower};
  for (std::size_t i = 0; i < kCameras.size(); ++i) {
    if (const std::optional<CameraRecord>& camera = *cameras[i]) {
      all.push_back(
          foxglove::transform(time, kRobot, kCameras[i], camera->robot_from_camera * foxglove::camera_from_optical()));
    }
  }
  if (stage.truth) all.push_back(foxglove::transform(time, kField, kTruth, foxglove::on_the_ground(stage.truth->pose)));
  return {{"transforms", std::move(all)}};
}

Json log_json(double time, const LogLine& line) {
  using foxglove::Level;
  const Level level = line.level == LogLine::Level::info      ? Level::info
                      : line.level == LogLine::Level::warning ? Level::warning
                                                              : Level::error;
  const std::string& name = line.source.empty() ? line.file : line.source;
  return foxglove::log(time, level, name.empty() ? "note" : name, line.text, line.file, line.line);
}

Json log_json(double time, const ParameterOutcome& change) {
  const bool taken = change.refusal.empty();
  return foxglove::log(time, taken ? foxglove::Level::info : foxglove::Level::warning, "parameters",
                       change.name + " = " + change.value + (taken ? "" : ": " + change.refusal));
}

}  // namespace

void ViewerMessages::add(const ViewedFrame& viewed, const Sink& sink) {
  const FrameRecord& frame = viewed.frame;
  const StageRecord& stage = viewed.stage;
  const double time = frame.world.time;
  const auto send = [&](ViewerTopic topic, const Json& message) {
    // Scripts may log what is no UTF-8.
    sink(topic, message.dump(-1, ' ', false, Json::error_handler_t::replace));
  };

  if (viewed.begins) send(ViewerTopic::field, field_scene(time, frame.world.field));
  if (viewed.extra.filled.has(Topic::room) && !viewed.extra.room.model.empty())
    send(ViewerTopic::wall, wall_scene(time, viewed.extra.room));
  if (viewed.extra.filled.has(Topic::parameters))
    send(ViewerTopic::parameters, parameters_json(viewed.extra.parameters));
  if (viewed.extra.filled.has(Topic::pose_particles)) {
    send(ViewerTopic::pose_particles, foxglove::poses_in_frame(time, kField, viewed.extra.pose_particles.particles));
  }
  if (viewed.extra.filled.has(Topic::costs)) send(ViewerTopic::costs, costs_json(viewed.extra, stage));

  send(ViewerTopic::transforms, transforms_json(frame, stage));
  send(ViewerTopic::pose, foxglove::pose_in_frame(time, kField, frame.world.pose.pose));
  if (stage.truth) send(ViewerTopic::truth, foxglove::pose_in_frame(time, kField, stage.truth->pose));
  send(ViewerTopic::percepts, percepts_scene(time, frame.percepts));
  send(ViewerTopic::world, world_json(frame.world));
  send(ViewerTopic::machines, machines_json(frame));
  send(ViewerTopic::request, request_json(frame));
  for (const TimelineEvent& event : timeline_events(frame, stage)) send(ViewerTopic::events, event_json(event));
  for (const ParameterOutcome& change : frame.parameter_changes) send(ViewerTopic::log, log_json(time, change));
  for (const LogLine& line : log_lines(frame, stage)) send(ViewerTopic::log, log_json(time, line));

  struct CameraTopics {
    const std::optional<CameraRecord>& camera;
    ViewerTopic image, calibration, annotations;
  };
  const CameraTopics cameras[] = {
      {frame.inputs.upper, ViewerTopic::upper_image, ViewerTopic::upper_calibration, ViewerTopic::upper_annotations},
      {frame.inputs.lower, ViewerTopic::lower_image, ViewerTopic::lower_calibration, ViewerTopic::lower_annotations}};
  for (std::size_t i = 0; i < kCameras.size(); ++i) {
    if (!cameras[i].camera) continue;
    const CameraRecord& camera = *cameras[i].camera;
    if (viewed.begins) {
      send(cameras[i].calibration, foxglove::camera_calibration(camera.time, kCameras[i], camera.camera));
    }
    if (viewed.images[i].empty()) continue;
    send(cameras[i].image, foxglove::compressed_image(camera.time, kCameras[i], encoder_.encode(viewed.images[i])));
    send(cameras[i].annotations, annotations(camera.time, camera, frame.percepts[i]));
  }
}

}  // namespace reorient
