// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/horizon.h"

#include <algorithm>
#include <cmath>

namespace reorient {

bool is_covered(const RoomObservation& view, double x, double y) {
  return std::any_of(view.covered.begin(), view.covered.end(), [&](const CoveredArea& area) {
    return x >= area.left && x <= area.right && y >= area.top && y <= area.bottom;
  });
}

Wall bare_wall(double radius) {
  WallParameters parameters;
  parameters.radius = radius;
  return Wall(parameters);
}

std::optional<HorizonCamera> HorizonCamera::of(const RoomObservation& view, const Wall& wall) {
  const auto at_resolution = camera_of(view);
  if (!at_resolution) return std::nullopt;
  HorizonCamera camera(view, wall, *at_resolution);
  if (!wall.surrounds(camera.field_from_camera_.translation().head<2>())) return std::nullopt;
  return camera;
}

std::optional<double> HorizonCamera::row_at(double x, double slope) const {
  // How far above the wanted slope a pixel looks, per meter of the optical axis: nearly linear in the row.
  const auto excess = [&](double y) {
    const Eigen::Vector3d looks = direction(x, y);
    return looks.z() - slope * looks.head<2>().norm();
  };
  double low = 0.0, high = camera_.height - 1.0;
  double at_low = excess(low), at_high = excess(high);
  constexpr int kSteps = 4;
  for (int i = 0; i < kSteps && std::abs(at_high - at_low) > 1e-9; ++i) {
    const double next = high - at_high * (high - low) / (at_high - at_low);
    low = high;
    at_low = at_high;
    high = next;
    at_high = excess(high);
  }
  constexpr double kNear = 1e-3;
  return std::isfinite(high) && std::abs(at_high) < kNear ? std::optional(high) : std::nullopt;
}

void HorizonCamera::find(int count, std::vector<HorizonColumn>& columns) const {
  columns.clear();
  const Eigen::Vector2d eye = field_from_camera_.translation().head<2>();
  count = std::min(count, camera_.width);
  for (int i = 0; i < count; ++i) {
    HorizonColumn column;
    column.x = (2 * i + 1) * camera_.width / (2 * count);
    const std::optional<double> row = row_at(column.x, 0.0);
    if (!row) continue;
    column.row = *row;
    const std::optional<double> azimuth =
        wall_->azimuth_seen(eye, direction_of(direction(column.x, column.row).head<2>()));
    if (!azimuth) continue;
    column.azimuth = *azimuth;
    column.covered = is_covered(*view_, column.x, column.row);
    columns.push_back(column);
  }
}

int sector_of(double azimuth, int sectors) {
  const double turns = azimuth / (2.0 * kPi);
  const int sector = static_cast<int>(std::floor((turns - std::floor(turns)) * sectors));
  return std::min(sector, sectors - 1);
}

}  // namespace reorient
