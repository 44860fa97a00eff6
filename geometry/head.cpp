#include "geometry/head.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reorient {
namespace {

struct PitchLimit {
  double yaw;
  PitchRange pitch;
};

// Aldebaran's table of joint limits, anti-collision of head and shoulders; symmetric in yaw, linear between rows.
constexpr std::array<PitchLimit, 7> kPitchLimits{{
    {0.0, {-0.672, 0.515}},
    {0.486, {-0.672, 0.422}},
    {0.756, {-0.548, 0.370}},
    {0.903, {-0.480, 0.330}},
    {1.090, {-0.430, 0.300}},
    {1.527, {-0.330, 0.200}},
    {2.086, {-0.449, 0.330}},
}};

}  // namespace

PitchRange head_pitch_range(double yaw) {
  const double turned = std::min(std::abs(yaw), kPitchLimits.back().yaw);
  const auto upper = std::find_if(kPitchLimits.begin() + 1, kPitchLimits.end() - 1,
                                  [&](const PitchLimit& row) { return row.yaw >= turned; });
  const auto lower = upper - 1;
  const double share = (turned - lower->yaw) / (upper->yaw - lower->yaw);
  return {std::lerp(lower->pitch.min, upper->pitch.min, share), std::lerp(lower->pitch.max, upper->pitch.max, share)};
}

HeadAngles clamp_to_reach(const HeadAngles& wanted) {
  const double yaw = std::clamp(wanted.yaw, -kHeadYawLimit, kHeadYawLimit);
  const PitchRange range = head_pitch_range(yaw);
  return {yaw, std::clamp(wanted.pitch, range.min, range.max)};
}

Isometry3 robot_from_camera(const RobotDimensions& dimensions, const HeadAngles& head, const TorsoAttitude& torso,
                            double hip_height, HeadCamera camera) {
  const bool is_upper = camera == HeadCamera::upper;
  const Eigen::Matrix3d torso_turned = rotation_about_y(torso.pitch) * rotation_about_x(torso.roll);
  const Eigen::Matrix3d head_turned = torso_turned * rotation_about_z(head.yaw) * rotation_about_y(head.pitch);
  Isometry3 result = Isometry3::Identity();
  result.translation() = Eigen::Vector3d(0.0, 0.0, hip_height) +
                         torso_turned * Eigen::Vector3d(0.0, 0.0, dimensions.neck_height) +
                         head_turned * (is_upper ? dimensions.camera_in_head : dimensions.lower_camera_in_head);
  result.linear() = head_turned * rotation_about_y(is_upper ? dimensions.camera_tilt : dimensions.lower_camera_tilt);
  return result;
}

}  // namespace reorient
