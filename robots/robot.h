// SPDX-License-Identifier: MIT
// What a robot is: observations in, answers out. Behind it stand the simulator, a real robot, a recording, or a team's
// own program that brings its own localization. Plain values of geometry only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/camera.h"
#include "geometry/const_or.h"
#include "geometry/head.h"
#include "geometry/image.h"
#include "geometry/pose2.h"
#include "robots/answer.h"
#include "robots/referee.h"

namespace reorient {

/// One camera's image, with all that was true when it was exposed.
struct CameraFrame {
  double time = 0.0;   ///< s since the robot was switched on, at the middle of the exposure
  ImageView image;     ///< valid until the next call of observe()
  CameraModel camera;  ///< as calibrated, at the image's resolution
  Pose2 odometry;      ///< dead reckoning at `time`: m, rad
  Isometry3 robot_from_camera = Isometry3::Identity();  ///< at `time`, as the joints and the attitude say
};

/// What the body felt at one instant.
struct BodySample {
  double time = 0.0;    ///< s since the robot was switched on; 0: that of the observation
  HeadAngles head;      ///< measured joint angles, rad
  TorsoAttitude torso;  ///< from the inertial unit, rad; beyond a quarter turn: the robot lies
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< of the torso, in its own frame, rad/s
  Eigen::Vector3d acceleration{0.0, 0.0, 9.81};  ///< of the torso against free fall, in its own frame, m/s^2
  double foot_load = 5.3;  ///< kg on both feet's pressure sensors; of no meaning where there are none
};
template <typename Visit, ConstOr<BodySample> T>
void fields(Visit&& visit, T& body) {
  visit(body.time, body.head, body.torso, body.angular_velocity, body.acceleration, body.foot_load);
}

/// What the robot's own software says of its posture, where it does.
enum class ReportedPosture { unknown, upright, falling, fallen, getting_up };
constexpr int enum_count(ReportedPosture) { return 5; }

/// The belief of a localization that is not ours: then ours rests, and reorientations go out as answers. Give either a
/// pose with its spread, or particles: then pose and spread are found among those. One that is not finite counts as
/// none.
struct ExternalBelief {
  struct Particle {
    Pose2 pose;
    double weight = 1.0;  ///< not negative, on any scale
  };
  template <typename Visit, ConstOr<Particle> T>
  friend void fields(Visit&& visit, T& particle) {
    visit(particle.pose, particle.weight);
  }

  Pose2 pose;                                            ///< field_from_robot
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< x, y, rotation; m^2, m rad, rad^2
  std::span<const Particle> particles;                   ///< may be empty; valid until the next call of observe()
};

/// A word from a team mate.
struct Message {
  int sender = 0;
  std::string text;  ///< at most kLongestMessage bytes; the rest is cut off
};
template <typename Visit, ConstOr<Message> T>
void fields(Visit&& visit, T& message) {
  visit(message.sender, message.text);
}
inline constexpr std::size_t kMostMessages = 32;  // taken in one frame
inline constexpr int kHighestPlayer = 1000;

/// Somebody says where the robot stands.
struct InitialPose {
  Pose2 pose;
  double position_deviation = 0.1;                ///< m, along each axis: of somebody who places a robot by eye
  double rotation_deviation = from_degrees(5.0);  ///< rad
};
template <typename Visit, ConstOr<InitialPose> T>
void fields(Visit&& visit, T& initial) {
  visit(initial.pose, initial.position_deviation, initial.rotation_deviation);
}

/// What was told, by whoever.
struct ExternalInputs {
  std::optional<InitialPose> initial_pose;
  std::optional<RefereeState> referee;  ///< holds until something else is told
  std::vector<Message> messages;
  bool half_time = false;          ///< the teams change sides now; what else is told with it is told in the new axes
  std::vector<std::string> notes;  ///< for whoever looks at the run later; at most kLongestNote bytes each
};
inline constexpr std::size_t kLongestNote = 1000;  // the rest is cut off
inline constexpr std::size_t kMostNotes = 32;      // taken in one frame
template <typename Visit, ConstOr<ExternalInputs> T>
void fields(Visit&& visit, T& external) {
  visit(external.initial_pose, external.referee, external.messages, external.half_time, external.notes);
}

/// What goes into one frame of the engine: an image of the upper camera with the newest of the lower one since the
/// frame before, or, where no upper one comes, one of the lower camera alone (robots/camera_pairing.h).
struct Observation {
  double time = 0.0;  ///< s since the robot was switched on; that of the newest image
  std::optional<CameraFrame> upper;
  std::optional<CameraFrame> lower;
  BodySample body;  ///< the latest at `time`
  std::span<const BodySample>
      body_samples;  ///< all since the frame before, the oldest first, where they come more often than images
  Pose2 odometry;    ///< dead reckoning since the start: m, rad; only its change from frame to frame counts
  ReportedPosture reported_posture = ReportedPosture::unknown;
  std::optional<ExternalBelief> belief;
  ExternalInputs external;  ///< what the robot's own software heard
};

class Robot {
 public:
  virtual ~Robot() = default;

  /// Waits for the next frame and fills it in. False: there is none any more (end of a recording, robot gone).
  virtual bool observe(Observation& observation) = 0;

  /// What came out of the frame that began with the last observation.
  virtual void answer(const Answer& answer) = 0;
};

}  // namespace reorient
