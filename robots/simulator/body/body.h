// SPDX-License-Identifier: MIT
// The simulated robot's body: a kinematic walk and a head with limits, a torso that sways, and the sensors that measure
// their motion. It can fall, get up, and be lifted and placed by the operator.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "geometry/head.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "robots/operator.h"
#include "robots/robot.h"
#include "robots/robot_body.h"
#include "robots/simulator/body/barrier.h"

namespace reorient {

struct BodyParameters {
  double forward_limit = 0.25;
  double left_limit = 0.15;
  double turn_limit = 0.8;
  double acceleration = 0.35;
  double turn_acceleration = 1.6;
  double head_speed_limit = 8.0;
  double step_frequency = 1.9;
  double sway_roll = 0.035;
  double sway_pitch = 0.015;
  double sway_height = 0.006;
  double odometry_scale_error = 0.04;
  double odometry_turn_bias = 0.04;
  double odometry_noise = 0.06;
  double head_noise = 0.002;
  double attitude_noise = 0.004;
  double attitude_bias = 0.004;
  double roll_offset = 0.0;
  double pitch_offset = 0.0;
  double fall_time = 0.8;
  double get_up_time = 6.0;
  double get_up_slip = 0.35;
  double carry_height = 0.6;
  double lower_time = 0.6;
  bool foot_sensors = true;
  double gyroscope_noise = 0.01;
  double accelerometer_noise = 0.15;
  double accelerometer_bias = 0.1;
  double step_shock = 0.8;
};

template <typename Visit>
void describe(BodyParameters& p, Visit&& visit) {
  visit("forward_limit", p.forward_limit, 0.0, 1.0, "m/s", "highest walking speed forward and backward");
  visit("left_limit", p.left_limit, 0.0, 1.0, "m/s", "highest walking speed to the sides");
  visit("turn_limit", p.turn_limit, 0.0, 3.0, "rad/s", "highest turning speed of the walk");
  visit("acceleration", p.acceleration, 0.05, 5.0, "m/s^2", "highest rate of change of the walking velocity");
  visit("turn_acceleration", p.turn_acceleration, 0.1, 20.0, "rad/s^2",
        "highest rate of change of the turning velocity");
  visit("head_speed_limit", p.head_speed_limit, 0.1, 20.0, "rad/s", "highest speed of the head's joints");
  visit("step_frequency", p.step_frequency, 0.5, 5.0, "Hz", "double steps per second of the walk");
  visit("sway_roll", p.sway_roll, 0.0, 0.3, "rad", "amplitude of the torso's roll at full walking speed");
  visit("sway_pitch", p.sway_pitch, 0.0, 0.3, "rad", "amplitude of the torso's pitch at full walking speed");
  visit("sway_height", p.sway_height, 0.0, 0.05, "m", "amplitude of the torso's height at full walking speed");
  visit("odometry_scale_error", p.odometry_scale_error, 0.0, 0.5, "",
        "standard deviation of the constant scale errors of the robot's odometry");
  visit("odometry_turn_bias", p.odometry_turn_bias, 0.0, 0.5, "rad/m",
        "standard deviation of the constant rotation drift of the robot's odometry for each meter");
  visit("odometry_noise", p.odometry_noise, 0.0, 0.5, "m^0.5",
        "standard deviation of the odometry's random error after 1 m, and after 1 rad in rad");
  visit("head_noise", p.head_noise, 0.0, 0.1, "rad", "standard deviation of the measured head angles");
  visit("attitude_noise", p.attitude_noise, 0.0, 0.1, "rad", "standard deviation of the measured torso attitude");
  visit("attitude_bias", p.attitude_bias, 0.0, 0.1, "rad", "standard deviation of the robot's constant attitude error");
  visit("roll_offset", p.roll_offset, -0.2, 0.2, "rad",
        "constant error that the inertial unit adds to the roll, besides the random bias");
  visit("pitch_offset", p.pitch_offset, -0.2, 0.2, "rad",
        "constant error that the inertial unit adds to the pitch, besides the random bias");
  visit("fall_time", p.fall_time, 0.1, 5.0, "s", "duration of a fall, from upright to lying");
  visit("get_up_time", p.get_up_time, 0.5, 30.0, "s", "duration of getting up, from lying to standing");
  visit("get_up_slip", p.get_up_slip, 0.0, 3.2, "rad",
        "standard deviation of the rotation while getting up, which the odometry does not measure");
  visit("carry_height", p.carry_height, 0.0, 1.5, "m", "mean height at which the operator holds a lifted robot");
  visit("lower_time", p.lower_time, 0.0, 5.0, "s", "mean time in which the operator lowers the robot to the ground");
  visit("foot_sensors", p.foot_sensors, "whether the feet have pressure sensors");
  visit("gyroscope_noise", p.gyroscope_noise, 0.0, 1.0, "rad/s",
        "standard deviation of the measured angular velocities");
  visit("accelerometer_noise", p.accelerometer_noise, 0.0, 10.0, "m/s^2",
        "standard deviation of the measured accelerations");
  visit("accelerometer_bias", p.accelerometer_bias, 0.0, 2.0, "m/s^2",
        "standard deviation of the robot's constant errors of the measured accelerations");
  visit("step_shock", p.step_shock, 0.0, 20.0, "m/s^2",
        "standard deviation of the accelerations that steps at full walking speed add");
}

/// The defaults, with the values that a body's file sets.
BodyParameters body_parameters_of(const RobotBody& body);

class Body {
 public:
  enum class Posture { upright, falling, lying, getting_up, carried };

