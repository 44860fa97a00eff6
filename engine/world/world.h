// SPDX-License-Identifier: MIT
// The world that behaviors read: one snapshot per frame, read-only. SI units and field frame unless noted.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/world/body_motion.h"
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

/// Whether the confidences are valid for the believed and the mirrored pose (room_status.h).
enum class RoomStatus {
  usable,
  off,        ///< this robot has no room awareness
  resting,    ///< no evaluation: paused, or the robot is not on its feet
  unlearned,  ///< too little of the room is learned
  symmetric,  ///< the room looks the same after a rotation by 180 degrees
  lost,       ///< the pose filter is lost: both poses may be wrong
  fresh       ///< too little was seen since the confidences restarted
};
inline constexpr int kRoomStatuses = 7;
constexpr int enum_count(RoomStatus) { return kRoomStatuses; }

/// "usable": the name in scripts.
std::string_view to_string(RoomStatus status);

struct World {
  double time = 0.0;              ///< s
  double time_step = 1.0 / 30.0;  ///< s since the previous frame
  std::uint64_t frame = 0;

  Posture posture = Posture::upright;
  Posture posture_before = Posture::upright;  ///< previous posture
  double posture_for = 0.0;                   ///< s since the posture changed
  RefereeState referee;
  bool may_walk = true;                 ///< permitted by the referee
  bool sides_changed = false;           ///< the teams have changed sides
  double time_since_disturbance = 0.0;  ///< s since the robot was last not upright or not in the game; 0 during that
  HeadAngles head;
  BodyMotion motion;
  double head_reach = 0.0;  ///< rad, largest yaw of the head to either side
  bool can_walk = true;     ///< this body
  bool can_get_up = true;
  double cruise = 0.0;  ///< m/s, walking speed over long distances; 0: it cannot walk

  PoseBelief pose;
  double recovery_probability = 0.0;  ///< 0 to 1: how much worse than usual the particles fit the field
  bool pose_tracked = true;           ///< the observations have fitted the belief or the mirrored pose for seconds
  std::uint64_t body = 0;             ///< digest_of() it
  CameraBias camera_bias;             ///< estimated errors of the measured angles
  bool pose_known = false;            ///< an initial pose was set, or the filter has found the pose

  bool room_awareness = true;
  Confidences confidence;
  InformativeViews views;
  RoomStatus room_status = RoomStatus::resting;
  double trained_seconds =
      0.0;                ///< s of training of the background model, including earlier runs; at most 0.2 per image
  bool training = false;  ///< in the previous frame
  bool evaluating = false;
  int goal_posts = 0;  ///< seen in this frame
  int line_points = 0;
  int intersections = 0;
  bool ball = false;           ///< seen in this frame
  double ball_distance = 0.0;  ///< m, along the ground; 0 if no ball is seen
  double ball_bearing = 0.0;   ///< rad, to the left of straight ahead
  FieldDimensions field;

  bool upright() const { return posture == Posture::upright; }
  /// Not upright or not in the game: the belief may have become wrong.
  bool disturbed() const { return !upright() || referee.penalized; }
};
template <typename Visit, ConstOr<World> T>
void fields(Visit&& visit, T& world) {
  visit(world.time, world.time_step, world.frame, world.posture, world.posture_before, world.posture_for, world.referee,
        world.may_walk, world.sides_changed, world.time_since_disturbance, world.head, world.motion, world.head_reach,
        world.can_walk, world.can_get_up, world.cruise, world.pose, world.recovery_probability, world.pose_tracked,
        world.body, world.camera_bias, world.pose_known, world.room_awareness, world.confidence, world.views,
        world.room_status, world.trained_seconds, world.training, world.evaluating, world.goal_posts, world.line_points,
        world.intersections, world.ball, world.ball_distance, world.ball_bearing, world.field);
}

/// The errors of the angles to save for later runs; nothing: too uncertain.
inline std::optional<KnownBias> known_bias(const World& world) {
  constexpr double kSureEnough = from_degrees(0.7);
  const double deviation = world.camera_bias.deviation;  // 0 if it is not learned
  const bool is_known = world.pose_tracked && deviation > 0.0 && deviation <= kSureEnough;
  return is_known ? std::optional(KnownBias{world.body, world.camera_bias}) : std::nullopt;
}

/// Of a body on a field, before the first observation.
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
