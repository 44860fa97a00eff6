// SPDX-License-Identifier: MIT
// From a frame's record to what is drawn of it.
#pragma once

#include "workbench/run/observer.h"
#include "workbench/views/pictures/camera_view.h"
#include "workbench/views/pictures/world_view.h"

namespace reorient::pictures {

/// Needs the topics pose_particles and room. In a frame with a reorientation: just before it.
WorldView world_view_of(const FrameRecord& frame, const SceneTruth& scene);

/// What is known of a room, without a robot in it.
WorldView world_view_of(const RoomRecord& room, const FieldDimensions& field);

/// Of the upper camera, or the lower one where there is no other. Needs the topics images and room; the view is valid
/// as long as the record's image.
CameraView camera_view_of(const FrameRecord& frame);

}  // namespace reorient::pictures
