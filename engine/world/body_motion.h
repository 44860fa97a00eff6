// SPDX-License-Identifier: MIT
// How the body moves, as behaviors see it.
#pragma once

#include "geometry/const_or.h"
#include "geometry/head.h"
#include "geometry/pose2.h"
#include "robots/answer.h"

namespace reorient {

struct BodyMotion {
  double requested_speed = 0.0;  ///< m/s, of the walk request of the previous frame that the robot got
  double requested_turn = 0.0;   ///< rad/s, to the left
  WalkVelocity measured;         ///< by the odometry, smoothed
  double speed = 0.0;            ///< m/s, of `measured` along the ground
  double head_speed = 0.0;       ///< rad/s, of the faster joint of the neck, smoothed
};
template <typename Visit, ConstOr<BodyMotion> T>
void fields(Visit&& visit, T& motion) {
  visit(motion.requested_speed, motion.requested_turn, motion.measured, motion.speed, motion.head_speed);
}

/// After a frame of `step` s, in which the odometry has measured `moved`.
BodyMotion after_step(BodyMotion motion, const Pose2& moved, double step);
/// The same for the head. `turned`: its measured angles minus those of the previous frame, rad.
BodyMotion after_turn_of_head(BodyMotion motion, const HeadAngles& turned, double step);
/// After a request that the robot gets.
BodyMotion after_request(BodyMotion motion, const WalkVelocity& walk);

/// Whether the robot walks or turns: it is requested, or measured above 0.03 m/s or 0.1 rad/s.
bool is_walking(const BodyMotion& motion);
/// Whether the head turns faster than 0.1 rad/s.
bool is_head_moving(const BodyMotion& motion);

}  // namespace reorient
