// SPDX-License-Identifier: MIT
// From the ground to the camera: torso, neck and head of a humanoid whose neck has two joints. The defaults are the
// NAO v6, by Aldebaran's data sheet.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/angle.h"
#include "geometry/const_or.h"
#include "geometry/transform.h"

namespace reorient {

/// Joint angles of the head: yaw to the left, pitch downwards, rad.
struct HeadAngles {
  double yaw = 0.0;
  double pitch = 0.0;
};

template <typename Visit, ConstOr<HeadAngles> T>
void fields(Visit&& visit, T& head) {
  visit(head.yaw, head.pitch);
}

/// Attitude of the torso against gravity: roll about x (left side up), then pitch about y (downwards), rad.
struct TorsoAttitude {
  double roll = 0.0;
  double pitch = 0.0;
};

template <typename Visit, ConstOr<TorsoAttitude> T>
void fields(Visit&& visit, T& torso) {
  visit(torso.roll, torso.pitch);
}

/// Of the two in the head of a NAO: the upper one looks ahead, the lower one at the feet. A robot with one camera has
/// the upper one.
enum class HeadCamera { upper, lower };
constexpr int enum_count(HeadCamera) { return 2; }

/// Where a camera is in the head, whose origin is on the neck's second axis.
struct CameraMount {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
  double tilt = 0.0;                                   ///< rad, downwards
};
template <typename Visit, ConstOr<CameraMount> T>
void fields(Visit&& visit, T& mount) {
  visit(mount.position, mount.tilt);
}

/// Which joint sits on the torso, and which carries the head.
enum class NeckOrder { yaw_then_pitch, pitch_then_yaw };
constexpr int enum_count(NeckOrder) { return 2; }

/// Lengths in metres. The torso's origin is midway between a NAO's hip joints, and where its maker says for others.
struct RobotDimensions {
  double torso_height = 0.24809;  ///< standing straight; NAO: thigh 0.1 + tibia 0.1029 + ankle 0.04519
  NeckOrder neck_order = NeckOrder::yaw_then_pitch;
  Eigen::Vector3d first_axis{0.0, 0.0, 0.2115};        ///< of the neck, from the torso's origin
  Eigen::Vector3d second_axis{0.0, 0.0, 0.0};          ///< from the first one, in what turns about it
  CameraMount upper{{0.05871, 0.0, 0.06364}, 0.0209};  ///< 1.2 degrees
  CameraMount lower{{0.05071, 0.0, 0.01774}, 0.6929};  ///< 39.7 degrees
};
template <typename Visit, ConstOr<RobotDimensions> T>
void fields(Visit&& visit, T& dimensions) {
  visit(dimensions.torso_height, dimensions.neck_order, dimensions.first_axis, dimensions.second_axis, dimensions.upper,
        dimensions.lower);
}

/// How far up and down the head turns at one angle to the side, rad.
struct PitchLimit {
  double yaw = 0.0;  ///< to either side
  double min = 0.0;
  double max = 0.0;
};
template <typename Visit, ConstOr<PitchLimit> T>
void fields(Visit&& visit, T& limit) {
  visit(limit.yaw, limit.min, limit.max);
}

/// What the neck can reach.
struct NeckReach {
  double yaw = 119.5 * kPi / 180.0;  ///< rad, to either side
  /// By increasing yaw, linear in between, and as the outermost beyond; at least one.
  std::vector<PitchLimit> pitch{{0.0, -0.672, 0.515},   {0.486, -0.672, 0.422}, {0.756, -0.548, 0.370},
                                {0.903, -0.480, 0.330}, {1.090, -0.430, 0.300}, {1.527, -0.330, 0.200},
                                {2.086, -0.449, 0.330}};

  PitchLimit pitch_at(double angle) const;
  HeadAngles clamp(const HeadAngles& wanted) const;
};
template <typename Visit, ConstOr<NeckReach> T>
void fields(Visit&& visit, T& reach) {
  visit(reach.yaw, reach.pitch);
}

/// The camera in the robot frame (origin on the ground below the torso's origin, z against gravity, x forward).
Isometry3 robot_from_camera(const RobotDimensions& dimensions, const HeadAngles& head, const TorsoAttitude& torso,
                            double torso_height, HeadCamera camera = HeadCamera::upper);

}  // namespace reorient
