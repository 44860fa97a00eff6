// SPDX-License-Identifier: MIT
#include "perception/room/wall/wall_sketch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace reorient {
namespace {

/// Null for the portable instructions: without a sketch, each ray is computed exactly.
SketchingKernel* sketching_of(Instructions instructions) {
  if (instructions == Instructions::neon) return neon_sketching();
  if (instructions == Instructions::avx2) return avx2_sketching();
  return instructions == Instructions::sse4 ? sse4_sketching() : nullptr;
}

}  // namespace

std::optional<BandRays> BandRays::of(std::span<const Eigen::Vector3d> rays) {
  constexpr double kFarthest = 100.0;
  if (rays.size() != kBandCells + 1) return std::nullopt;
  BandRays band;
  for (std::size_t i = 0; i < band.y_.size(); ++i) {
    Eigen::Vector3d ray = rays[std::min(i, rays.size() - 1)];
    if (!(ray.x() > 0.0)) return std::nullopt;
    if (ray.x() != 1.0) ray /= ray.x();
    if (!(std::abs(ray.y()) < kFarthest && std::abs(ray.z()) < kFarthest)) return std::nullopt;
    band.y_[i] = static_cast<float>(ray.y());
    band.z_[i] = static_cast<float>(ray.z());
  }
  const auto [y_least, y_most] = std::minmax_element(band.y_.begin(), band.y_.end());
  const auto [z_least, z_most] = std::minmax_element(band.z_.begin(), band.z_.end());
  band.y_least_ = *y_least;
  band.y_most_ = *y_most;
  band.z_least_ = *z_least;
  band.z_most_ = *z_most;
  return band;
}

float BandRays::highest(float from, float by_y, float by_z) const {
  return from + std::max(by_y * y_least_, by_y * y_most_) + std::max(by_z * z_least_, by_z * z_most_);
}

WallSketch::WallSketch(Instructions instructions) : kernel_(sketching_of(instructions)) {}

void WallSketch::prepare(const Wall& wall, const Isometry3& field_from_camera) {
  // Near the wall, and if the camera looks up or down, small errors of a ray are large errors on the wall.
  constexpr double kFarthest = 0.9;     // fraction of the radius
  constexpr double kSteepest = 0.3;     // horizontal part of the camera's axis
  constexpr double kAngleError = 1e-5;  // rad, of a position on the wall; a few times the greatest error that was found
  constexpr double kRowError = 2e-6;    // fraction of the greatest height that is used
  const Eigen::Vector3d eye = field_from_camera.translation();
  const Eigen::Vector2d axis = field_from_camera.linear().col(0).head<2>();
  leave_blank();
  holds_ = kernel_ != nullptr && eye.head<2>().norm() < kFarthest * wall.radius() && axis.norm() > kSteepest;
  if (!holds_) return;
  const auto azimuth = wall.azimuth_seen(eye.head<2>(), direction_of(axis));
  holds_ = azimuth.has_value();
  if (!holds_) return;
  const Eigen::Matrix3d turn = rotation_about_z(-*azimuth);
  const Eigen::Matrix3d rotation = turn * field_from_camera.linear();
  const Eigen::Vector3d turned_eye = turn * eye;
  for (int i = 0; i < 9; ++i) camera_.rotation[i] = static_cast<float>(rotation(i / 3, i % 3));
  camera_.eye[0] = static_cast<float>(turned_eye.x());
  camera_.eye[1] = static_cast<float>(turned_eye.y());
  camera_.eye[2] = static_cast<float>(eye.z() - wall.bottom());
  camera_.radius = static_cast<float>(wall.radius());
  camera_.outside = camera_.eye[0] * camera_.eye[0] + camera_.eye[1] * camera_.eye[1] - camera_.radius * camera_.radius;
  camera_.first_column = static_cast<float>(wall.column_at(*azimuth));
  camera_.columns = static_cast<float>(wall.columns());
  camera_.rows = static_cast<float>(wall.rows());
  camera_.rows_per_meter = 1.0f / static_cast<float>(wall.row_height());
  camera_.column_error = static_cast<float>(kAngleError / wall.column_width());
  const double highest = 4.0 * wall.radius() + std::abs(eye.z()) + std::abs(wall.bottom());
  camera_.row_error = static_cast<float>(kRowError * highest / wall.row_height());
}

bool WallSketch::draw(const BandRays& rays) {
  if (!holds_) return true;
  constexpr float kRounding = 1e-4f;  // of a slope
  const float highest = rays.highest(camera_.rotation[6], camera_.rotation[7], camera_.rotation[8]);
  if (highest < -kRounding && camera_.eye[2] * camera_.rows_per_meter < -camera_.row_error) return false;
  kernel_(camera_, rays.y(), rays.z(), kBandCells + 1,
          {columns_.data(), rows_.data(), column_floors_.data(), row_floors_.data(), places_.data()});
  return true;
}

void WallSketch::leave_blank() {
  places_.fill(kUnsure);
  column_floors_.fill(kUnsure);
  row_floors_.fill(kUnsure);
}

std::optional<double> WallSketch::border(int ray, double width) const {
  const auto left = static_cast<std::size_t>(ray);
  const std::size_t right = left + 1;
  const auto column_step = static_cast<int>(column_floors_[right] - column_floors_[left]);
  const auto row_step = static_cast<int>(row_floors_[right] - row_floors_[left]);
  if (column_floors_[left] == kUnsure || column_floors_[right] == kUnsure) return std::nullopt;
  if (row_floors_[left] == kUnsure || row_floors_[right] == kUnsure) return std::nullopt;
  double to_border = 0.0;
  double across = 0.0;
  double error = 0.0;
  if (row_step == 0 && column_step != 0) {
    across = static_cast<double>(columns_[right]) - columns_[left];
    if (2.0 * std::abs(across) > camera_.columns) across -= std::copysign(camera_.columns, across);
    const int step = across > 0.0 ? 1 : -1;
    if (column_step != step && column_step != step - step * static_cast<int>(camera_.columns)) return std::nullopt;
    to_border = column_floors_[left] + (step > 0 ? 1 : 0) - columns_[left];
    error = camera_.column_error;
  } else if (column_step == 0 && std::abs(row_step) == 1) {
    across = static_cast<double>(rows_[right]) - rows_[left];
    to_border = std::max(row_floors_[left], row_floors_[right]) - rows_[left];
    error = camera_.row_error;
  }
  constexpr double kFarthest = 32.0;  // rows; views along the wall have far more and are not interpolated
  if (std::abs(across) < 16.0 * error || std::abs(across) > kFarthest || across == 0.0) return std::nullopt;
  const double place = to_border / across;
  const double pairs = 0.5 * (ray + place) * width;
  const double pairs_error = 0.5 * width * 4.0 * error / std::abs(across);
  if (std::abs(pairs - std::floor(pairs) - 0.5) <= pairs_error + 1e-9) return std::nullopt;
  return place;
}

}  // namespace reorient
