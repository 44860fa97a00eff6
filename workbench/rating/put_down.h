// SPDX-License-Identifier: MIT
// A robot that is placed on the field, with a right or a mirrored belief, in a room of which only the model is
// known: how long until it flips its belief? Scripts, arbiter, evidence and choice of views are the real ones. Only the
// images are missing: the histograms of the tiles are drawn from the model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core_parameters.h"
#include "engine/parameters/parameter.h"
#include "engine/script/script_texts.h"
#include "geometry/field_dimensions.h"
#include "perception/room/compared_model.h"
#include "perception/room/saved_model.h"
#include "robots/robot_body.h"
#include "workbench/rating/synthetic_looks.h"
#include "workbench/rating/visible_tiles.h"

namespace reorient {

/// The robot, its field and its behaviors.
struct RatedRobot {
  FieldDimensions field;
  RobotBody body;
  ScriptTexts scripts{"the scripts"};
  std::vector<std::string> behaviors;       ///< loaded behaviors, as in FrameSetup
  std::vector<ParameterChange> parameters;  ///< overrides of the engine's and of those scripts'
};

/// The engine's parameters for that robot, with its overrides.
CoreParameters core_parameters_of(const RatedRobot& robot);

/// The limits of the scripts for flipping a belief (scripts/lib/decision.lua).
struct DecisionLimits {
  double unconfirmed = 0.0;   ///< log-odds, after a disturbance
  double confirmed = 0.0;     ///< log-odds, while nothing disturbs the robot
  double disturbances = 0.0;  ///< per hour
  double looks = 0.0;         ///< per hour: rate at which all of the evidence is replaced without a disturbance
};
/// Empty: the scripts have no such parameters. Throws as put_down() does.
std::optional<DecisionLimits> decision_limits_of(const RatedRobot& robot);

/// A model that is prepared for comparison, with the values that depend on it alone. Uses the model's own wall.
struct RatedModel {
  RatedModel(const SavedModel& model, const CoreParameters& core);

  BackgroundModel learned;
  double learned_for = 0.0;  ///< s
  Wall wall;
  Comparison comparison;
  ComparedModel compared;
  double separability = 0.0;         ///< probability (perception/room/separability.h)
  double separability_weight = 0.0;  ///< of the evidence

  /// The evidence before any observation.
  Confidences confidences() const;
  /// The status while the robot stands and looks around: usable, unlearned or symmetric.
  RoomStatus status(const RoomStatusParameters& parameters) const;
};

struct PutDown {
  bool is_mirrored = true;  ///< the robot believes the mirrored pose
  double head_yaw = 0.0;    ///< rad, at the beginning
  double lowering = 0.66;   ///< s, from the start until the feet carry the robot; average of the simulator
  double limit = 30.0;      ///< s, longest duration
};

struct PutDownResult {
  std::optional<double> flipped_after;  ///< s, from the start; empty: not within the limit
  double most_evidence = 0.0;           ///< largest log-odds of the mirrored pose against the believed pose
  bool has_evaluated = false;           ///< the behaviors permitted the evaluation, because the room is learned
};

/// Starts when the operator begins to place the robot. `visible`: from the believed pose. `looks`: observations of the
/// room's tiles, by tile number. Throws std::runtime_error (of a script: ScriptError) with one line.
PutDownResult put_down(const PutDown& how, const RatedRobot& robot, const RatedModel& model, const Looks& looks,
                       VisibleTiles& visible);

}  // namespace reorient
