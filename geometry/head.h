// SPDX-License-Identifier: MIT
// The camera's pose above the ground, from torso, neck and head of a humanoid whose neck has two joints. The defaults
// are those of the NAO v6 in Aldebaran's data sheet.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/angle.h"
#include "geometry/const_or.h"
#include "geometry/transform.h"

namespace reorient {

/// Joint angles of the head: yaw to the left, pitch down, rad.
struct HeadAngles {
  double yaw = 0.0;
  double pitch = 0.0;
};

template <typename Visit, ConstOr<HeadAngles> T>
void fields(Visit&& visit, T& head) {
  visit(head.yaw, head.pitch);
}

/// Attitude of the torso relative to gravity: roll about x (left side up), then pitch about y (down), rad.
struct TorsoAttitude {
  double roll = 0.0;
  double pitch = 0.0;
};

template <typename Visit, ConstOr<TorsoAttitude> T>
void fields(Visit&& visit, T& torso) {
  visit(torso.roll, torso.pitch);
}

/// The cameras in the head of a NAO: the upper one looks ahead, the lower one at the feet. The only camera of another
/// robot counts as the upper one.
enum class HeadCamera { upper, lower };
constexpr int enum_count(HeadCamera) { return 2; }

/// Pose of a camera in the head, whose origin is on the second axis of the neck.
struct CameraMount {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
  double tilt = 0.0;                                   ///< rad, down
};
template <typename Visit, ConstOr<CameraMount> T>
void fields(Visit&& visit, T& mount) {
  visit(mount.position, mount.tilt);
}

/// Which joint is mounted on the torso; the other one moves the head.
enum class NeckOrder { yaw_then_pitch, pitch_then_yaw };
constexpr int enum_count(NeckOrder) { return 2; }

/// Lengths in meters. The torso's origin is midway between the hip joints of a NAO, and as defined by the manufacturer
/// for other robots.
struct RobotDimensions {
  double torso_height = 0.24809;  ///< standing straight; NAO: thigh 0.1 + tibia 0.1029 + ankle 0.04519
  NeckOrder neck_order = NeckOrder::yaw_then_pitch;
  Eigen::Vector3d first_axis{0.0, 0.0, 0.2115};  ///< of the neck, relative to the torso's origin
  Eigen::Vector3d second_axis{0.0, 0.0, 0.0};    ///< relative to the first axis, in the part that rotates about it
  CameraMount upper{{0.05871, 0.0, 0.06364}, 0.0209};  ///< 1.2 degrees
  CameraMount lower{{0.05071, 0.0, 0.01774}, 0.6929};  ///< 39.7 degrees
};
template <typename Visit, ConstOr<RobotDimensions> T>
void fields(Visit&& visit, T& dimensions) {
  visit(dimensions.torso_height, dimensions.neck_order, dimensions.first_axis, dimensions.second_axis, dimensions.upper,
        dimensions.lower);
}

/// Pitch range of the head at one yaw, rad.
struct PitchLimit {
  double yaw = 0.0;  ///< to either side
  double min = 0.0;
  double max = 0.0;
};
template <typename Visit, ConstOr<PitchLimit> T>
void fields(Visit&& visit, T& limit) {
  visit(limit.yaw, limit.min, limit.max);
}

/// Limits of the neck.
struct NeckReach {
  double yaw = 119.5 * kPi / 180.0;  ///< rad, to either side
  /// Sorted by increasing yaw, with at least one entry. Linear interpolation in between; the outermost entry applies
  /// beyond.
  std::vector<PitchLimit> pitch{{0.0, -0.672, 0.515},   {0.486, -0.672, 0.422}, {0.756, -0.548, 0.370},
                                {0.903, -0.480, 0.330}, {1.090, -0.430, 0.300}, {1.527, -0.330, 0.200},
                                {2.086, -0.449, 0.330}};

  PitchLimit pitch_at(double angle) const;
  HeadAngles clamp(const HeadAngles& requested) const;
};
template <typename Visit, ConstOr<NeckReach> T>
void fields(Visit&& visit, T& reach) {
  visit(reach.yaw, reach.pitch);
}

/// The camera in the robot frame (origin on the ground below the torso's origin, z against gravity, x forward).
Isometry3 robot_from_camera(const RobotDimensions& dimensions, const HeadAngles& head, const TorsoAttitude& torso,
                            double torso_height, HeadCamera camera = HeadCamera::upper);

}  // namespace reorient
