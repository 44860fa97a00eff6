// SPDX-License-Identifier: MIT
#include "geometry/camera.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

double distortion(const CameraModel& camera, double r2) { return 1.0 + r2 * (camera.k1 + r2 * camera.k2); }

/// Derivative of the distorted radius. Where it is not positive, two directions would have the same pixel.
double distortion_slope(const CameraModel& camera, double r2) {
  return 1.0 + r2 * (3.0 * camera.k1 + 5.0 * r2 * camera.k2);
}

}  // namespace

CameraModel CameraModel::from_fields_of_view(int width, int height, double horizontal, double vertical) {
  CameraModel camera;
  camera.width = width;
  camera.height = height;
  camera.focal = {0.5 * width / pinned::tan(0.5 * horizontal), 0.5 * height / pinned::tan(0.5 * vertical)};
  camera.center = {0.5 * width - 0.5, 0.5 * height - 0.5};
  return camera;
}

CameraModel CameraModel::from_fields_of_view(int width, int height, double horizontal, double vertical,
                                             const Lens& lens) {
  CameraModel camera = from_fields_of_view(width, height, horizontal, vertical);
  static_cast<Lens&>(camera) = lens;
  if (!lens.is_perspective())
    camera.focal = {0.5 * width / lens.place_of_angle(0.5 * horizontal),
                    0.5 * height / lens.place_of_angle(0.5 * vertical)};
  return camera;
}

CameraModel CameraModel::scaled_to(int new_width, int new_height) const {
  const Eigen::Vector2d scale(static_cast<double>(new_width) / width, static_cast<double>(new_height) / height);
  const Eigen::Vector2d half(0.5, 0.5);
  CameraModel scaled = *this;
  scaled.width = new_width;
  scaled.height = new_height;
  scaled.focal = focal.cwiseProduct(scale);
  scaled.center = (center + half).cwiseProduct(scale) - half;
  return scaled;
}

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& point_in_camera) const {
  if (!is_plain()) {
    const std::optional<Eigen::Vector2d> place = distort(point_in_camera);
    if (!place) return std::nullopt;
    return center + focal.cwiseProduct(*place);
  }
  constexpr double kNearest = 1e-6;  // m in front of the camera
  if (point_in_camera.x() < kNearest) return std::nullopt;
  const Eigen::Vector2d ideal(-point_in_camera.y() / point_in_camera.x(), -point_in_camera.z() / point_in_camera.x());
  const double r2 = ideal.squaredNorm();
  if (distortion_slope(*this, r2) <= 0.0) return std::nullopt;
  return center + focal.cwiseProduct(ideal * distortion(*this, r2));
}

/// Solves for the ideal radius as a multiple of the distorted one, which needs no square root. Halley's method triples
/// the right digits in each step. The lenses of real robots need one or two.
Eigen::Vector3d CameraModel::ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d distorted = (pixel - center).cwiseQuotient(focal);
  if (!is_plain()) return undistort(distorted);
  double multiple = 1.0;
  if (k1 != 0.0 || k2 != 0.0) {
    constexpr int kIterations = 8;
    constexpr double kSmallChange = 1e-3;  // the next one is a millionth of a pixel
    const double d2 = distorted.squaredNorm();
    multiple = std::max(0.2, 1.0 - k1 * d2);
    for (int i = 0; i < kIterations; ++i) {
      const double r2 = d2 * multiple * multiple;
      const double slope = distortion_slope(*this, r2);
      if (slope <= 0.1) break;
      const double excess = multiple * distortion(*this, r2) - 1.0;
      const double steep = slope * slope * multiple;
      const double bend = excess * r2 * (3.0 * k1 + 10.0 * k2 * r2);  // half of the second derivative, times multiple
      // The bound keeps the steps right for lenses that nearly fold back.
      const double change = excess * slope * multiple / (steep - std::clamp(bend, -0.5 * steep, 0.5 * steep));
      if (!std::isfinite(change)) break;
      multiple -= change;
      if (std::abs(change) < kSmallChange) break;
    }
  }
  return {1.0, -multiple * distorted.x(), -multiple * distorted.y()};
}

double CameraModel::horizontal_field_of_view() const {
  const Eigen::Vector3d left = ray({-0.5, center.y()});
  const Eigen::Vector3d right = ray({width - 0.5, center.y()});
  return pinned::atan2(left.y(), left.x()) - pinned::atan2(right.y(), right.x());
}

bool is_usable(const CameraModel& camera) {
  return camera.width > 0 && camera.height > 0 && camera.focal.allFinite() && camera.center.allFinite() &&
         camera.focal.minCoeff() > 0.0 && camera.is_finite();
}

std::string mistake_in(const CameraModel& camera) {
  if (!camera.is_finite()) return "expected finite distortion coefficients";
  if (!is_usable(camera)) return "expected a focal length above 0 and a finite principal point";
  constexpr int kSteps = 24;
  constexpr double kAgreement = 0.01;  // pixels
  for (int j = 0; j <= kSteps; ++j) {
    for (int i = 0; i <= kSteps; ++i) {
      const Eigen::Vector2d pixel(i * (camera.width - 1.0) / kSteps, j * (camera.height - 1.0) / kSteps);
      const Eigen::Vector3d ray = camera.ray(pixel);
      const auto again = camera.project(ray);
      if (again && (*again - pixel).norm() < kAgreement) continue;
      std::ostringstream why;
      why << "expected one direction for each pixel, found none for pixel (" << std::lround(pixel.x()) << ", "
          << std::lround(pixel.y()) << ") of " << camera.width << "x" << camera.height
          << ": the distortion folds back, or the field of view is too wide";
      return why.str();
    }
  }
  return {};
}

}  // namespace reorient
