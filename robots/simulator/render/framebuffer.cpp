#include "robots/simulator/render/framebuffer.h"

#include <algorithm>
#include <cmath>

namespace reorient {

RayTable::RayTable(const CameraModel& model)
    : camera(model), pixel_angle(static_cast<float>(1.0 / std::sqrt(model.focal.x() * model.focal.y()))) {
  const auto pixels = static_cast<std::size_t>(model.width) * static_cast<std::size_t>(model.height);
  left.reserve(pixels);
  up.reserve(pixels);
  length.reserve(pixels);
  for (int v = 0; v < model.height; ++v) {
    for (int u = 0; u < model.width; ++u) {
      const Eigen::Vector3d ray = model.ray({u, v});
      left.push_back(static_cast<float>(ray.y()));
      up.push_back(static_cast<float>(ray.z()));
      length.push_back(static_cast<float>(ray.norm()));
      most_left = std::max(most_left, left.back());
      most_right = std::max(most_right, -left.back());
      most_up = std::max(most_up, up.back());
      most_down = std::max(most_down, -up.back());
    }
  }
}

}  // namespace reorient
