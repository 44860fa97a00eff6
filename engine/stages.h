// SPDX-License-Identifier: MIT
// The stages of a frame. The signatures show what each reads and writes; FrameLoop::step() calls them in
// this order.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/carried.h"
#include "engine/core_parameters.h"
#include "engine/record/frame_record.h"
#include "engine/script/behaviors.h"
#include "engine/world/arbiter.h"
#include "engine/world/posture.h"
#include "engine/world/repeated_pose.h"
#include "engine/world/world.h"
#include "localization/localizer.h"
#include "perception/field/field_features.h"
#include "perception/room/room_awareness.h"
#include "robots/robot.h"
#include "robots/robot_body.h"

namespace reorient {

/// Of the upper and of the lower camera.
using FieldVision = std::array<FieldFeatures, 2>;
using FieldPercepts = std::array<FieldPercept, 2>;
using CameraPercepts = std::array<CameraPercept, 2>;

/// The body sample of the observation; a sample without a time gets the observation's time.
BodySample latest_sample(const Observation& observation);

/// Updates the posture from the body's sensors. `latest`: of the observation. `get_up_requested`: in the last answer.
SensedPosture sense_posture(const Observation& observation, const BodySample& latest, const RobotBody& body,
                            bool get_up_requested, const PostureParameters& parameters, PostureEstimator& estimator);

/// Fills in the camera records and the percepts, also those of an external detector; the result refers to `percepts`.
/// `bias`: of the camera's angles.
CameraPercepts see_field(const Observation& observation, const World& world, const CameraBias& bias,
                         const CoreParameters& parameters, FieldVision& vision, InputRecord& cameras,
                         FieldPercepts& percepts);

/// The belief of an external localization if given; the engine's own pauses then. If it cannot be read, the last belief
/// moves with the odometry for some time. Nothing: the engine's own localization is in use.
std::optional<SensedBelief> read_external_belief(const Observation& observation, const World& last,
                                                 const Pose2& odometry_step, const CoreParameters& parameters,
                                                 ExternalBeliefReader& reader, ExternalUse& external);

/// Inputs of the engine's localization in this frame. `room`: after the previous frame.
LocalizerInputs localizer_inputs(const Observation& observation, const World& world, const Pose2& odometry_step,
                                 const CameraPercepts& seen, const std::optional<RoomAwareness>& room,
                                 const CoreParameters& parameters);

/// Trains the model of the room and compares it with the view, if the world permits. Returns the camera
/// that was used for the room; nothing: no image. `covered`: reused memory.
std::optional<HeadCamera> look_at_room(const Observation& observation, const CameraPercepts& seen, const World& world,
                                       std::vector<CoveredArea>& covered, RoomAwareness& room);

/// Observations of the field for behaviors.
SensedField summary_of(const FieldPercepts& percepts, const HeadAngles& head);

/// Requests of the behaviors, and the granted command. Refers to the behaviors' and the arbiter's memory.
struct Decision {
  const Arbitration& arbitration;
  const BehaviorOutput& requests;
};
Decision decide(const World& world, std::span<const Message> messages, Behaviors& behaviors, Arbiter& arbiter);

/// Appends the particles of the localization in use, or its pose if it has no particles.
void append_poses(const ExternalUse& external, const ExternalBeliefReader& reader, const Localizer& localizer,
                  const Pose2& believed, std::vector<Pose2>& poses);

/// Applies a granted reorientation to the belief and to the confidences. An external localization may apply it itself;
/// the next observations contain its belief.
ReorientationRecord apply(const CommandRecord& granted, bool is_external, const PoseClusterParameters& clusters,
                          Localizer& localizer, std::optional<RoomAwareness>& room, RepeatedPose& repeated_pose,
                          WorldTracker& world);

/// The requests to the robot. `world`: after a reorientation, if any.
void fill_answer(const World& world, const Decision& decision, const std::optional<ReorientationRecord>& reorientation,
                 Answer& answer);

}  // namespace reorient
