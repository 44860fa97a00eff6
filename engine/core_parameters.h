// SPDX-License-Identifier: MIT
// All parameters of the engine except those of scripts; the registry changes them live.
#pragma once

#include "engine/merged_percepts.h"
#include "engine/world/arbiter.h"
#include "engine/world/external_belief.h"
#include "engine/world/goal_view.h"
#include "engine/world/posture.h"
#include "engine/world/repeated_pose.h"
#include "engine/world/room_status.h"
#include "engine/world/seen_view.h"
#include "geometry/field_dimensions.h"
#include "localization/localizer.h"
#include "perception/field/field_features.h"
#include "perception/room/room_awareness.h"
#include "robots/robot_body.h"

namespace reorient {

class ParameterRegistry;

struct CoreParameters {
  PostureParameters posture;
  FieldFeatureParameters field_features;
  LocalizerParameters localizer;
  RoomParameters room;
  RoomStatusParameters room_status;
  GoalViewParameters goal_view;
  SeenViewParameters seen_view;
  RepeatedPoseParameters repeated_pose;
  ExternalBeliefParameters external_belief;
  ExternalPerceptParameters external_percepts;
  ArbiterParameters arbiter;
};

/// The defaults, chosen for a NAO on the field of the Standard Platform League and adapted to this body and this field:
/// the ranges of vision and of the neck, and the distance of the room, are computed from both.
CoreParameters core_parameters_for(const FieldDimensions& field, const RobotBody& body);

/// Declares all `parameters` in the registry, which changes them in place: they must outlive it.
void declare(CoreParameters& parameters, ParameterRegistry& registry);

}  // namespace reorient
