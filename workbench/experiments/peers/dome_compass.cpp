// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/dome_compass.h"

#include <algorithm>

#include "workbench/experiments/peers/horizon.h"

namespace reorient {

DomeCompass::DomeCompass(const DomeCompassParameters& parameters)
    : TileCompass(TriangleDome(parameters.radius, parameters.cuts).tiles(), parameters.tiles),
      parameters_(parameters),
      dome_(parameters.radius, parameters.cuts),
      counts_(static_cast<std::size_t>(dome_.tiles())),
      in_view_(static_cast<std::size_t>(dome_.tiles())) {}

void DomeCompass::sample(const RoomObservation& view) {
  samples_.clear();
  const auto camera = camera_of(view);
  if (!camera) return;
  const Isometry3 field_from_camera = to_isometry(view.belief) * view.robot_from_camera;
  const Eigen::Vector3d eye = field_from_camera.translation();
  const int step = std::max(1, view.image.width / parameters_.samples);
  for (int y = step / 2; y < view.image.height; y += step) {
    for (int x = step / 2; x < view.image.width; x += step) {
      const Eigen::Vector3d pixel = camera->ray({static_cast<double>(x), static_cast<double>(y)});
      const auto hit = dome_.meet(eye, field_from_camera.linear() * pixel);
      if (!hit || hit->height < parameters_.bottom || is_covered(view, x, y)) continue;
      samples_.push_back({hit->tile, view.image.at(x, y)});
    }
  }
}

std::span<const SeenTile> DomeCompass::look(const RoomObservation& view) {
  sample(view);
  for (const Sample& sample : samples_) add_light(sample.color);
  const ColorThresholds now = next_thresholds(view.time);
  std::fill(counts_.begin(), counts_.end(), ColorCounts{});
  std::fill(in_view_.begin(), in_view_.end(), 0);
  for (const Sample& sample : samples_) {
    const auto tile = static_cast<std::size_t>(sample.tile);
    ++counts_[tile][static_cast<std::size_t>(color_bin(sample.color, now))];
    ++in_view_[tile];
  }
  seen_.clear();
  for (std::size_t tile = 0; tile < counts_.size(); ++tile) {
    if (in_view_[tile] >= parameters_.least_samples)
      seen_.push_back({static_cast<int>(tile), normalized(counts_[tile])});
  }
  return seen_;
}

}  // namespace reorient
