// The camera: a pinhole with radial distortion. Camera frame: x along the optical axis, y left, z up, metres.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace reorient {

/// Intrinsics of one camera at one resolution. Pixel (0, 0) is the centre of the top left pixel, u right, v down.
struct CameraModel {
  int width = 640;                       ///< pixels
  int height = 480;                      ///< pixels
  Eigen::Vector2d focal{617.0, 616.0};   ///< pixels, horizontal and vertical
  Eigen::Vector2d center{319.5, 239.5};  ///< principal point, pixels
  double k1 = 0.0;                       ///< radial distortion: r' = r (1 + k1 r^2 + k2 r^4), r in units of focal
  double k2 = 0.0;

  /// A camera without distortion from its fields of view (radians), with the principal point at the image centre.
  static CameraModel from_fields_of_view(int width, int height, double horizontal, double vertical);

  /// The same camera read out at another resolution of the same aspect.
  CameraModel scaled_to(int new_width, int new_height) const;

  /// The pixel of a point in the camera frame; nothing where the point is not in front of the camera, or so far
  /// off the axis that the distortion model folds back. The pixel may lie outside of the image.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_in_camera) const;

  /// The direction in which a pixel looks, in the camera frame, with x = 1 (not of unit length).
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;

  bool contains(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 && pixel.y() < height - 0.5;
  }

  double horizontal_field_of_view() const;  ///< rad, along the row of the principal point
};

template <typename Visit>
void fields(Visit&& visit, CameraModel& camera) {
  visit(camera.width, camera.height, camera.focal, camera.center, camera.k1, camera.k2);
}

}  // namespace reorient
