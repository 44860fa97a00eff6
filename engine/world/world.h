// SPDX-License-Identifier: MIT
// The world as behaviours see it: one snapshot a frame, read-only for scripts. SI units, field frame unless said.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/world/posture.h"
#include "geometry/camera_bias.h"
#include "geometry/const_or.h"
#include "geometry/field_dimensions.h"
#include "geometry/head.h"
#include "geometry/pose2.h"
#include "localization/pose_belief.h"
#include "perception/room/room_awareness.h"
#include "robots/referee.h"
#include "robots/robot_body.h"

namespace reorient {

/// Whether the confidences say something about the believed pose and its reflection (room_status.h).
enum class RoomStatus {
  usable,
  off,        ///< this robot has no room awareness
  resting,    ///< what is seen is not compared: paused, or the robot is not on its feet
  unlearned,  ///< too little of the room is known
  symmetric,  ///< the room looks the same after half a turn
  lost,       ///< the pose filter is lost: both poses may be wrong
  fresh       ///< too little was seen since the confidences began anew
};
inline constexpr int kRoomStatuses = 7;
constexpr int enum_count(RoomStatus) { return kRoomStatuses; }

/// "usable": as scripts call it.
std::string_view to_string(RoomStatus status);

struct World {
  double time = 0.0;              ///< s
  double time_step = 1.0 / 30.0;  ///< s since the frame before
  std::uint64_t frame = 0;

  Posture posture = Posture::upright;
  Posture posture_before = Posture::upright;  ///< the one before the present one
  double posture_for = 0.0;                   ///< s, how long it has been so
  RefereeState referee;
  bool may_walk = true;        ///< as far as the referee says
  bool sides_changed = false;  ///< the team plays towards the end that was its own at first
  double time_since_disturbance =
      0.0;  ///< s since the robot was last anything but upright and in the game; 0 while it is
  HeadAngles head;
  double head_reach = 0.0;  ///< rad that the neck turns to either side
  bool can_walk = true;     ///< this body
  bool can_get_up = true;
  double cruise = 0.0;  ///< m/s at which this body goes far; 0: it does not walk

  PoseBelief pose;
  double recovery_probability = 0.0;  ///< 0 to 1: how sure the pose filter is that the robot is elsewhere
  bool pose_tracked = true;           ///< what is seen fits the belief, or its reflection, for seconds
  std::uint64_t body = 0;             ///< digest_of() it
  CameraBias camera_bias;             ///< by how much the measured angles are wrong, as far as that is known
  bool pose_known = false;            ///< somebody told where the robot stands, or the filter has found it

  bool room_awareness = true;
  Confidences confidence;
  InformativeViews views;
  RoomStatus room_status = RoomStatus::resting;
  double trained_seconds =
      0.0;                ///< s, for which the background model was trained, before this run, too; 0.2 an image at most
  bool training = false;  ///< in the frame before
  bool evaluating = false;
  int goal_posts = 0;  ///< seen in this frame
  int line_points = 0;
  int intersections = 0;
  bool ball = false;           ///< seen in this frame
  double ball_distance = 0.0;  ///< m, along the ground; 0 where it is not seen
  double ball_bearing = 0.0;   ///< rad, to the left of straight ahead
  FieldDimensions field;

  bool upright() const { return posture == Posture::upright; }
  /// Anything else than upright and in the game: the belief may not hold any more.
  bool disturbed() const { return !upright() || referee.penalized; }
};
template <typename Visit, ConstOr<World> T>
void fields(Visit&& visit, T& world) {
  visit(world.time, world.time_step, world.frame, world.posture, world.posture_before, world.posture_for, world.referee,
        world.may_walk, world.sides_changed, world.time_since_disturbance, world.head, world.head_reach, world.can_walk,
        world.can_get_up, world.cruise, world.pose, world.recovery_probability, world.pose_tracked, world.body,
        world.camera_bias, world.pose_known, world.room_awareness, world.confidence, world.views, world.room_status,
        world.trained_seconds, world.training, world.evaluating, world.goal_posts, world.line_points,
        world.intersections, world.ball, world.ball_distance, world.ball_bearing, world.field);
}

/// What is worth keeping of the angles for another day; nothing: too little is known.
inline std::optional<KnownBias> known_bias(const World& world) {
  constexpr double kSureEnough = from_degrees(0.7);
  const double deviation = world.camera_bias.deviation;  // 0 if it is not learned
  const bool is_known = world.pose_tracked && deviation > 0.0 && deviation <= kSureEnough;
  return is_known ? std::optional(KnownBias{world.body, world.camera_bias}) : std::nullopt;
}

/// Of a body on a field, before anything was seen.
inline World world_of(const FieldDimensions& field, const RobotBody& body) {
  World world;
  world.field = field;
  world.body = digest_of(body);
  world.head_reach = body.neck.yaw;
  world.can_walk = body.gait.has_value();
  world.can_get_up = body.get_up_time.has_value();
  world.cruise = body.gait ? body.gait->cruise : 0.0;
  return world;
}

}  // namespace reorient
