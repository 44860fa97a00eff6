// SPDX-License-Identifier: MIT
// The simulated body of a NAO behind LoLA: joints move to their targets at the speed of their motors; a standing robot
// whose legs become soft falls. Records invalid commands.
#pragma once

#include <cstdint>
#include <string>

#include "robots/nao/lola/command.h"
#include "robots/nao/lola/measurement.h"

namespace reorient::nao {

class TwinBody {
 public:
  TwinBody();

  /// Sets the command. Invalid are targets of a stiff joint that are out of its range or further from the previous
  /// target than its motor moves in a cycle, and a head against the shoulders.
  void take(const Command& command);
  /// A new client is connected: the first command starts from the present joint angles, not from earlier commands.
  void meet() { goes_on_ = false; }
  /// One cycle of 12 ms.
  void step();

  /// Returns a measurement with all keys fresh. The caller sets its time.
  Measurement measurement() const;
  const RobotIdentity& identity() const { return identity_; }

  /// Sets the head angles from outside.
  void set_head(float yaw, float pitch) {
    position_[kHeadYaw] = yaw;
    position_[kHeadPitch] = pitch;
  }

  // Events from outside.
  void push() { falling_ = true; }  ///< it falls on its face
  void pick_up_and_put_down();      ///< puts a lying robot on its feet; its joints stay soft
  /// The operator holds it tilted; (0, 0): upright.
  void tilt(float roll, float pitch) { held_roll_ = roll, held_pitch_ = pitch; }
  void press_chest(bool pressed) { chest_ = pressed; }
  void set_status(float status) { status_ = status; }
  void set_charge(float charge) { charge_ = charge; }
  void block(std::size_t joint) { blocked_ = joint; }  ///< kJoints: none

  bool is_soft() const;  ///< no joint is stiffer than a sitting robot's hips
  bool stands() const;
  bool sits() const;  ///< or crouches
  bool lies() const { return pitch_ > 1.2f; }
  int falls() const { return falls_; }
  /// The first invalid command; empty if all were valid.
  const std::string& complaint() const { return complaint_; }

 private:
  void complain(const char* what, std::size_t joint, float value);

  RobotIdentity identity_;
  JointValues position_{};
  Command command_;
  bool has_command_ = false, goes_on_ = false;
  std::uint64_t cycles_ = 0;
  float pitch_ = 0.0f;  // of the torso, rad
  float held_roll_ = 0.0f, held_pitch_ = 0.0f;
  bool falling_ = false;
  int falls_ = 0;
  bool chest_ = false;
  float status_ = 0.0f;
  float charge_ = 0.9f;
  std::size_t blocked_ = kJoints;
  std::string complaint_;
};

}  // namespace reorient::nao
