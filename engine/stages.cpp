// SPDX-License-Identifier: MIT
#include "engine/stages.h"

#include "engine/covered_areas.h"
#include "engine/merged_percepts.h"
#include "engine/world/goal_view.h"
#include "engine/world/seen_view.h"
#include "localization/reorientation.h"

namespace reorient {
namespace {

constexpr std::size_t kUpper = 0, kLower = 1;  // in arrays with one element for each camera

/// The robot's motion since the exposure of the image, in its current frame: two cameras are rarely exposed
/// at the same instant.
Pose2 moved_since(const CameraFrame& frame, const Observation& observation) {
  return observation.odometry.inverse() * frame.odometry;
}

/// If an external localization has two opposite hypotheses of about equal weight, the engine continues with the one
/// that it believes. After a flip such a pair is the same pair, so the observations do not show the flip. So the engine
/// flips its own belief.
bool are_equals(const PoseBelief& belief, const PoseClusterParameters& clusters) {
  return belief.cluster_weight <= clusters.lead_to_switch * belief.reflected_weight;
}

void apply_outside(Reorientation reorientation, const PoseClusterParameters& clusters,
                   std::optional<RoomAwareness>& room, WorldTracker& world) {
  if (room && reorientation == Reorientation::purge_reflection) room->on_purge();
  if (reorientation != Reorientation::flip_pose || !are_equals(world.world().pose, clusters)) return;
  world.take_flip(flipped(world.world().pose));
  if (room) room->on_flip();
}

}  // namespace

BodySample latest_sample(const Observation& observation) {
  BodySample sample = observation.body;
  if (sample.time == 0.0) sample.time = observation.time;
  return sample;
}

SensedPosture sense_posture(const Observation& observation, const BodySample& latest, const RobotBody& body,
                            bool get_up_requested, const PostureParameters& parameters, PostureEstimator& estimator) {
  const PostureEstimator::Hints hints{observation.reported_posture, get_up_requested};
  for (const BodySample& sample : observation.body_samples) {
    if (sample.time <= observation.time) estimator.update(sample, body.standing_load, hints, parameters);
  }
  estimator.update(latest, body.standing_load, hints, parameters);
  return {estimator.posture(), estimator.before(), estimator.since()};
}

CameraPercepts see_field(const Observation& observation, const World& world, const CameraBias& bias,
                         const CoreParameters& parameters, FieldVision& vision, InputRecord& cameras,
                         FieldPercepts& percepts) {
  CameraPercepts seen;
  DetectorCameras detector;
  const bool has_own_vision = !observation.percepts || !observation.percepts->replaces_vision;
  const auto see = [&](const std::optional<CameraFrame>& frame, std::optional<CameraRecord>& camera,
                       std::size_t which) {
    FieldPercept& percept = percepts[which];
    percept.clear();
    camera.reset();
    if (!frame) return;
    camera = CameraRecord{frame->time, frame->camera, corrected(frame->robot_from_camera, bias, which),
                          frame->image.width, frame->image.height};
    Isometry3 measured = frame->robot_from_camera;
    if (frame->time != observation.time) {
      const Isometry3 moved = to_isometry(moved_since(*frame, observation));
      camera->robot_from_camera = moved * camera->robot_from_camera;
      measured = moved * measured;
    }
    if (observation.percepts) detector[which] = {frame->camera, measured, camera->robot_from_camera};
    if (world.upright() && has_own_vision)
      vision[which].find(frame->image, frame->camera, camera->robot_from_camera, percept);
    seen[which] = {&percept, camera->robot_from_camera, &camera->camera};
  };
  see(observation.upper, cameras.upper, kUpper);
  see(observation.lower, cameras.lower, kLower);
  if (observation.percepts && world.upright())
    add_external(*observation.percepts, detector, world.field, parameters.external_percepts, parameters.field_features,
                 percepts);
  return seen;
}

std::optional<SensedBelief> read_external_belief(const Observation& observation, const World& last,
                                                 const Pose2& odometry_step, const CoreParameters& parameters,
                                                 ExternalBeliefReader& reader, ExternalUse& external) {
  if (const auto belief = reader.read(observation.belief, last.pose, parameters.localizer.filter.clusters)) {
    external = {.in_use = true, .unread_for = 0.0};
    return SensedBelief{*belief, is_known(*belief)};
  }
  external.unread_for += last.time_step;
  if (!external.in_use || external.unread_for > parameters.external_belief.patience) return std::nullopt;
  PoseBelief moved = last.pose;
  moved.pose = moved.pose * odometry_step;
  return SensedBelief{moved, last.pose_tracked};
}

LocalizerInputs localizer_inputs(const Observation& observation, const World& world, const Pose2& odometry_step,
                                 const CameraPercepts& seen, const std::optional<RoomAwareness>& room,
                                 const CoreParameters& parameters) {
  LocalizerInputs inputs{.time = world.time,
                         .time_step = world.time_step,
                         .odometry = observation.odometry,
                         .odometry_step = odometry_step,
                         .upright = world.upright(),
                         .seen = seen};
  if (!room) return inputs;
  inputs.goal = seen_goal(room->confidences(), parameters.goal_view);
  inputs.view = seen_view(*room, observation.odometry.rotation, parameters.seen_view);
  return inputs;
}

std::optional<HeadCamera> look_at_room(const Observation& observation, const CameraPercepts& seen, const World& world,
                                       std::vector<CoveredArea>& covered, RoomAwareness& room) {
  if (!observation.upper && !observation.lower) return std::nullopt;
  // The upper camera sees more of the wall; the lower one is used only without an upper image.
  const bool is_upper = observation.upper.has_value();
  const CameraFrame& frame = is_upper ? *observation.upper : *observation.lower;
  const CameraPercept& camera = seen[is_upper ? kUpper : kLower];
  collect_covered(*camera.percept, covered);
  room.update({.time = observation.time,
               .image = frame.image,
               .camera = frame.camera,
               .robot_from_camera = camera.robot_from_camera,
               .belief = world.pose.pose,
               .odometry_rotation = observation.odometry.rotation,
               .covered = covered,
               .train = world.training,
               .evaluate = world.evaluating});
  return is_upper ? HeadCamera::upper : HeadCamera::lower;
}

SensedField summary_of(const FieldPercepts& percepts, const HeadAngles& head) {
  SensedField seen{.head = head};
  for (const FieldPercept& percept : percepts) {
    seen.goal_posts += static_cast<int>(percept.goal_posts.size());
    seen.line_points += static_cast<int>(percept.line_points.size());
    seen.intersections += static_cast<int>(percept.intersections.size());
    if (percept.ball) seen.ball = percept.ball->position;
  }
  return seen;
}

Decision decide(const World& world, std::span<const Message> messages, Behaviors& behaviors, Arbiter& arbiter) {
  behaviors.tick(world, messages, &arbiter);
  const Arbitration& arbitration = arbiter.arbitrate(behaviors.wanted().commands, behaviors.leases(), world);
  return {arbitration, behaviors.wanted()};
}

void append_poses(const ExternalUse& external, const ExternalBeliefReader& reader, const Localizer& localizer,
                  const Pose2& believed, std::vector<Pose2>& poses) {
  if (!external.in_use) return localizer.append_poses(poses);
  const std::vector<Pose2>& read = reader.poses();
  if (read.empty()) return poses.push_back(believed);
  poses.insert(poses.end(), read.begin(), read.end());
}

ReorientationRecord apply(const CommandRecord& granted, bool is_external, const PoseClusterParameters& clusters,
                          Localizer& localizer, std::optional<RoomAwareness>& room, RepeatedPose& repeated_pose,
                          WorldTracker& world) {
  const Reorientation reorientation = granted.request.reorientation;
  ReorientationRecord record;
  record.reorientation = reorientation;
  record.issuer = granted.request.issuer;
  record.belief_before = world.world().pose;
  if (is_external) {
    record.belief_after = expected_after(reorientation, world.world().pose);
    apply_outside(reorientation, clusters, room, world);
    return record;
  }
  switch (reorientation) {
    case Reorientation::flip_pose:
      localizer.flip_pose();
      repeated_pose.note_flip(world.world().time);
      if (room) room->on_flip();
      break;
    case Reorientation::purge_reflection:
      localizer.purge_reflection();
      if (room) room->on_purge();
      break;
    case Reorientation::reset_orientation:
      localizer.reset_orientation();
      if (room) room->on_reset();
      break;
  }
  record.belief_after = localizer.belief();
  world.take_reorientation(reorientation, record.belief_after);
  return record;
}

void fill_answer(const World& world, const Decision& decision, const std::optional<ReorientationRecord>& reorientation,
                 Answer& answer) {
  answer.request = permitted(decision.requests.request, world);
  answer.messages = decision.requests.messages;
  answer.belief = {world.pose.pose, world.pose.covariance, world.pose_known};
  answer.reorientation.reset();
  if (reorientation) answer.reorientation = reorientation->reorientation;
  answer.room = {world.confidence.current, world.confidence.opposite, world.confidence.evidence,
                 world.room_status == RoomStatus::usable};
  answer.training_paused = !decision.arbitration.train;
  answer.evaluation_paused = !decision.arbitration.evaluate;
}

}  // namespace reorient
