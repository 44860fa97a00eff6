// SPDX-License-Identifier: MIT
// Converts the record of a frame to the data of pictures.
#pragma once

#include "workbench/run/observer.h"
#include "workbench/views/pictures/camera_view.h"
#include "workbench/views/pictures/world_view.h"

namespace reorient::pictures {

/// Needs the topics pose_particles and room. In a frame with a reorientation, shows the state just before it.
WorldView world_view_of(const FrameRecord& frame, const SceneTruth& scene);

/// The background model of a room, without a robot.
WorldView world_view_of(const RoomRecord& room, const FieldDimensions& field);

/// The view of the upper camera, or else of the lower one. Needs the topics images and room. The view is valid as long
/// as the record's image.
CameraView camera_view_of(const FrameRecord& frame);

}  // namespace reorient::pictures
