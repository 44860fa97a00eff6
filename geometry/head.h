// From the ground to the camera: torso, neck and head of a NAO. Dimensions: Aldebaran's data sheet for the NAO v6.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/angle.h"
#include "geometry/transform.h"

namespace reorient {

/// Joint angles of the head: yaw to the left, pitch downwards, rad.
struct HeadAngles {
  double yaw = 0.0;
  double pitch = 0.0;
};

template <typename Visit>
void fields(Visit&& visit, HeadAngles& head) {
  visit(head.yaw, head.pitch);
}

/// Attitude of the torso against gravity: roll about x (left side up), then pitch about y (downwards), rad.
struct TorsoAttitude {
  double roll = 0.0;
  double pitch = 0.0;
};

template <typename Visit>
void fields(Visit&& visit, TorsoAttitude& torso) {
  visit(torso.roll, torso.pitch);
}

/// Lengths in metres, angles in radians. The torso's origin is midway between the hip joints.
struct RobotDimensions {
  double hip_height = 0.24809;  ///< standing straight: thigh 0.1 + tibia 0.1029 + ankle 0.04519
  double neck_height = 0.2115;  ///< above the torso's origin
  Eigen::Vector3d camera_in_head{0.05871, 0.0, 0.06364};
  double camera_tilt = 0.0209;  ///< downwards, 1.2 degrees
  Eigen::Vector3d lower_camera_in_head{0.05071, 0.0, 0.01774};
  double lower_camera_tilt = 0.6929;  ///< 39.7 degrees
};

/// Of the two in the head: the upper one looks ahead, the lower one at the feet.
enum class HeadCamera { upper, lower };
constexpr int enum_count(HeadCamera) { return 2; }

template <typename Visit>
void fields(Visit&& visit, RobotDimensions& dimensions) {
  visit(dimensions.hip_height, dimensions.neck_height, dimensions.camera_in_head, dimensions.camera_tilt,
        dimensions.lower_camera_in_head, dimensions.lower_camera_tilt);
}

/// What the neck can reach, rad: |yaw| at most 119.5 degrees, the range of the pitch shrinks with |yaw|.
struct PitchRange {
  double min = 0.0;
  double max = 0.0;
};
inline constexpr double kHeadYawLimit = 119.5 * kPi / 180.0;
PitchRange head_pitch_range(double yaw);
HeadAngles clamp_to_reach(const HeadAngles& wanted);

/// The camera in the robot frame (origin on the ground below the torso's origin, z against gravity, x forward).
Isometry3 robot_from_camera(const RobotDimensions& dimensions, const HeadAngles& head, const TorsoAttitude& torso,
                            double hip_height, HeadCamera camera = HeadCamera::upper);

}  // namespace reorient
