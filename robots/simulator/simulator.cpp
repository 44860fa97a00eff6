#include "robots/simulator/simulator.h"

#include <cmath>
#include <utility>

namespace reorient {
namespace {

CameraModel camera_of(const SimulatorParameters& parameters) {
  constexpr int kWidth[] = {640, 320, 160};
  constexpr int kHeight[] = {480, 240, 120};
  const auto size = static_cast<std::size_t>(parameters.image);
  CameraModel camera = CameraModel::from_fields_of_view(
      kWidth[size], kHeight[size], parameters.field_of_view_horizontal, parameters.field_of_view_vertical);
  camera.k1 = parameters.distortion_k1;
  camera.k2 = parameters.distortion_k2;
  return camera;
}

RobotDimensions with_tilt_error(RobotDimensions dimensions, double deviation, std::uint64_t seed) {
  constexpr std::uint64_t kStream = 0x7117;
  dimensions.camera_tilt += deviation * Random(seed, kStream).normal();
  return dimensions;
}

Eigen::Vector2d bounds_of(const Room& room) {
  constexpr double kFromWall = 0.4;  // m
  const Eigen::Vector2d half = 0.5 * floor_extent(room.shape);
  if (room.shape.form == RoomForm::box) return half - Eigen::Vector2d::Constant(kFromWall);
  // The corners of a square inside of the round wall.
  return Eigen::Vector2d::Constant((half.x() - kFromWall) * std::sqrt(0.5));
}

/// Posts and nets of both goals.
std::vector<Barrier> barriers_of(const FieldDimensions& field) {
  constexpr double kNet = 0.02;  // m
  std::vector<Barrier> barriers;
  for (const double end : {1.0, -1.0}) {
    const double front = 0.5 * end * field.length;
    const double back = front + end * field.goal_depth;
    const double half = field.goal_post_y;
    for (const double side : {half, -half}) {
      barriers.push_back({{front, side}, {front, side}, 0.5 * field.goal_post_diameter});
      barriers.push_back({{front, side}, {back, side}, kNet});
    }
    barriers.push_back({{back, -half}, {back, half}, kNet});
  }
  return barriers;
}

Ball somewhere_on(const FieldDimensions& field, std::uint64_t seed) {
  constexpr std::uint64_t kStream = 0xba11;
  Random random(seed, kStream);
  Ball ball;
  ball.position = {random.uniform(-0.35, 0.35) * field.length, random.uniform(-0.35, 0.35) * field.width};
  return ball;
}

}  // namespace

Simulator::Simulator(const SimulatorParameters& parameters, const FieldDimensions& field, const Room& room,
                     const Pose2& start, std::uint64_t seed)
    : parameters_(parameters),
      field_(field),
      light_(room.light),
      bounds_(bounds_of(room)),
      goals_(barriers_of(field)),
      true_dimensions_(with_tilt_error(dimensions_, parameters.tilt_error, seed)),
      camera_(camera_of(parameters)),
      body_(parameters.body, true_dimensions_, start, seed),
      players_(parameters.other_robots, field, start.position, seed),
      ball_(somewhere_on(field, seed)),
      spectators_(parameters.spectators, room.shape, field, room.light, seed),
      renderer_(camera_, field, room, parameters.labels),
      sensor_(parameters.sensor, renderer_.rays(), seed),
      image_(camera_.width, camera_.height) {
  add_goals(scene_, field_, light_);
  standing_capsules_ = scene_.capsules.size();
  standing_shadows_ = scene_.shadows.size();
}

bool Simulator::observe(Observation& observation) {
  move();
  look(observation);
  ++frame_;
  return true;
}

void Simulator::move() {
  const double time_step = 1.0 / parameters_.frame_rate;
  players_.advance(time_step, body_.pose().position, goals_);
  barriers_.assign(goals_.begin(), goals_.end());
  for (const Player& player : players_.all()) {
    barriers_.push_back({player.pose.position, player.pose.position, Players::kRadius});
  }
  body_.advance(time_step, request_, barriers_, bounds_);
  if (!parameters_.ball) return;
  if (body_.posture() == Body::Posture::upright) ball_.touch(body_.pose().position);
  for (const Player& player : players_.all()) ball_.touch(player.pose.position);
  ball_.advance(time_step, {0.5 * field_.length + field_.border, 0.5 * field_.width + field_.border});
}

void Simulator::look(Observation& observation) {
  observation = {};
  observation.time = static_cast<double>(frame_) / parameters_.frame_rate;
  if (frame_ == 0) observation.robot = RobotBody{};
  observation.told.referee = std::exchange(whistle_, std::nullopt);
  body_.measure(observation);

  scene_.capsules.resize(standing_capsules_);
  scene_.shadows.resize(standing_shadows_);
  static const LinearColor kJerseys[] = {{0.03f, 0.07f, 0.42f}, {0.55f, 0.02f, 0.03f}};
  for (const Player& player : players_.all()) {
    add_robot(scene_, player.pose, player.stride, kJerseys[player.team], light_);
  }
  if (parameters_.ball) add_ball(scene_, ball_.position, light_);
  spectators_.add_to(scene_, observation.time);

  field_from_camera_ = body_.field_from_camera();
  const Frame& frame = renderer_.render(field_from_camera_, scene_);
  sensor_.expose(frame, frame_, 1.0 / parameters_.frame_rate, image_);
  CameraFrame& upper = observation.upper.emplace();
  upper.time = observation.time;
  upper.image = image_.view();
  upper.camera = camera_;
  upper.odometry = observation.odometry;
  upper.robot_from_camera = body_.measured_camera(dimensions_, observation.body);
}

void Simulator::penalize(bool penalized) {
  body_.penalize(penalized);
  whistle_ = RefereeState{penalized};
}

std::span<const Label> Simulator::labels() const { return renderer_.frame().labels; }

std::span<const float> Simulator::depth() const {
  if (!parameters_.labels) return {};
  return renderer_.frame().depth;
}

}  // namespace reorient
