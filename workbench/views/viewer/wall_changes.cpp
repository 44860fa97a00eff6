// SPDX-License-Identifier: MIT
#include "workbench/views/viewer/wall_changes.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "workbench/views/scene/field_scene.h"

namespace reorient {
namespace {

std::vector<scene::Color> colors_of(const RoomRecord& room) {
  std::vector<scene::Color> colors;
  for (const scene::SceneLayer& layer : scene::wall_scene(room))
    for (const auto& tile : layer.shapes) colors.push_back(tile.fill);
  return colors;
}

bool differ(const scene::Color& some, const scene::Color& other) {
  return some.opacity != other.opacity || std::abs(some.red - other.red) >= WallChanges::kVisible ||
         std::abs(some.green - other.green) >= WallChanges::kVisible ||
         std::abs(some.blue - other.blue) >= WallChanges::kVisible;
}

}  // namespace

bool WallChanges::take(const RoomRecord& room, bool begins) {
  std::vector<scene::Color> now = colors_of(room);
  const bool is_same =
      std::equal(now.begin(), now.end(), sent_.begin(), sent_.end(),
                 [](const scene::Color& some, const scene::Color& other) { return !differ(some, other); });
  if (is_same && !begins) return false;
  sent_ = std::move(now);
  return true;
}

}  // namespace reorient
