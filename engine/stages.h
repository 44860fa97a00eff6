// SPDX-License-Identifier: MIT
// The stages of a frame. What each of them reads and writes stands in its signature; FrameLoop::step() calls them in
// their order.
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

/// The body sample of the observation; one without a time was taken with it.
BodySample latest_sample(const Observation& observation);

/// What the body's own senses say of its posture. `latest`: of the observation. `asked_to_get_up`: by the last answer.
SensedPosture sense_posture(const Observation& observation, const BodySample& latest, const RobotBody& body,
                            bool asked_to_get_up, const PostureParameters& parameters, PostureEstimator& estimator);

/// Fills in the camera records and the percepts; what is returned refers to `percepts`. `bias`: of the camera's angles.
CameraPercepts see_field(const Observation& observation, const World& world, const CameraBias& bias,
                         FieldVision& vision, InputRecord& cameras, FieldPercepts& percepts);

/// The belief of another localization where one is given; ours rests then. If none can be read, the last one moves with
/// the odometry for a while. Nothing: the robot goes by its own localization.
std::optional<SensedBelief> read_external_belief(const Observation& observation, const World& last,
                                                 const Pose2& odometry_step, const CoreParameters& parameters,
                                                 ExternalBeliefReader& reader, ExternalUse& external);

/// What the own localization uses of this frame. `room`: as the frame before has left it.
LocalizerInputs localizer_inputs(const Observation& observation, const World& world, const Pose2& odometry_step,
                                 const CameraPercepts& seen, const std::optional<RoomAwareness>& room,
                                 const CoreParameters& parameters);

/// Trains the model of the room and compares it with what is seen, as far as the world permits. Returns the camera
/// through which the room was seen; nothing: there is no image. `covered`: memory that is used again.
std::optional<HeadCamera> look_at_room(const Observation& observation, const CameraPercepts& seen, const World& world,
                                       std::vector<CoveredArea>& covered, RoomAwareness& room);

/// What behaviors see of the field.
SensedField summary_of(const FieldPercepts& percepts, const HeadAngles& head);

/// What the behaviors want, and what of their commands is granted. Refers to the behaviors' and the arbiter's memory.
struct Decision {
  const Arbitration& arbitration;
  const BehaviorOutput& wanted;
};
Decision decide(const World& world, std::span<const Message> heard, Behaviors& behaviors, Arbiter& arbiter);

/// The particles of the localization in use, or its pose where it has none, appended.
void append_poses(const ExternalUse& external, const ExternalBeliefReader& reader, const Localizer& localizer,
                  const Pose2& believed, std::vector<Pose2>& poses);

/// Carries out a granted reorientation on the belief and on what was compared with it. An external localization carries
/// it out itself, or not; what becomes of its belief, the next observations say.
ReorientationRecord apply(const CommandRecord& granted, bool is_external, const PoseClusterParameters& clusters,
                          Localizer& localizer, std::optional<RoomAwareness>& room, RepeatedPose& repeated_pose,
                          WorldTracker& world);

/// What the robot is asked for. `world`: after the reorientation, if there was one.
void fill_answer(const World& world, const Decision& decision, const std::optional<ReorientationRecord>& reorientation,
                 Answer& answer);

}  // namespace reorient
