// SPDX-License-Identifier: MIT
// A robot on the field whose measured angles are wrong: what its camera sees of lines, landmarks and posts, placed on
// the ground as the robot takes its camera to look.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/camera.h"
#include "geometry/camera_bias.h"
#include "geometry/field_dimensions.h"
#include "geometry/head.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "geometry/transform.h"
#include "perception/field/percepts.h"

namespace reorient {

class BiasedCamera {
 public:
  /// `truth`: by how much the measured angles are wrong. `pixel_noise`: standard deviation, pixels.
  BiasedCamera(const CameraBias& truth, double pixel_noise, std::uint64_t seed)
      : truth_(truth), pixel_noise_(pixel_noise), random_(seed, 3) {}

  /// What is measured of the camera's pose.
  static Isometry3 measured(const HeadAngles& head);
  /// The image of the upper camera as a robot sees it that corrects `known`.
  FieldPercept look(const Pose2& robot, const HeadAngles& head, const CameraBias& known);

  double false_points = 0.0;  ///< share of the line points that lie anywhere

 private:
  CameraBias truth_;
  double pixel_noise_;
  Random random_;
  FieldDimensions field_;
};

/// Head movement of a scanning robot, over near and far parts of the field.
HeadAngles scanning_head(double time);

}  // namespace reorient
