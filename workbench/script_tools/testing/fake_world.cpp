// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/fake_world.h"

#include <algorithm>
#include <stdexcept>

#include "engine/world/external_belief.h"

namespace reorient {
namespace {

/// Confidences after a granted command, as RoomAwareness computes them.
void apply(Reorientation reorientation, Confidences& confidence, const ConfidenceParameters& parameters) {
  switch (reorientation) {
    case Reorientation::flip_pose:
      return flip(confidence);
    case Reorientation::purge_reflection:
      return parameters.restart_on_purge ? restart(confidence) : void();
    case Reorientation::reset_orientation:
      return reset(confidence);
  }
}

}  // namespace

FakeWorld::FakeWorld(ParameterRegistry& parameters, double stood_for)
    : world_(world_of(FieldDimensions(), RobotBody())) {
  parameters.bind("confidence", confidence_parameters_);
  parameters.bind("room_status", room_status_parameters_);
  posture_.since = -stood_for;
  world_.posture_for = world_.time_since_disturbance = world_.confidence.age = stood_for;
}

void FakeWorld::set(std::string_view table, std::string_view name, const WorldValue& value) {
  if (table == "clock")
    throw std::runtime_error("clock." + std::string(name) + " cannot be set: advance(SECONDS) lets time pass");
  const WorldField& field = write_world(world_, table, name, value);
  set_.insert(field.replacement.empty() ? field.full_name() : std::string(field.replacement));
  if (table == "pose" && (name == "x" || name == "y" || name == "rotation")) is_pose_set_ = true;
}

/// At half-time the axes rotate by 180 degrees, and the pose with them, unless the test has set it in the new axes.
void FakeWorld::sense_sides(WorldTracker& tracker) {
  if (world_.sides_changed == sides_changed_) return;
  sides_changed_ = world_.sides_changed;
  tracker.change_sides();
  if (!is_pose_set_) world_.pose = tracker.world().pose;
}

/// The tracker's world, except for the values that the test has set.
World FakeWorld::derived(const WorldTracker& tracker) const {
  World world = tracker.world();
  const Confidences& set = world_.confidence;
  Confidences& confidence = world.confidence;
  if (is_set("robot.posture_before")) world.posture_before = world_.posture_before;
  if (is_set("robot.posture_for")) world.posture_for = world_.posture_for;
  if (is_set("robot.time_since_disturbance")) world.time_since_disturbance = world_.time_since_disturbance;
  if (is_set("robot.speed")) world.motion.speed = world_.motion.speed;
  if (is_set("robot.turn_speed")) world.motion.measured.turn = world_.motion.measured.turn;
  if (is_set("robot.head_speed")) world.motion.head_speed = world_.motion.head_speed;
  if (is_set("robot.requested_speed")) world.motion.requested_speed = world_.motion.requested_speed;
  if (is_set("robot.may_walk")) world.may_walk = world_.may_walk;
  if (is_set("pose.known")) world.pose_known = world_.pose_known;
  if (is_set("training.active")) world.training = world_.training;
  if (is_set("training.seconds")) world.trained_seconds = world_.trained_seconds;
  if (is_set("evaluation.active")) world.evaluating = world_.evaluating;
  if (is_set("confidence.current")) confidence.current = set.current;
  if (is_set("confidence.opposite")) confidence.opposite = set.opposite;
  if (is_set("confidence.raw_current")) confidence.raw_current = set.raw_current;
  if (is_set("confidence.raw_opposite")) confidence.raw_opposite = set.raw_opposite;
  if (is_set("confidence.goal_own")) confidence.goal_own = set.goal_own;
  if (is_set("confidence.goal_opponent")) confidence.goal_opponent = set.goal_opponent;
  if (is_set("confidence.evidence")) confidence.evidence = set.evidence;
  if (is_set("confidence.age")) confidence.age = set.age;
  return world;
}

const World& FakeWorld::begin_frame(double time, const Arbitration& last, const FakeSenses& senses) {
  if (world_.frame == 0) believed_ = world_.pose.pose;  // it has stood there
  World before = world_;
  before.pose.pose = believed_;
  before.sides_changed = sides_changed_;
  before.head = world_.frame == 0 ? world_.head : head_;
  before.motion = after_request(before.motion, requested_);
  WorldTracker tracker(before);
  tracker.begin_frame(time);
  sense_sides(tracker);
  tracker.take_referee(world_.referee);
  if (senses.is_pose_set) tracker.take_initial_pose();
  if (world_.posture != posture_.now) posture_ = {world_.posture, posture_.now, time};
  Confidences confidence = world_.confidence;
  if (tracker.take_posture(posture_) || senses.is_pose_set) clear_views(confidence);
  const SensedBelief belief{world_.pose, world_.pose_tracked, world_.recovery_probability};
  switch (tracker.take_belief(belief, senses.moved, PoseClusterParameters())) {
    case BeliefJump::none:
      break;
    case BeliefJump::to_reflection:
      flip(confidence);
      break;
    case BeliefJump::elsewhere:
      reset(confidence);
      break;
  }
  tracker.take_head(world_.head);
  head_ = world_.head;
  believed_ = world_.pose.pose;
  is_pose_set_ = false;
  tracker.permit_views(last, !senses.is_pose_set);
  if (senses.sees) tracker.take_view();
  tracker.take_room(confidence, world_.views);
  world_ = derived(tracker);
  const bool compares = world_.evaluating && senses.sees && senses.knows_tiles;
  if (compares && !is_set("confidence.age")) world_.confidence.age += std::min(world_.time_step, kLongestLook);
  judge_room();
  return world_;
}

void FakeWorld::judge_room() {
  if (!is_set("confidence.status")) world_.room_status = room_status(world_, room_status_parameters_);
}

void FakeWorld::end_frame(const Arbitration& arbitration, const Request& request) {
  requested_ = request.walk;
  if (!arbitration.granted) return;
  const Reorientation reorientation = arbitration.granted->request.reorientation;
  WorldTracker tracker(world_);
  tracker.take_reorientation(reorientation, expected_after(reorientation, world_.pose));
  world_ = tracker.world();
  believed_ = world_.pose.pose;
  apply(reorientation, world_.confidence, confidence_parameters_);
  for (const char* field : {"current", "opposite", "evidence", "age"}) set_.erase(std::string("confidence.") + field);
  judge_room();
}

}  // namespace reorient
