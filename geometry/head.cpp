// SPDX-License-Identifier: MIT
#include "geometry/head.h"

#include <algorithm>
#include <cmath>

namespace reorient {

PitchLimit NeckReach::pitch_at(double angle) const {
  const double turned = std::min(std::abs(angle), pitch.back().yaw);
  const auto upper =
      std::find_if(pitch.begin(), pitch.end(), [&](const PitchLimit& limit) { return limit.yaw >= turned; });
  if (upper == pitch.begin() || upper == pitch.end()) return pitch.front();
  const auto lower = upper - 1;
  const double share = (turned - lower->yaw) / (upper->yaw - lower->yaw);
  return {turned, std::lerp(lower->min, upper->min, share), std::lerp(lower->max, upper->max, share)};
}

HeadAngles NeckReach::clamp(const HeadAngles& requested) const {
  const double turned = std::clamp(requested.yaw, -yaw, yaw);
  const PitchLimit limit = pitch_at(turned);
  return {turned, std::clamp(requested.pitch, limit.min, limit.max)};
}

Isometry3 robot_from_camera(const RobotDimensions& dimensions, const HeadAngles& head, const TorsoAttitude& torso,
                            double torso_height, HeadCamera camera) {
  const CameraMount& mount = camera == HeadCamera::upper ? dimensions.upper : dimensions.lower;
  const bool yaw_first = dimensions.neck_order == NeckOrder::yaw_then_pitch;
  const Eigen::Matrix3d yaw = rotation_about_z(head.yaw), pitch = rotation_about_y(head.pitch);
  const Eigen::Matrix3d torso_turned = rotation_about_y(torso.pitch) * rotation_about_x(torso.roll);
  const Eigen::Matrix3d neck_turned = torso_turned * (yaw_first ? yaw : pitch);
  const Eigen::Matrix3d head_turned = neck_turned * (yaw_first ? pitch : yaw);
  Isometry3 result = Isometry3::Identity();
  result.translation() = Eigen::Vector3d(0.0, 0.0, torso_height) + torso_turned * dimensions.first_axis +
                         neck_turned * dimensions.second_axis + head_turned * mount.position;
  result.linear() = head_turned * rotation_about_y(mount.tilt);
  return result;
}

}  // namespace reorient