  /// `robot`: the true body, with the errors that its calibration does not contain.
  Body(const BodyParameters& parameters, const RobotBody& robot, const Pose2& start, std::uint64_t seed);

  /// Advances by `time_step` seconds. At a barrier the robot stops or slides along it. It stays within `bounds` (half
  /// sizes of the ground, m).
  void advance(double time_step, const Request& request, std::span<const Barrier> barriers,
               const Eigen::Vector2d& bounds);

  void pick_up();
  void put_down(const Pose2& where);
  void push_over();
  void penalize(bool penalized) { penalized_ = penalized; }

  /// The robot's measurements at `time`. Call it after each advance(), because accelerations are differences.
  BodySample sample(double time);
  const Pose2& odometry() const { return odometry_; }
  /// The camera's pose in the robot's frame, as the robot computes it from measured joints and its own `dimensions`.
  Isometry3 measured_camera(const RobotDimensions& dimensions, const BodySample& body,
                            HeadCamera camera = HeadCamera::upper) const;

  GroundTruth ground_truth() const;
  Posture posture() const { return posture_; }
  bool is_penalized() const { return penalized_; }
  const Pose2& pose() const { return pose_; }
  const HeadAngles& head() const { return head_; }
  const TorsoAttitude& torso() const { return torso_; }
  double torso_height() const { return torso_height_; }  ///< m above the ground
  const WalkVelocity& velocity() const { return velocity_; }
  double gait() const { return gait_; }  ///< rad, phase of the double step

  Isometry3 field_from_camera(HeadCamera camera = HeadCamera::upper) const;

  static constexpr double kRadius = 0.15;  ///< m, for collisions

 private:
  void move_head(double time_step, const Request& request);
  void walk(double time_step, const Request& request);
  void collide(std::span<const Barrier> barriers, const Eigen::Vector2d& bounds);
  void dead_reckon(const Pose2& step);
  void balance(double time_step, bool get_up);
  void stand_up_again();
  void set_down();
  void feel(double time_step);

  BodyParameters parameters_;
  RobotBody robot_;
  Random random_;

  Pose2 pose_;
  WalkVelocity velocity_;
  HeadAngles head_;
  TorsoAttitude torso_;
  double torso_height_;

  Posture posture_ = Posture::upright;
  double since_ = 0.0;  // s in this posture
  /// How the operator holds the robot, drawn at random for each lift.
  struct Hands {
    double height = 0.0;          // m
    double raise_time = 0.8;      // s
    double lower_time = 0.6;      // s
    double sway = 1.0;            // factor on the amplitudes
    double pace = 1.0;            // factor on the frequencies
    double lowered_since = -1.0;  // s in this posture at which lowering began; negative: not yet
    double held_at = 0.0;         // m, height at which lowering began
    double below = 0.0;           // m, how much lower than standing the torso was at the lift
    TorsoAttitude tilt;           // of the torso then
  };
  Hands hands_;
  bool penalized_ = false;
  TorsoAttitude lying_;  // attitude at the end of the fall
  double slip_ = 0.0;    // rad, rotation by the present get-up motion
  double gait_ = 0.0;    // rad, phase of the double step
  double effort_ = 0.0;  // fraction of full walking speed, smoothed; scales the sway

  Pose2 odometry_;
  Eigen::Vector3d odometry_scale_;  // forward, left, turn
  double odometry_drift_;           // rad/m
  TorsoAttitude attitude_bias_;
  Eigen::Vector3d accelerometer_bias_;

  // The previous step, for the inertial unit; empty after the operator placed the body.
  struct Moment {
    Eigen::Vector3d torso_origin;  // m, in the field's frame
    TorsoAttitude torso;
    double heading = 0.0;
  };
  std::optional<Moment> last_moment_;
  std::optional<Eigen::Vector3d> last_velocity_;                // m/s, in the field's frame
  Eigen::Vector3d acceleration_ = Eigen::Vector3d::Zero();      // m/s^2, in the field's frame
  Eigen::Vector3d angular_velocity_ = Eigen::Vector3d::Zero();  // rad/s, in the torso's frame
};

}  // namespace reorient
