// SPDX-License-Identifier: MIT
#include "engine/world/world_tracker.h"

#include <algorithm>

#include "geometry/transform.h"
#include "localization/reorientation.h"

namespace reorient {

void WorldTracker::begin_frame(double time) {
  if (world_.frame > 0) world_.time_step = std::max(0.0, time - world_.time);
  world_.time = time;
  ++world_.frame;
}

void WorldTracker::change_sides() {
  world_.sides_changed = !world_.sides_changed;
  world_.pose = flipped(world_.pose);
}

void WorldTracker::take_referee(const RefereeState& referee) {
  world_.referee = referee;
  world_.may_walk = may_walk(referee);
}

bool WorldTracker::take_posture(const SensedPosture& posture) {
  const bool was_disturbed = world_.time_since_disturbance <= 0.0;
  world_.posture = posture.now;
  world_.posture_before = posture.before;
  world_.posture_for = std::max(0.0, world_.time - posture.since);
  world_.time_since_disturbance = world_.disturbed() ? 0.0 : world_.time_since_disturbance + world_.time_step;
  return was_disturbed != world_.disturbed();
}

BeliefJump WorldTracker::take_belief(const SensedBelief& sensed, const Pose2& moved,
                                     const PoseClusterParameters& clusters) {
  world_.motion = after_step(world_.motion, moved, world_.time_step);
  const Pose2 expected = world_.pose.pose * moved;
  world_.pose = sensed.belief;
  world_.pose_tracked = sensed.tracked;
  world_.recovery_probability = sensed.recovery_probability;
  const auto is_near = [&](const Pose2& pose) {
    return are_near(world_.pose.pose, pose, clusters.radius, clusters.max_rotation_difference);
  };
  if (is_near(expected)) return BeliefJump::none;
  return is_near(reflect(expected)) ? BeliefJump::to_reflection : BeliefJump::elsewhere;
}

void WorldTracker::permit_views(const Arbitration& last, bool is_judged) {
  world_.training = world_.room_awareness && world_.upright() && world_.pose_known && last.train && is_judged;
  world_.evaluating = world_.room_awareness && world_.upright() && last.evaluate;
}

void WorldTracker::take_view() {
  if (world_.training) world_.trained_seconds += std::min(world_.time_step, kLongestLook);
}

void WorldTracker::take_room(const Confidences& confidence, const InformativeViews& views) {
  world_.confidence = confidence;
  world_.views = views;
}

void WorldTracker::take_field(const SensedField& seen) {
  take_head(seen.head);
  world_.goal_posts = seen.goal_posts;
  world_.line_points = seen.line_points;
  world_.intersections = seen.intersections;
  world_.ball = seen.ball.has_value();
  world_.ball_distance = seen.ball ? seen.ball->norm() : 0.0;
  world_.ball_bearing = seen.ball ? direction_of(*seen.ball) : 0.0;
}

void WorldTracker::take_head(const HeadAngles& head) {
  const HeadAngles turned{head.yaw - world_.head.yaw, head.pitch - world_.head.pitch};
  if (world_.frame > 1) world_.motion = after_turn_of_head(world_.motion, turned, world_.time_step);
  world_.head = head;
}

void WorldTracker::judge_room(const RoomStatusParameters& parameters) {
  world_.room_status = room_status(world_, parameters);
}

void WorldTracker::take_reorientation(Reorientation reorientation, const PoseBelief& after) {
  world_.pose_known = reorientation != Reorientation::reset_orientation;
  world_.pose = after;
}

Request permitted(Request request, const World& world) {
  if (world.referee.stopped) return {};  // all motion stops
  if (!world.may_walk || !world.can_walk) request.walk = {};
  if (!world.can_get_up) request.get_up = false;
  return request;
}

}  // namespace reorient
