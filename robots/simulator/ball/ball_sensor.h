// SPDX-License-Identifier: MIT
// A detector of the ball with the errors of a real one: it measures the direction of the ball in the camera, so the
// distance becomes inexact far away, and it misses a ball that is far, hidden or out of view.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "geometry/camera.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "geometry/transform.h"

namespace reorient {

struct BallSensorParameters {
  double range = 5.0;
  double bearing_noise = 0.02;
  double elevation_noise = 0.008;
  double missed = 0.1;
};

template <typename Visit>
void describe(BallSensorParameters& p, Visit&& visit) {
  visit("range", p.range, 0.1, 50.0, "m", "largest distance at which the ball is detected");
  visit("bearing_noise", p.bearing_noise, 0.0, 0.5, "rad", "standard deviation of the measured direction of the ball");
  visit("elevation_noise", p.elevation_noise, 0.0, 0.2, "rad",
        "standard deviation of the measured angle of the ball below the horizon; the error of the distance grows with "
        "the square of the distance");
  visit("missed", p.missed, 0.0, 1.0, "", "fraction of the images in which a visible ball is not detected");
}

/// What can hide the ball: an upright cylinder.
struct Occluder {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m, on the field
  double radius = 0.12;                                ///< m
  double height = 0.55;                                ///< m
};

/// The ball and the cameras at one moment.
struct BallView {
  Eigen::Vector3d ball = Eigen::Vector3d::Zero();  ///< m, its center on the field
  Pose2 robot;                                     ///< true pose on the field
  std::span<const Isometry3> field_from_cameras;   ///< the first one that sees the ball measures it
  const CameraModel& camera;                       ///< of each
  std::span<const Occluder> occluders;
};

/// Whether the center of the ball is in the image of this camera and not hidden.
bool is_in_view(const BallView& view, const Isometry3& field_from_camera);

class BallSensor {
 public:
  BallSensor(const BallSensorParameters& parameters, std::uint64_t seed)
      : parameters_(parameters), random_(seed, kStream) {}

  /// The measured position of the ball relative to the robot, x forward, y left (m); nothing: not detected. Each call
  /// uses the same number of random numbers.
  std::optional<Eigen::Vector2d> measure(const BallView& view);

 private:
  static constexpr std::uint64_t kStream = 0xba115e;

  BallSensorParameters parameters_;
  Random random_;
};

}  // namespace reorient
