#include "robots/robot_body.h"

namespace reorient {

double standing_camera_height(const RobotBody& body) {
  return robot_from_camera(body.dimensions, {}, {}, body.dimensions.torso_height).translation().z();
}

}  // namespace reorient
