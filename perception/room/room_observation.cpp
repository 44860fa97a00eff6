// SPDX-License-Identifier: MIT
#include "perception/room/room_observation.h"

#include <cmath>

namespace reorient {

std::optional<CameraModel> camera_of(const RoomObservation& view) {
  const ImageView& image = view.image;
  const CameraModel& camera = view.camera;
  const bool sound = camera.width > 0 && camera.height > 0 && camera.focal.allFinite() && camera.center.allFinite() &&
                     camera.focal.minCoeff() > 1e-3 && camera.is_finite();
  const bool finite = view.belief.position.allFinite() && std::isfinite(view.belief.rotation) &&
                      view.robot_from_camera.matrix().allFinite();
  if (image.empty() || image.width < 2 || !sound || !finite) return std::nullopt;
  if (camera.width == image.width && camera.height == image.height) return camera;
  return camera.scaled_to(image.width, image.height);
}

}  // namespace reorient
