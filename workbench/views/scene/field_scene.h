// SPDX-License-Identifier: MIT
// Field, wall, percepts and poses of a frame as scenes.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/record/frame_record.h"
#include "geometry/field_dimensions.h"
#include "workbench/views/scene/shapes.h"

namespace reorient::scene {

/// Lines, circles, arcs and marks. Field frame.
SceneLayer field_line_layer(const FieldDimensions& field);

/// Carpet, lines and goals. Field frame.
Scene field_scene(const FieldDimensions& field);

/// The tiles of the wall in their mean colors, and the belief of the view as rods on the ground. Field frame.
Scene wall_scene(const RoomRecord& room);

/// The detections of both cameras on the ground. Robot frame.
Scene percept_scene(std::span<const FieldPercept> percepts);

/// Field frame. The symbol of the truth is larger than that of the belief, so that it is visible below a correct
/// belief.
std::vector<PoseLayer> pose_layers(const std::vector<Pose2>& particles, const std::optional<Pose2>& truth,
                                   const std::optional<Pose2>& belief);

/// The text "corner", "L", "T" or "X".
inline const char* name_of(const Intersection& one) { return one.corner_arc ? "corner" : reorient::name_of(one.kind); }

/// The belief at the observation of the room, which is before the frame's reorientation, if any.
const Pose2& observing_belief(const FrameRecord& frame);

}  // namespace reorient::scene
