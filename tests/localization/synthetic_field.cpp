// SPDX-License-Identifier: MIT
#include "tests/localization/synthetic_field.h"

#include <algorithm>
#include <cmath>

#include "geometry/field_landmarks.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

constexpr double kFrame = 1.0 / 30.0;             // s
constexpr double kHalfView = 28.0 * kPi / 180.0;  // rad
constexpr double kCameraHeight = 0.5;             // m
constexpr double kSwayFrequency = 1.7;            // Hz
constexpr std::size_t kMostLinePoints = 60;

/// The measured position of a point on the ground if the camera has an additional, unknown `tilt`.
Eigen::Vector2d misjudge(const Eigen::Vector2d& point, double tilt) {
  const double distance = point.norm();
  const double below_horizon = std::max(std::atan2(kCameraHeight, distance) + tilt, 0.02);
  return point * (kCameraHeight / std::tan(below_horizon) / distance);
}

bool in_view(const Eigen::Vector2d& point, double head_yaw, double nearest, double farthest) {
  const double distance = point.norm();
  const Eigen::Vector2d axis(std::cos(head_yaw), std::sin(head_yaw));
  return distance > nearest && distance < farthest && point.dot(axis) > distance * std::cos(kHalfView);
}

}  // namespace

SyntheticField::SyntheticField(const FieldDimensions& field, const PerceptErrors& errors, std::uint64_t seed)
    : field_(field), errors_(errors), random_(seed, 1) {
  constexpr double kSpacing = 0.08;
  for (const FieldLine& line : field_lines(field)) {
    const Eigen::Vector2d along = line.to - line.from;
    const int count = static_cast<int>(along.norm() / kSpacing);
    for (int i = 0; i <= count; ++i) {
      drawn_.push_back({line.from + along * i / count, std::atan2(along.x(), -along.y())});
    }
  }
  for (double angle = 0.0; angle < 2.0 * kPi; angle += kSpacing / field.center_circle_radius) {
    drawn_.push_back({field.center_circle_radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)), angle});
  }
}

FieldPercept SyntheticField::look(const Pose2& truth, double head_yaw, double time) {
  const Pose2 robot_from_field = truth.inverse();
  const double tilt = errors_.sway * std::sin(2.0 * kPi * kSwayFrequency * time);
  FieldPercept percept;
  for (const DrawnPoint& drawn : drawn_) {
    const Eigen::Vector2d point = robot_from_field * drawn.position;
    if (!in_view(point, head_yaw, 0.6, 4.0)) continue;
    const Eigen::Vector2d seen = misjudge(point, tilt) * (1.0 + errors_.distance * random_.normal());
    const double turn = errors_.bearing * random_.normal();
    percept.line_points.push_back(
        line_point(Eigen::Rotation2Dd(turn) * seen,
                   std::remainder(drawn.normal - truth.rotation + errors_.normal * random_.normal(), kPi)));
  }
  for (std::size_t i = percept.line_points.size(); i > 1; --i) {
    std::swap(percept.line_points[i - 1], percept.line_points[random_.below(i)]);
  }
  if (percept.line_points.size() > kMostLinePoints) percept.line_points.resize(kMostLinePoints);
  for (LinePoint& point : percept.line_points) {
    if (random_.uniform() >= errors_.false_points) continue;
    const double bearing = head_yaw + random_.uniform(-kHalfView, kHalfView);
    point.position = random_.uniform(0.6, 4.0) * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    point.normal = random_.uniform(-kPi / 2.0, kPi / 2.0);
  }
  for (const Eigen::Vector2d& post : goal_posts(field_)) {
    const Eigen::Vector2d point = robot_from_field * post;
    if (!in_view(point, head_yaw, 0.6, 8.0) || random_.uniform() < errors_.missed_posts) continue;
    const Eigen::Vector2d seen = misjudge(point, tilt) * (1.0 + errors_.distance * random_.normal());
    percept.goal_posts.push_back(
        goal_post(Eigen::Rotation2Dd(errors_.bearing * random_.normal()) * seen, seen.norm() > 1.0));
  }
  return percept;
}

double azimuth_from(const Pose2& robot, double yaw, double radius) {
  const Eigen::Vector2d ahead = unit_vector(robot.rotation + yaw);
  const double along = ahead.dot(robot.position);
  const double to_wall = -along + std::sqrt(along * along + radius * radius - robot.position.squaredNorm());
  return direction_of(robot.position + to_wall * ahead);
}

SyntheticRobot::SyntheticRobot(PoseFilter& filter, const Pose2& where, std::uint64_t seed, const PerceptErrors& errors)
    : truth(where), filter_(filter), field_(FieldDimensions(), errors, seed), random_(seed, 2) {}

void SyntheticRobot::stand_for(double seconds, SeenGoal seen_goal) {
  for (const double end = time + seconds; time < end;) stand(seen_goal);
}

void SyntheticRobot::walk(SeenGoal seen_goal) {
  const Eigen::Vector2d to_target = truth.inverse() * target_;
  if (to_target.norm() < 0.3) target_ = -target_;
  const double turn = std::atan2(to_target.y(), to_target.x());
  const double forward = std::abs(turn) < 0.4 ? 0.2 : 0.0;  // m/s
  step({forward * kFrame, 0.0, std::clamp(turn, -0.6, 0.6) * kFrame}, seen_goal);
}

void SyntheticRobot::step(const Pose2& motion, SeenGoal seen_goal) {
  truth = truth * motion;
  time += kFrame;
  // Odometry: distances 8 % too long, rotations 7 % too small, a drift of 2 degrees per meter, and jitter.
  const double distance = motion.position.norm();
  const Eigen::Vector2d jitter(0.1 * distance * random_.normal(), 0.1 * distance * random_.normal());
  filter_.predict({1.08 * motion.position + jitter, 0.93 * motion.rotation + 0.035 * distance}, kFrame);
  const double yaw = scanning_yaw(time);
  std::optional<SeenView> view;
  if (wall_radius)
    view = {
        .azimuth = azimuth_from(truth, yaw, *wall_radius), .deviation = 0.2, .radius = *wall_radius, .direction = yaw};
  filter_.update(field_.look(truth, yaw, time), seen_goal, view);
}

double SyntheticRobot::rotation_error() const {
  return std::abs(angle_difference(filter_.belief().pose.rotation, truth.rotation));
}

bool SyntheticRobot::believes(const Pose2& pose, double meters, double radians) const {
  const Pose2& belief = filter_.belief().pose;
  return (belief.position - pose.position).norm() < meters &&
         std::abs(angle_difference(belief.rotation, pose.rotation)) < radians;
}

}  // namespace reorient
