// SPDX-License-Identifier: MIT
// The interface of a robot: it delivers observations and receives answers. Implementations are the simulator, a real
// robot, recordings, footage, and a team's own program, which may have its own localization. Uses only plain values of
// geometry.
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
#include "robots/application.h"
#include "robots/external_percepts.h"
#include "robots/referee.h"

namespace reorient {

/// One camera's image, with the measurements of the moment of its exposure.
struct CameraFrame {
  double time = 0.0;   ///< s since the robot was switched on, at the middle of the exposure
  ImageView image;     ///< valid until the next call of observe()
  CameraModel camera;  ///< calibrated, at the resolution of the image
  Pose2 odometry;      ///< dead reckoning at `time`: m, rad
  Isometry3 robot_from_camera = Isometry3::Identity();  ///< at `time`, computed from joint angles and attitude
};

/// Sensor values of the body at one instant.
struct BodySample {
  double time = 0.0;    ///< s since the robot was switched on; 0: the time of the observation
  HeadAngles head;      ///< measured joint angles, rad
  TorsoAttitude torso;  ///< from the inertial unit, rad; beyond 90 degrees: the robot lies
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< of the torso, in its own frame, rad/s
  Eigen::Vector3d acceleration{0.0, 0.0, 9.81};  ///< of the torso against free fall, in its own frame, m/s^2
  double foot_load = 5.3;  ///< kg on the pressure sensors of both feet; ignored if the body has none
};
template <typename Visit, ConstOr<BodySample> T>
void fields(Visit&& visit, T& body) {
  visit(body.time, body.head, body.torso, body.angular_velocity, body.acceleration, body.foot_load);
}

/// Posture as reported by the robot's own software; unknown if it reports none.
enum class ReportedPosture { unknown, upright, falling, fallen, getting_up };
constexpr int enum_count(ReportedPosture) { return 5; }

/// The belief of an external localization. Reorient's own localization is then inactive, and reorientations are sent as
/// answers. Set either a pose with its covariance, or particles, from which both are computed. A belief that is not
/// finite is ignored.
struct ExternalBelief {
  struct Particle {
    Pose2 pose;
    double weight = 1.0;  ///< non-negative, on any scale
  };
  template <typename Visit, ConstOr<Particle> T>
  friend void fields(Visit&& visit, T& particle) {
    visit(particle.pose, particle.weight);
  }

  Pose2 pose;                                            ///< field_from_robot
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< x, y, rotation; m^2, m rad, rad^2
  std::span<const Particle> particles;                   ///< may be empty; valid until the next call of observe()
};

/// A message from a teammate.
struct Message {
  int sender = 0;
  std::string text;  ///< truncated to kLongestMessage bytes
};
template <typename Visit, ConstOr<Message> T>
void fields(Visit&& visit, T& message) {
  visit(message.sender, message.text);
}
inline constexpr std::size_t kMostMessages = 32;  // per frame
inline constexpr int kHighestPlayer = 1000;

/// A pose that is set from outside, for example by the operator.
struct InitialPose {
  Pose2 pose;
  double position_deviation = 0.1;                ///< m, along each axis; default: an operator places a robot by eye
  double rotation_deviation = from_degrees(5.0);  ///< rad
};
template <typename Visit, ConstOr<InitialPose> T>
void fields(Visit&& visit, T& initial) {
  visit(initial.pose, initial.position_deviation, initial.rotation_deviation);
}

/// Inputs from outside: from the operator, the referee, teammates, the application or the robot's own software.
struct ExternalInputs {
  std::optional<InitialPose> initial_pose;
  std::optional<RefereeState> referee;  ///< valid until the next one
  std::vector<Message> messages;
  bool half_time = false;          ///< the teams change sides now; the other inputs of this frame are in the new axes
  std::vector<std::string> notes;  ///< for the records and recordings of the run; at most kLongestNote bytes each
  std::vector<SetValue> values;    ///< of the application
  std::vector<ActionReport> reports;  ///< of the application, about its actions
};
inline constexpr std::size_t kLongestNote = 1000;  // longer notes are truncated
inline constexpr std::size_t kMostNotes = 32;      // per frame
template <typename Visit, ConstOr<ExternalInputs> T>
void fields(Visit&& visit, T& external) {
  visit(external.initial_pose, external.referee, external.messages, external.half_time, external.notes, external.values,
        external.reports);
}

/// The input of one frame of the engine: an image of the upper camera with the newest image of the lower camera since
/// the previous frame, or an image of the lower camera alone if no upper image arrives (robots/camera_pairing.h).
struct Observation {
  double time = 0.0;  ///< s since the robot was switched on; time of the newest image
  std::optional<CameraFrame> upper;
  std::optional<CameraFrame> lower;
  BodySample body;  ///< the latest at `time`
  std::span<const BodySample>
      body_samples;  ///< all since the previous frame, the oldest first, if they are more frequent than images
  Pose2 odometry;    ///< dead reckoning since the start: m, rad; only its change from frame to frame is used
  ReportedPosture reported_posture = ReportedPosture::unknown;
  std::optional<ExternalBelief> belief;
  std::optional<ExternalPercepts> percepts;  ///< nothing: no detector looked at the images of this frame
  ExternalInputs external;                   ///< received by the robot's own software
};

class Robot {
 public:
  virtual ~Robot() = default;

  /// Waits for the next frame and fills it in. Returns false if no more frames follow (end of the run or input).
  virtual bool observe(Observation& observation) = 0;

  /// Receives the result of the frame that started with the last observation.
  virtual void answer(const Answer& answer) = 0;
};

}  // namespace reorient
