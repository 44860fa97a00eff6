// SPDX-License-Identifier: MIT
// Messages of Foxglove, with the schemas in foxglove_schemas.h. Its viewer, Lichtblick and others draw them without
// configuration. Frames: x forward, y left, z up, m, rad.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "geometry/pose2.h"
#include "geometry/transform.h"
#include "workbench/views/scene/shapes.h"
#include "workbench/views/viewer/foxglove_schemas.h"

namespace reorient::foxglove {

Json time(double seconds);
Json pose(const Pose2& pose);

/// Transformation between two frames.
Json transform(double seconds, std::string_view parent, std::string_view child, const Isometry3& motion);
Isometry3 on_the_ground(const Pose2& pose);
/// Rotation from Foxglove's camera frame (x right, y down, z forward) to ours (x forward, y left, z up).
Isometry3 camera_from_optical();

Json pose_in_frame(double seconds, std::string_view frame, const Pose2& where);
Json poses_in_frame(double seconds, std::string_view frame, std::span<const Pose2> poses);
Json camera_calibration(double seconds, std::string_view frame, const CameraModel& camera);
/// `data`: a JPEG.
Json compressed_image(double seconds, std::string_view frame, std::span<const std::byte> data);

enum class Level { debug = 1, info, warning, error };
Json log(double seconds, Level level, std::string_view name, std::string_view message, std::string_view file = "",
         int line = 0);

/// The scene as one entity, which remains until another entity with the same id replaces it.
Json scene_update(double seconds, std::string_view frame, std::string_view id, const scene::Scene& scene);

/// The overlay on an image. Foxglove draws no dashes: dashed lines are solid.
Json image_annotations(double seconds, const scene::Overlay& overlay);

}  // namespace reorient::foxglove
