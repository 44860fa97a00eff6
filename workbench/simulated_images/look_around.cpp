// SPDX-License-Identifier: MIT
#include "workbench/simulated_images/look_around.h"

#include <algorithm>

#include "geometry/field_landmarks.h"
#include "geometry/random.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

constexpr int kLooks = 3;
constexpr int kPutDown = 30;   // frames, until the robot stands
constexpr int kSettle = 12;    // frames until the head has arrived and the exposure has adapted
constexpr int kBetween = 4;    // frames between two images of a rotating head
constexpr double kFast = 8.0;  // rad/s
constexpr double kYaw = 1.0;   // rad to either side

Eigen::Vector2d somewhere(const Eigen::Vector2d& half_size, Random& random) {
  const double x = random.uniform(-half_size.x(), half_size.x());
  return {x, random.uniform(-half_size.y(), half_size.y())};
}

}  // namespace

PerceptScore look_around(Simulator& simulator, FieldFeatures& features, const FieldDimensions& field,
                         const FieldFeatureParameters& parameters, const LookAround& look) {
  constexpr double kBallNear = 0.4, kBallFar = 4.0, kBallAside = 0.7;  // m, m, rad
  Random random(look.seed, 0x6C6F6F6B);                                // "look"
  const Eigen::Vector2d lines = field_half_size(field);
  const Eigen::Vector2d inside = lines - Eigen::Vector2d(0.3, 0.2);
  Observation observation;
  FieldPercept percept;
  PerceptScore score;
  const auto turn_head = [&](double yaw, double pitch, double speed) {
    Answer answer;
    answer.request.head = HeadRequest{{yaw, pitch}, speed};
    simulator.answer(answer);
  };
  const auto see = [&](bool counts) {
    simulator.observe(observation);
    const CameraFrame& frame = observation.upper.value();
    const Isometry3 robot_from_camera =
        to_isometry(simulator.ground_truth().pose).inverse() * simulator.field_from_camera();
    if (!counts) return;
    features.find(frame.image, frame.camera, robot_from_camera, percept);
    score = score + score_of(percept, field_in_view(simulator, frame, field), field, parameters);
  };
  for (int place = 0; place < look.places; ++place) {
    const Eigen::Vector2d where = somewhere(inside, random);
    const Pose2 robot(where.x(), where.y(), random.uniform(-kPi, kPi));
    simulator.change_light();
    simulator.put_down(robot);
    const double direction = robot.rotation + random.uniform(-kBallAside, kBallAside);
    const Eigen::Vector2d ball = where + random.uniform(kBallNear, kBallFar) * unit_vector(direction);
    simulator.put_ball(ball.cwiseMax(-lines).cwiseMin(lines));
    for (int k = 0; k < kPutDown; ++k) see(false);
    const bool left = random.uniform() < 0.5;
    for (int i = 0; i < kLooks; ++i) {
      const double pitch = random.uniform(-0.05, 0.35);
      if (look.gaze > 0.0) {
        if (i == 0) {
          turn_head(left ? kYaw : -kYaw, pitch, kFast);
          for (int k = 0; k < kSettle; ++k) see(false);
          turn_head(left ? -kYaw : kYaw, pitch, look.gaze);
        }
        for (int k = 0; k < kBetween; ++k) see(k + 1 == kBetween);
      } else {
        turn_head(random.uniform(-kYaw, kYaw), pitch, kFast);
        for (int k = 0; k < kSettle; ++k) see(k + 1 == kSettle);
      }
    }
  }
  return score;
}

}  // namespace reorient
