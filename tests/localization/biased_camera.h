// SPDX-License-Identifier: MIT
// A robot on the field whose measured angles are wrong: its percepts of lines, landmarks and posts, projected to the
// ground with the camera pose that the robot assumes.
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
  /// `truth`: the true error of the measured angles. `pixel_noise`: standard deviation, pixels.
  BiasedCamera(const CameraBias& truth, double pixel_noise, std::uint64_t seed)
      : truth_(truth), pixel_noise_(pixel_noise), random_(seed, 3) {}

  /// The measured pose of the camera, without any correction.
  static Isometry3 measured(const HeadAngles& head);
  /// The percept of the upper camera, for a robot that corrects its camera's pose by `known`.
  FieldPercept look(const Pose2& robot, const HeadAngles& head, const CameraBias& known);

  double false_points = 0.0;  ///< fraction of the line points at random positions

 private:
  CameraBias truth_;
  double pixel_noise_;
  Random random_;
  FieldDimensions field_;
};

/// Head movement of a scanning robot, over near and far parts of the field.
HeadAngles scanning_head(double time);

}  // namespace reorient
