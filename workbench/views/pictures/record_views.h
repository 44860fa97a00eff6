// From a frame's record to what is drawn of it.
#pragma once

#include <span>

#include "workbench/run/observer.h"
#include "workbench/views/pictures/camera_view.h"
#include "workbench/views/pictures/world_view.h"

namespace reorient::pictures {

/// Needs the topics pose_particles and room. In a frame with a reorientation: just before it.
WorldView world_view_of(const FrameRecord& frame, const StageRecord& stage);

/// What is known of a room, without a robot in it.
WorldView world_view_of(const RoomRecord& room, const FieldDimensions& field);

/// Of the upper camera, or the lower one where there is no other. Needs the topics images and room; the view is valid
/// as long as the record's image.
CameraView camera_view_of(const FrameRecord& frame);

/// Points on lines, each with a stroke across its line. The camera is where it was believed to be when they were found.
void add_line_points(std::span<const LinePoint> points, const CameraModel& camera, const Isometry3& robot_from_camera,
                     CameraView& view);

/// Line points, goal posts, obstacles and the carpet's boundary. Of the view's image, which is set
/// before.
void add_percept(const FieldPercept& percept, const CameraModel& camera, const Isometry3& robot_from_camera,
                 CameraView& view);

/// The wall's tiles that were perceived from there, those that all project into the image's surroundings.
void add_tiles(std::span<const PerceivedTile> perceived, const Wall& wall, const CameraModel& camera,
               const Isometry3& field_from_camera, CameraView& view);

/// The field's lines, circle and arcs as a camera there should see them.
void add_field_lines(const FieldDimensions& field, const CameraModel& camera, const Isometry3& field_from_camera,
                     CameraView& view);

}  // namespace reorient::pictures
