// SPDX-License-Identifier: MIT
#include "robots/simulator/render/framebuffer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/pinned_math.h"
#include "geometry/wide.h"

namespace reorient {
namespace {

/// Rotates one row of rays (of any x) by a small angle.
void turn_unit_rays(const RayTable& at_rest, int row, const Eigen::Vector3f& turn, RayTable& turned, float& farthest) {
  const auto width = static_cast<std::size_t>(at_rest.camera.width);
  for (std::size_t i = static_cast<std::size_t>(row) * width; i < static_cast<std::size_t>(row + 1) * width; ++i) {
    const Eigen::Vector3f ray = at_rest.direction(i);
    const Eigen::Vector3f moved = turn.cross(ray);
    turned.forward[i] = ray.x() + moved.x();
    turned.left[i] = ray.y() + moved.y();
    turned.up[i] = ray.z() + moved.z();
    turned.length[i] = std::sqrt(1.0f + moved.squaredNorm());  // moved is perpendicular to a unit vector
    farthest = std::max(farthest, moved.norm());
  }
}

}  // namespace

float angle_between(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return static_cast<float>(pinned::atan2(a.cross(b).norm(), a.dot(b)));
}

RayTable::RayTable(const CameraModel& model)
    : camera(model), pixel_angle(static_cast<float>(1.0 / std::sqrt(model.focal.x() * model.focal.y()))) {
  const auto pixels = static_cast<std::size_t>(model.width) * static_cast<std::size_t>(model.height);
  left.reserve(pixels);
  up.reserve(pixels);
  length.reserve(pixels);
  if (!model.is_perspective()) forward.reserve(pixels);
  for (int v = 0; v < model.height; ++v) {
    for (int u = 0; u < model.width; ++u) {
      const Eigen::Vector3d ray = model.ray({u, v});
      if (!model.is_perspective()) forward.push_back(static_cast<float>(ray.x()));
      left.push_back(static_cast<float>(ray.y()));
      up.push_back(static_cast<float>(ray.z()));
      length.push_back(static_cast<float>(ray.norm()));
      most_left = std::max(most_left, left.back());
      most_right = std::max(most_right, -left.back());
      most_up = std::max(most_up, up.back());
      most_down = std::max(most_down, -up.back());
    }
  }
  if (!model.is_plain()) make_blocks();
}

void RayTable::make_blocks() {
  constexpr int kSide = 16;  // pixels
  for (int top = 0; top < camera.height; top += kSide) {
    for (int first = 0; first < camera.width; first += kSide) {
      RayBlock block{first,
                     top,
                     std::min(first + kSide, camera.width) - 1,
                     std::min(top + kSide, camera.height) - 1,
                     Eigen::Vector3f::Zero(),
                     0.0f,
                     1.0f,
                     0.0f};
      const auto each = [&](auto&& visit) {
        for (int y = block.top; y <= block.bottom; ++y) {
          for (int x = block.left; x <= block.right; ++x) {
            const auto pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(x);
            visit(Eigen::Vector3f(direction(pixel) / length[pixel]));
          }
        }
      };
      each([&](const Eigen::Vector3f& ray) { block.axis += ray; });
      block.axis.normalize();
      each([&](const Eigen::Vector3f& ray) {
        block.half_angle = std::max(block.half_angle, angle_between(ray, block.axis));
      });
      block.half_angle += pixel_angle;  // a pixel also sees around its center
      const auto [sine, cosine] = pinned::sincos(block.half_angle);
      block.sine = static_cast<float>(sine);
      block.cosine = static_cast<float>(cosine);
      most_off_axis = std::max(most_off_axis, block.half_angle + angle_between(block.axis, Eigen::Vector3f::UnitX()));
      blocks.push_back(block);
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
    if (!at_rest.is_perspective()) {
      turn_unit_rays(at_rest, v, turn, *this, farthest_of.front());
      continue;
    }
    float* __restrict turned_left = left.data() + first;
    float* __restrict turned_up = up.data() + first;
    float* __restrict turned_length = length.data() + first;
    for (int i = 0; i < camera.width; ++i) {
      const float l = left_at_rest[i];
      const float u = up_at_rest[i];
      const float ahead = 1.0f + pitch * u - yaw * l;
      turned_left[i] = (l + yaw - roll * u) / ahead;
      turned_up[i] = (u + roll * l - pitch) / ahead;
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
  constexpr float kDistorted = 1.25f;  // at the image's edges a ray's pixel moves faster than at the center
  slack = kDistorted * farthest * static_cast<float>(camera.focal.maxCoeff());
  angle_slack = kDistorted * farthest;
}

}  // namespace reorient
