// SPDX-License-Identifier: MIT
// Where the cameras of a frame show what a detector outside of the engine found.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "geometry/transform.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/ground_projection.h"
#include "perception/field/percepts.h"
#include "robots/external_percepts.h"

namespace reorient {

/// A camera of the frame. Poses are in the robot frame at the time of the frame.
struct DetectorCamera {
  CameraModel camera;
  Isometry3 measured = Isometry3::Identity();   ///< as the robot measured it
  Isometry3 corrected = Isometry3::Identity();  ///< the same without its bias
};
using DetectorCameras = std::array<std::optional<DetectorCamera>, 2>;  // upper and lower camera

/// A point of an external percept.
struct DetectedPoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m, on the ground
  Eigen::Vector2d pixel{-1.0, -1.0};                   ///< outside of the image: no camera shows it
  std::size_t camera = 0;                              ///< 0 upper, 1 lower
  const GroundProjection* view = nullptr;              ///< of this camera; nullptr: no camera shows the point
};

class DetectorViews {
 public:
  DetectorViews(const DetectorCameras& cameras, const FieldDimensions& field);

  /// Empty: no camera, above the horizon, or farther away than the field is long. `sent`: in this space; `height`: m
  /// above the ground, of a point in an image. A ground point in view of a camera counts as projected with the measured
  /// pose, so it is corrected for the bias of that camera; another one is used as it is.
  std::optional<DetectedPoint> point(PerceptSpace space, const Eigen::Vector2d& sent, double height = 0.0) const;
  /// m^2: as sent, or that of the engine's own percepts.
  Eigen::Matrix2d covariance(const ExternalPercept& percept, const DetectedPoint& seen,
                             const FieldFeatureParameters& features) const;
  /// rad, on the ground; empty if none was sent.
  std::optional<double> direction(const ExternalPercept& percept, const DetectedPoint& seen) const;
  /// The part of a camera's image that a robot or a person covers; empty if it is not in view.
  std::optional<Obstacle> box_in(const ExternalPercept& percept, std::size_t camera) const;

 private:
  std::optional<Obstacle> projected_box(const ExternalPercept& percept, std::size_t camera) const;
  std::optional<Obstacle> clipped(Obstacle box, const Eigen::Vector2d& least, const Eigen::Vector2d& most,
                                  std::size_t camera) const;

  double farthest_;  ///< m, on the field
  std::array<bool, 2> is_there_{};
  std::array<std::optional<GroundProjection>, 2> measured_, corrected_;  ///< both or none
};

}  // namespace reorient
