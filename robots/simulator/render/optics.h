// SPDX-License-Identifier: MIT
// Blurs the light by the lens and by motion during the exposure, before it reaches the sensor. Blur is given as an
// angle, so that images of all sizes are equally sharp.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "robots/simulator/render/framebuffer.h"

namespace reorient {

class Optics {
 public:
  /// `blur`: standard deviation of the lens's blur, rad; `exposure_time` in s. A step whose value is 0 is skipped.
  Optics(double blur, double exposure_time, const RayTable& rays);

  /// The light of `frame` as it reaches the sensor while the camera turns at `angular_velocity` (rad/s, in its own
  /// frame): `frame` itself, or an image that is valid until the next call. The motion is the same all over the image.
  const Frame& image(const Frame& frame, const Eigen::Vector3d& angular_velocity);

 private:
  void blur_by_lens(const Frame& from, Frame& to);
  void blur_by_motion(const Frame& from, const Eigen::Vector2d& motion, Frame& to);

  std::vector<float> kernel_;  // from the center outwards; empty: a sharp lens
  Eigen::Vector2d focal_;      // pixels
  double exposure_time_;
  std::optional<Frame> lens_, across_, motion_;
  /// A point on the path of a pixel's light while the camera moves.
  struct Tap {
    int column, row;   // relative to the pixel
    float here, next;  // weights of the pixel at that point and of its right neighbor
  };
  std::vector<Tap> taps_;
  std::vector<float> padded_;  // rows, extended beyond their ends
};

}  // namespace reorient
