#include "robots/simulator/render/framebuffer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robots/simulator/render/wide.h"

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

REORIENT_WIDE void RayTable::turn_while_read(const RayTable& at_rest, const Eigen::Vector3d& angular_velocity,
                                             double readout_time) {
  std::array<float, kLanes> farthest_of{};
  for (int v = 0; v < camera.height; ++v) {
    const double time = readout_time * ((v + 0.5) / camera.height - 0.5);
    const Eigen::Vector3f turn = (time * angular_velocity).cast<float>();
    const float roll = turn.x(), pitch = turn.y(), yaw = turn.z();
    const std::size_t first = static_cast<std::size_t>(v) * static_cast<std::size_t>(camera.width);
    const float* __restrict left_at_rest = at_rest.left.data() + first;
    const float* __restrict up_at_rest = at_rest.up.data() + first;
    float* __restrict turned_left = left.data() + first;
    float* __restrict turned_up = up.data() + first;
    float* __restrict turned_length = length.data() + first;
    for (int i = 0; i < camera.width; ++i) {
      const float l = left_at_rest[i];
      const float u = up_at_rest[i];
      const float forward = 1.0f + pitch * u - yaw * l;
      turned_left[i] = (l + yaw - roll * u) / forward;
      turned_up[i] = (u + roll * l - pitch) / forward;
      turned_length[i] = std::sqrt(1.0f + turned_left[i] * turned_left[i] + turned_up[i] * turned_up[i]);
    }
    for (int i = 0; i < camera.width; i += kLanes) {
      const int start = std::min(i, camera.width - kLanes);  // some pixels twice
      for (int lane = 0; lane < kLanes; ++lane) {
        const float sideways = std::fabs(turned_left[start + lane] - left_at_rest[start + lane]);
        const float upwards = std::fabs(turned_up[start + lane] - up_at_rest[start + lane]);
        const float far = sideways > upwards ? sideways : upwards;
        float& farthest = farthest_of[static_cast<std::size_t>(lane)];
        farthest = far > farthest ? far : farthest;
      }
    }
  }
  const float farthest = *std::max_element(farthest_of.begin(), farthest_of.end());
  most_left = at_rest.most_left + farthest;
  most_right = at_rest.most_right + farthest;
  most_up = at_rest.most_up + farthest;
  most_down = at_rest.most_down + farthest;
  constexpr float kDistorted = 1.25f;  // at the image's edges a ray's pixel moves faster than in its middle
  slack = kDistorted * farthest * static_cast<float>(camera.focal.maxCoeff());
}

}  // namespace reorient
