// SPDX-License-Identifier: MIT
// The detections in a camera's image and the prediction of the believed pose, as overlays (the paper's Fig. 4b).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/record/frame_record.h"
#include "geometry/head.h"
#include "workbench/views/scene/shapes.h"

namespace reorient::scene {

/// Sizes of marks are in pixels of an image of this width, so that they look the same at all resolutions.
inline constexpr double kMarksWidth = 1280.0;

/// Lines of the field at the believed pose, and the percept. Empty if the frame has no such camera.
Overlay field_overlay(const FrameRecord& frame, HeadCamera camera);

/// The perceived tiles and the belief of the view filter. Needs the topic room; empty if room awareness is off.
Overlay room_overlay(const FrameRecord& frame, HeadCamera camera);

// The parts, for images without a frame.

/// Each polyline in one color. `thickness`: in marks.
OverlayLayer polylines(std::string meaning, std::vector<std::vector<Eigen::Vector2d>> lines, Color color,
                       double thickness, const CameraModel& camera);

/// The field's lines, circle, arcs and marks as predicted for a camera at this pose.
OverlayLayer expected_lines(const FieldDimensions& field, const CameraModel& camera,
                            const Isometry3& field_from_camera);

/// Points on lines, each with a stroke across its line. The camera is at the believed pose of the detection.
OverlayLayer line_points(std::span<const LinePoint> points, const CameraModel& camera,
                         const Isometry3& robot_from_camera);

Overlay percept_overlay(const FieldPercept& percept, const CameraModel& camera, const Isometry3& robot_from_camera);

/// The tiles that project completely into the surroundings of the image, with their histograms. Tiles that do not count
/// are dashed and have no histogram.
OverlayLayer perceived_tiles(std::span<const PerceivedTile> perceived, const Wall& wall, const CameraModel& camera,
                             const Isometry3& field_from_camera);

}  // namespace reorient::scene
