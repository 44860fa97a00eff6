// SPDX-License-Identifier: MIT
// What the engine answers to the robot, once a frame.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/angle.h"
#include "geometry/const_or.h"
#include "geometry/head.h"
#include "geometry/pose2.h"

namespace reorient {

/// Torso velocity: m/s forward and to the left, rad/s to the left.
struct WalkVelocity {
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;
};
template <typename Visit, ConstOr<WalkVelocity> T>
void fields(Visit&& visit, T& walk) {
  visit(walk.forward, walk.left, walk.turn);
}

struct HeadRequest {
  HeadAngles angles;                   ///< wanted joint angles, rad; clamped to what the neck reaches
  double speed = from_degrees(120.0);  ///< rad/s, at most the motors' own limit
};
template <typename Visit, ConstOr<HeadRequest> T>
void fields(Visit&& visit, T& head) {
  visit(head.angles, head.speed);
}

/// What the robot shall do until the next request. Without a head request the head stays where it is.
struct Request {
  std::optional<HeadRequest> head;
  WalkVelocity walk;    ///< zero: stand
  bool get_up = false;  ///< after a fall
};
template <typename Visit, ConstOr<Request> T>
void fields(Visit&& visit, T& request) {
  visit(request.head, request.walk, request.get_up);
}

/// Of a word from one robot to another, bytes.
inline constexpr std::size_t kLongestMessage = 240;

/// What can be done to a belief (the paper's Section 3.1).
enum class Reorientation { flip_pose, purge_reflection, reset_orientation };
constexpr int enum_count(Reorientation) { return 3; }

/// How the room supports the believed pose and its reflection, for whoever holds the belief.
struct RoomConfidence {
  double current = 0.0;   ///< confidence in the believed pose, 0 to 1
  double opposite = 0.0;  ///< confidence in its reflection
  double evidence = 0.0;  ///< log-odds of the reflection against the pose: log(99) where 99 in 100 are reflected
  bool usable = false;    ///< the room can tell at all: it is learned, seen, and not the same after half a turn
};
template <typename Visit, ConstOr<RoomConfidence> T>
void fields(Visit&& visit, T& room) {
  visit(room.current, room.opposite, room.evidence, room.usable);
}

/// Where the robot is believed to be, by whichever localization counts.
struct BelievedPose {
  Pose2 pose;                                            ///< field_from_robot
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< x, y, rotation; m^2, m rad, rad^2
  bool known = false;                                    ///< somebody told it, or it was found
};
template <typename Visit, ConstOr<BelievedPose> T>
void fields(Visit&& visit, T& belief) {
  visit(belief.pose, belief.covariance, belief.known);
}

/// In the frame that grants a reorientation, `belief` and `room` are those after it, where our own localization holds
/// the belief: after a flip, the evidence has the other sign and the confidences are 0. Where another localization
/// holds it, they stay as they are until its next belief shows what it did.
struct Answer {
  Request request;
  BelievedPose belief;
  /// Granted in this frame. Where the robot brings its own belief, it is to be carried out there; otherwise it is done.
  std::optional<Reorientation> reorientation;
  RoomConfidence room;
  bool training_paused = false;
  bool evaluation_paused = false;
  std::vector<std::string> messages;  ///< of this frame, to the team mates; each of at most kLongestMessage bytes
};
template <typename Visit, ConstOr<Answer> T>
void fields(Visit&& visit, T& answer) {
  visit(answer.request, answer.belief, answer.reorientation, answer.room, answer.training_paused,
        answer.evaluation_paused, answer.messages);
}

}  // namespace reorient
