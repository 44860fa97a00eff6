// SPDX-License-Identifier: MIT
// The camera: a lens and an image. Camera frame: x along the optical axis, y left, z up, meters.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "geometry/lens.h"

namespace reorient {

/// Intrinsics of one camera at one resolution. Pixel (0, 0) is the center of the top left pixel, u right, v down.
struct CameraModel : Lens {
  int width = 640;                       ///< pixels
  int height = 480;                      ///< pixels
  Eigen::Vector2d focal{617.0, 616.0};   ///< (horizontal, vertical), pixels or, for other lenses, pixels per radian
  Eigen::Vector2d center{319.5, 239.5};  ///< principal point, pixels

  /// A pinhole without distortion with these fields of view (radians) and the principal point at the image center.
  static CameraModel from_fields_of_view(int width, int height, double horizontal, double vertical);
  /// A camera with this lens. The fields of view are measured through the image center, with the distortion of a
  /// fisheye and without the distortion of a pinhole.
  static CameraModel from_fields_of_view(int width, int height, double horizontal, double vertical, const Lens& lens);

  /// The same camera at another resolution with the same aspect ratio.
  CameraModel scaled_to(int new_width, int new_height) const;

  /// The pixel of a point in the camera frame. It may lie outside of the image. Empty if the lens cannot see the point
  /// because it is behind a pinhole, or so far off the axis that the distortion folds back.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_in_camera) const;

  /// The direction of a pixel in the camera frame. Its x is 1 for a pinhole (not of unit length). For the other lenses
  /// it has unit length and may point backward. It is finite for finite numbers, even if no direction projects to the
  /// pixel.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;

  bool contains(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 && pixel.y() < height - 0.5;
  }

  double horizontal_field_of_view() const;  ///< rad, along the row of the principal point

  bool operator==(const CameraModel&) const = default;

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive_width_and_lens(archive, self.width, self, self.is_plain());
    archive(self.height, self.focal, self.center, self.k1, self.k2);
  }
};

/// Whether the camera has an image, and all numbers are finite and, where necessary, positive.
bool is_usable(const CameraModel& camera);

/// The reason why the camera is impossible, in one line, or an empty string. Each pixel of the image must have its own
/// direction.
std::string mistake_in(const CameraModel& camera);

}  // namespace reorient
