// SPDX-License-Identifier: MIT
#include "robots/robot_body.h"

#include <cstddef>
#include <vector>

#include "geometry/bytes.h"
#include "geometry/checksum.h"

namespace reorient {

CameraModel camera_model(const CameraOptics& optics, int width, int height) {
  CameraModel camera = CameraModel::from_fields_of_view(width, height, optics.field_of_view_horizontal,
                                                        optics.field_of_view_vertical, optics);
  if (optics.center) {
    const Eigen::Vector2d scale(static_cast<double>(width) / optics.width, static_cast<double>(height) / optics.height);
    const Eigen::Vector2d half(0.5, 0.5);
    camera.center = (*optics.center + half).cwiseProduct(scale) - half;
  }
  return camera;
}

std::uint64_t digest_of(const RobotBody& body) {
  std::vector<std::byte> bytes;
  bytes.reserve(512);  // avoids a false warning of GCC 12 about an empty vector
  ByteWriter writer(bytes);
  writer(body);
  return checksum(bytes);
}

double standing_camera_height(const RobotBody& body) {
  return robot_from_camera(body.dimensions, {}, {}, body.dimensions.torso_height).translation().z();
}

}  // namespace reorient
