// The world as behaviours see it: one snapshot a frame, read-only for scripts. SI units, field frame unless said.
#pragma once

#include <cstdint>

#include "geometry/field_dimensions.h"
#include "geometry/head.h"
#include "geometry/pose2.h"
#include "localization/pose_belief.h"
#include "perception/room/room_awareness.h"

namespace reorient {

struct World {
  double time = 0.0;              ///< s
  double time_step = 1.0 / 30.0;  ///< s since the frame before
  std::uint64_t frame = 0;

  bool fallen = false;   ///< the torso lies
  bool carried = false;  ///< no load on the feet
  bool penalized = false;
  HeadAngles head;

  PoseBelief pose;
  double recovery_probability = 0.0;  ///< 0 to 1: how sure the pose filter is that the robot is elsewhere
  bool pose_known = false;            ///< somebody told where the robot stands, or the filter has found it
  Confidences confidence;
  double trained_seconds = 0.0;  ///< time during which the background model was trained so far
  bool training = false;         ///< in the frame before
  bool evaluating = false;
  int goal_posts = 0;  ///< seen in this frame
  int line_points = 0;
  FieldDimensions field;
};
template <typename Visit>
void fields(Visit&& visit, World& world) {
  visit(world.time, world.time_step, world.frame, world.fallen, world.carried, world.penalized, world.head, world.pose,
        world.recovery_probability, world.pose_known, world.confidence, world.trained_seconds, world.training,
        world.evaluating, world.goal_posts, world.line_points, world.field);
}

}  // namespace reorient
