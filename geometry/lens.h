// SPDX-License-Identifier: MIT
// Lens models: how the direction of a ray becomes a place in the image. Coefficients have OpenCV's order and meaning.
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
  equirectangular  ///< azimuth along the rows, elevation along the columns; the image may be a crop
};
constexpr int enum_count(CameraProjection) { return 3; }

/// "pinhole", "fisheye", "equirectangular".
std::string_view to_string(CameraProjection projection);
std::optional<CameraProjection> projection_named(std::string_view name);

/// The projection and its distortion, without the image. Directions are in the camera frame (x along the optical axis,
/// y left, z up), places are in units of the focal length from the principal point, (right, down).
struct Lens {
  CameraProjection projection = CameraProjection::pinhole;
  /// pinhole: r' = r (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6), r the tangent of the angle to the
  /// optical axis; fisheye: r' = a (1 + k1 a^2 + k2 a^4 + k3 a^6 + k4 a^8), a that angle in rad.
  double k1 = 0.0, k2 = 0.0, k3 = 0.0, k4 = 0.0, k5 = 0.0, k6 = 0.0;
  double p1 = 0.0, p2 = 0.0;  ///< tangential distortion; pinhole only

  /// A pinhole with k1 and k2 alone.
  bool is_plain() const {
    return projection == CameraProjection::pinhole && p1 == 0.0 && p2 == 0.0 && k3 == 0.0 && k4 == 0.0 && k5 == 0.0 &&
           k6 == 0.0;
  }
  /// Rays have x = 1; else they have unit length and may point backward.
  bool is_perspective() const { return projection == CameraProjection::pinhole; }
  bool is_finite() const;

  /// OpenCV's coefficients: none, 2 (k1, k2), 4 (and p1, p2), 5 (and k3) or 8 (and k4, k5, k6) for a pinhole; none or 4
  /// (k1 to k4) for a fisheye; none for an equirectangular image. Empty, or one line that says what was expected.
  std::string set_coefficients(std::span<const double> coefficients);

  /// All that the projection has: 8, 4 or 0. `count`: how many.
  std::array<double, 8> coefficients(std::size_t& count) const;

  /// Where a direction is seen; nothing where it is not: behind a pinhole, or beyond the angle at which the distortion
  /// folds back. Not for a plain lens: CameraModel has that.
  std::optional<Eigen::Vector2d> distort(const Eigen::Vector3d& direction) const;

  /// The direction that is seen at a place: x = 1 for a pinhole, else of unit length. Where no direction is seen, the
  /// nearest one that is, roughly. Not for a plain lens.
  Eigen::Vector3d undistort(const Eigen::Vector2d& place) const;

  /// The distance from the principal point at which an angle to the optical axis (rad) is seen, along a row or a
  /// column; the distortion of a pinhole does not count.
  double place_of_angle(double angle) const;
  double angle_at_place(double place) const;  ///< the inverse

  bool operator==(const Lens&) const = default;
};

/// Archives an image's width and all of a lens but k1 and k2. A `plain` lens is written as the width alone, which is
/// the layout from before there were other lenses: recordings, saved states and digests of plain cameras stay the same.
/// True: it is not plain, and what else the caller has may follow.
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
