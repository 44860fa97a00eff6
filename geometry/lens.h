// SPDX-License-Identifier: MIT
// Lens models: from the direction of a ray to its position in the image. Order and meaning of the coefficients as in
// OpenCV.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace reorient {

enum class CameraProjection {
  pinhole,         ///< perspective, with radial and tangential distortion: cv::projectPoints
  fisheye,         ///< equidistant (Kannala and Brandt, 2006): cv::fisheye::projectPoints
  equirectangular  ///< azimuth along the rows, elevation along the columns; crops are possible
};
constexpr int enum_count(CameraProjection) { return 3; }

/// "pinhole", "fisheye", "equirectangular".
std::string_view to_string(CameraProjection projection);
std::optional<CameraProjection> projection_named(std::string_view name);

/// The projection and its distortion, without the image. Directions are in the camera frame (x along the optical axis,
/// y left, z up). Positions are in units of the focal length from the principal point, (right, down).
struct Lens {
  CameraProjection projection = CameraProjection::pinhole;
  /// pinhole: r' = r (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6), r the tangent of the angle to the
  /// optical axis; fisheye: r' = a (1 + k1 a^2 + k2 a^4 + k3 a^6 + k4 a^8), a that angle in rad.
  double k1 = 0.0, k2 = 0.0, k3 = 0.0, k4 = 0.0, k5 = 0.0, k6 = 0.0;
  double p1 = 0.0, p2 = 0.0;  ///< tangential distortion; pinhole only

  /// A pinhole with only k1 and k2.
  bool is_plain() const {
    return projection == CameraProjection::pinhole && p1 == 0.0 && p2 == 0.0 && k3 == 0.0 && k4 == 0.0 && k5 == 0.0 &&
           k6 == 0.0;
  }
  /// Whether rays have x = 1. Otherwise they have unit length and may point backward.
  bool is_perspective() const { return projection == CameraProjection::pinhole; }
  bool is_finite() const;

  /// Sets OpenCV's coefficients: 0, 2 (k1, k2), 4 (and p1, p2), 5 (and k3) or 8 (and k4, k5, k6) for a pinhole, 0 or 4
  /// (k1 to k4) for a fisheye, 0 for an equirectangular image. Returns an empty string or an error in one line.
  std::string set_coefficients(std::span<const double> coefficients);

  /// All coefficients of the projection. `count` becomes their number: 8, 4 or 0.
  std::array<double, 8> coefficients(std::size_t& count) const;

  /// The position of a direction. Empty if it is behind a pinhole, or beyond the angle at which the distortion folds
  /// back. Not for a plain lens, which CameraModel handles.
  std::optional<Eigen::Vector2d> distort(const Eigen::Vector3d& direction) const;

  /// The direction of a position: x = 1 for a pinhole, unit length otherwise. If no direction has the position, roughly
  /// the nearest one that is visible. Not for a plain lens.
  Eigen::Vector3d undistort(const Eigen::Vector2d& place) const;

  /// The distance from the principal point, along a row or a column, for an angle to the optical axis (rad). The
  /// distortion of a pinhole is ignored.
  double place_of_angle(double angle) const;
  double angle_at_place(double place) const;  ///< the inverse

  bool operator==(const Lens&) const = default;
};

/// Archives an image's width and everything of a lens except k1 and k2. A `plain` lens is written as the width alone.
/// This is the layout from before other lenses existed, so recordings, saved states and digests of plain cameras are
/// unchanged. Returns true if the lens is not plain; then the caller may archive more.
template <typename Archive>
bool archive_width_and_lens(Archive& archive, auto& width, auto& lens, bool plain) {
  constexpr int kOtherLens = std::numeric_limits<int>::min();  // instead of the width
  int first = plain && width != kOtherLens ? width : kOtherLens;
  archive(first);
  if constexpr (Archive::kReads) static_cast<Lens&>(lens) = Lens();
  if (first != kOtherLens) {
    if constexpr (Archive::kReads) width = first;
    return false;
  }
  archive(width, lens.projection, lens.p1, lens.p2, lens.k3, lens.k4, lens.k5, lens.k6);
  return true;
}

}  // namespace reorient
