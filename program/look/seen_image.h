// SPDX-License-Identifier: MIT
// What the field vision and the virtual wall see in one image.
#pragma once

#include <optional>
#include <vector>

#include "engine/core_parameters.h"
#include "geometry/pose2.h"
#include "perception/field/percepts.h"
#include "perception/room/wall/perceived_tiles.h"
#include "perception/room/wall/wall.h"
#include "program/look/look_source.h"
#include "program/look/pitch_search.h"
#include "workbench/views/pictures/camera_view.h"

namespace reorient {

/// Source of the pitch.
enum class PitchSource { given, recorded, searched };

/// Settings of the user for all images, and the models to process them.
struct LookSetup {
  CoreParameters parameters;
  FieldDimensions field;
  double level_pitch = 0.0;      ///< rad, of the camera while the head looks straight ahead
  std::optional<double> pitch;   ///< rad
  std::optional<double> height;  ///< m
  Pose2 pose;                    ///< of the robot, if none was recorded
};

struct SeenImage {
  CameraModel camera;
  Isometry3 robot_from_camera = Isometry3::Identity();
  PitchSource pitch_source = PitchSource::given;
  PitchEstimate searched;       ///< if it was searched for; if unknown, the pitch of a level head is used
  double height = 0.0;          ///< m
  bool height_is_body = false;  ///< neither given nor recorded
  double horizon = 0.0;         ///< row at the image's center column; it may lie outside of the image
  Pose2 pose;                   ///< from which the wall is seen
  bool pose_is_recorded = false;
  bool shows_carpet = false;
  FieldPercept percept;
  Wall wall;
  std::vector<PerceivedTile> tiles;

  bool pitch_is_known() const { return pitch_source != PitchSource::searched || searched.known; }
};

/// Processes each image alone: nothing is learned from earlier images.
SeenImage see(const LookImage& image, const LookSetup& setup);

/// Valid as long as the image.
pictures::CameraView camera_view_of(const LookImage& image, const SeenImage& seen, const FieldDimensions& field);

}  // namespace reorient
