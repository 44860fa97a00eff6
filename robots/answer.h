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
#include "robots/application.h"

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
  HeadAngles angles;                   ///< requested joint angles, rad; clamped to the range of the neck
  double speed = from_degrees(120.0);  ///< rad/s, at most the motors' own limit
};
template <typename Visit, ConstOr<HeadRequest> T>
void fields(Visit&& visit, T& head) {
  visit(head.angles, head.speed);
}

/// The motion that behaviors request, valid until the next request. Without a head request the head does not move.
struct Request {
  std::optional<HeadRequest> head;
  WalkVelocity walk;    ///< zero: stand
  bool get_up = false;  ///< after a fall
};
template <typename Visit, ConstOr<Request> T>
void fields(Visit&& visit, T& request) {
  visit(request.head, request.walk, request.get_up);
}

/// Maximum length of a message from one robot to another, bytes.
inline constexpr std::size_t kLongestMessage = 240;

/// Commands that change a belief (Section 3.1 of the paper).
enum class Reorientation { flip_pose, purge_reflection, reset_orientation };
constexpr int enum_count(Reorientation) { return 3; }

/// How much the room supports the believed pose and the mirrored pose, for the localization that owns the belief.
struct RoomConfidence {
  double current = 0.0;   ///< confidence in the believed pose, 0 to 1
  double opposite = 0.0;  ///< confidence in the mirrored pose, 0 to 1
  double evidence = 0.0;  ///< log-odds of the mirrored pose against the pose: log(99) means 99 in 100 for the mirrored
  bool usable = false;    ///< the room is learned, in view, and differs from itself rotated by 180 degrees
};
template <typename Visit, ConstOr<RoomConfidence> T>
void fields(Visit&& visit, T& room) {
  visit(room.current, room.opposite, room.evidence, room.usable);
}

/// The belief of the localization that is used.
struct BelievedPose {
  Pose2 pose;                                            ///< field_from_robot
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< x, y, rotation; m^2, m rad, rad^2
  bool known = false;                                    ///< an initial pose was set, or a pose was found
};
template <typename Visit, ConstOr<BelievedPose> T>
void fields(Visit&& visit, T& belief) {
  visit(belief.pose, belief.covariance, belief.known);
}

/// With Reorient's own localization, `belief` and `room` are those after the reorientation that this frame grants:
/// after a flip, the evidence has the other sign and the confidences are 0. With an external localization, both are
/// unchanged until its next belief shows that it carried out the reorientation.
struct Answer {
  Request request;
  BelievedPose belief;
  /// Granted in this frame. An external localization must carry it out; Reorient's own localization has done so.
  std::optional<Reorientation> reorientation;
  RoomConfidence room;
  bool training_paused = false;
  bool evaluation_paused = false;
  std::vector<std::string> messages;   ///< from this frame to the teammates, at most kLongestMessage bytes each
  std::vector<StartedAction> actions;  ///< of the application; their record is Topic::application
};
template <typename Visit, ConstOr<Answer> T>
void fields(Visit&& visit, T& answer) {
  visit(answer.request, answer.belief, answer.reorientation, answer.room, answer.training_paused,
        answer.evaluation_paused, answer.messages);
}

}  // namespace reorient
