// What a robot is: observations in, requests out. Behind it stand the simulator, a real NAO and recordings.
#pragma once

#include <optional>

#include "geometry/camera.h"
#include "geometry/head.h"
#include "geometry/image.h"
#include "geometry/pose2.h"

namespace reorient {

/// One frame's measurements. Everything in it was measured at `time`, or is the latest value before it.
struct Observation {
  double time = 0.0;            ///< s since the robot was switched on
  ImageView image;              ///< upper camera; valid until the next call of observe()
  CameraModel camera;           ///< as calibrated, at the image's resolution
  HeadAngles head;              ///< measured joint angles, rad
  TorsoAttitude torso;          ///< from the inertial unit, rad; beyond a quarter turn: the robot lies
  double hip_height = 0.24809;  ///< m above the ground, from the legs' kinematics
  Pose2 odometry;               ///< dead reckoning since the start: m, rad; only its change from frame to frame counts
  double foot_load = 5.3;       ///< kg on both feet's pressure sensors; near 0 while somebody carries the robot
  bool penalized = false;       ///< as told by the referee
};

/// Torso velocity: m/s forward and to the left, rad/s to the left.
struct WalkVelocity {
  double forward = 0.0;
  double left = 0.0;
  double turn = 0.0;
};

struct HeadRequest {
  HeadAngles angles;                   ///< wanted joint angles, rad; clamped to what the neck reaches
  double speed = from_degrees(120.0);  ///< rad/s, at most the motors' own limit
};

/// What the robot shall do until the next request. Without a head request the head stays where it is.
struct Request {
  std::optional<HeadRequest> head;
  WalkVelocity walk;    ///< zero: stand
  bool get_up = false;  ///< after a fall
};

/// Where a robot really is; only a simulator or a tracking camera knows.
struct GroundTruth {
  Pose2 pose;
  bool fallen = false;
  bool carried = false;
};

class Robot {
 public:
  virtual ~Robot() = default;

  virtual const RobotDimensions& dimensions() const = 0;

  /// Waits for the next frame and fills it in. False: there is none any more (end of a recording, robot gone).
  virtual bool observe(Observation& observation) = 0;

  virtual void request(const Request& request) = 0;

  /// Nothing on a real robot.
  virtual std::optional<GroundTruth> ground_truth() const { return std::nullopt; }
};

}  // namespace reorient
