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

/// A part of the belief of the view.
struct ViewShare {
  double azimuth = 0.0;  ///< rad
  double share = 0.0;    ///< of the largest part
};

/// The belief of the view, without parts below a hundredth of the largest one.
std::vector<ViewShare> view_shares(const RoomRecord& room);

/// The tiles of the wall in their mean colors. Field frame.
Scene wall_scene(const RoomRecord& room);
/// The belief of the view as rods on the ground near the wall. Field frame.
Scene view_scene(const RoomRecord& room);

/// The detections of both cameras on the ground. Robot frame. `fits`: of the same cameras, or empty. Line points and
/// goal posts that the pose filter rejects at the believed pose, or does not use, have an opacity below 0.5.
Scene percept_scene(std::span<const FieldPercept> percepts, std::span<const FeatureFits> fits = {});

/// Field frame. The symbol of the truth is larger than that of the belief, so that it is visible below a correct
/// belief.
std::vector<PoseLayer> pose_layers(const std::vector<Pose2>& particles, const std::optional<Pose2>& truth,
                                   const std::optional<Pose2>& belief);

/// The text "corner", "L", "T" or "X".
inline const char* name_of(const Intersection& one) { return one.corner_arc ? "corner" : reorient::name_of(one.kind); }

/// The belief at the observation of the room, which is before the frame's reorientation, if any.
const Pose2& observing_belief(const FrameRecord& frame);

}  // namespace reorient::scene
