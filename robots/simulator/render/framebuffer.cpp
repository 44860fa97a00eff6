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

void RayTable::turn_while_read(const RayTable& at_rest, const Eigen::Vector3d& angular_velocity, double readout_time) {
  const auto width = static_cast<std::size_t>(camera.width);
  float farthest = 0.0f;
  for (int v = 0; v < camera.height; ++v) {
    const double time = readout_time * ((v + 0.5) / camera.height - 0.5);
    const Eigen::Vector3f turn = (time * angular_velocity).cast<float>();
    const std::size_t first = static_cast<std::size_t>(v) * width;
    for (std::size_t i = first; i < first + width; ++i) {
      const float l = at_rest.left[i];
      const float u = at_rest.up[i];
      const float forward = 1.0f + turn.y() * u - turn.z() * l;
      left[i] = (l + turn.z() - turn.x() * u) / forward;
      up[i] = (u + turn.x() * l - turn.y()) / forward;
      length[i] = std::sqrt(1.0f + left[i] * left[i] + up[i] * up[i]);
      farthest = std::max({farthest, std::fabs(left[i] - l), std::fabs(up[i] - u)});
    }
  }
  most_left = at_rest.most_left + farthest;
  most_right = at_rest.most_right + farthest;
  most_up = at_rest.most_up + farthest;
  most_down = at_rest.most_down + farthest;
  constexpr float kDistorted = 1.25f;  // at the image's edges a ray's pixel moves faster than in its middle
  slack = kDistorted * farthest * static_cast<float>(camera.focal.maxCoeff());
}

}  // namespace reorient
