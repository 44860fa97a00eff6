// SPDX-License-Identifier: MIT
// The camera: a lens in front of an image. Camera frame: x along the optical axis, y left, z up, meters.
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
  Eigen::Vector2d focal{617.0, 616.0};   ///< pixels, horizontal and vertical; of the other lenses: pixels per radian
  Eigen::Vector2d center{319.5, 239.5};  ///< principal point, pixels

  /// A pinhole without distortion from its fields of view (radians), with the principal point at the image center.
  static CameraModel from_fields_of_view(int width, int height, double horizontal, double vertical);
  /// A camera with this lens. The fields of view are those through the image center, with the distortion of a fisheye
  /// and without that of a pinhole.
  static CameraModel from_fields_of_view(int width, int height, double horizontal, double vertical, const Lens& lens);

  /// The same camera read out at another resolution of the same aspect.
  CameraModel scaled_to(int new_width, int new_height) const;

  /// The pixel of a point in the camera frame; nothing where the lens does not see the point: behind a pinhole, or so
  /// far off the axis that the distortion folds back. The pixel may lie outside of the image.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_in_camera) const;

  /// The direction in which a pixel looks, in the camera frame: with x = 1 for a pinhole (not of unit length), of unit
  /// length for the other lenses, which may look backward. Finite for finite numbers, also where no direction projects
  /// to the pixel.
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

/// Whether it has an image and all of its numbers are finite and positive where they have to be.
bool is_usable(const CameraModel& camera);

/// Why no camera can be like this, in one line; empty: one can. Each pixel of the image must have a direction of its
/// own.
std::string mistake_in(const CameraModel& camera);

}  // namespace reorient
