// SPDX-License-Identifier: MIT
// The body of a NAO as LoLA shows it: joints go where they are told as fast as their motors can; a robot whose legs go
// soft while it stands falls. Notes what no robot should be told.
#pragma once

#include <cstdint>
#include <string>

#include "robots/nao/lola/command.h"
#include "robots/nao/lola/measurement.h"

namespace reorient::nao {

class TwinBody {
 public:
  TwinBody();

  /// What holds from now on. Noted: a stiff joint told to go further from one command to the next than its
  /// motor could in a cycle, out of its range, or the head against the shoulders.
  void take(const Command& command);
  /// A new client is connected: the first command starts from the present joint angles, not from earlier commands.
  void meet() { goes_on_ = false; }
  /// One cycle of 12 ms.
  void step();

  /// All keys fresh; the time is the caller's.
  Measurement measurement() const;
  const RobotIdentity& identity() const { return identity_; }

  /// Sets the head angles from outside.
  void set_head(float yaw, float pitch) {
    position_[kHeadYaw] = yaw;
    position_[kHeadPitch] = pitch;
  }

  /// What happens to it.
  void push() { falling_ = true; }  ///< it falls on its face
  void pick_up_and_put_down();      ///< one that lies, on its feet, as soft as it is
  void tilt(float roll, float pitch) {
    held_roll_ = roll, held_pitch_ = pitch;
  }  ///< in the operator's hands, or back to (0, 0)
  void press_chest(bool pressed) { chest_ = pressed; }
  void set_status(float status) { status_ = status; }
  void set_charge(float charge) { charge_ = charge; }
  void block(std::size_t joint) { blocked_ = joint; }  ///< kJoints: none

  bool is_soft() const;  ///< no joint is stiffer than a sitting robot's hips
  bool stands() const;
  bool sits() const;  ///< or crouches
  bool lies() const { return pitch_ > 1.2f; }
  int falls() const { return falls_; }
  /// The first thing that it should not have been told; empty: there was none.
  const std::string& complaint() const { return complaint_; }

 private:
  void complain(const char* what, std::size_t joint, float value);

  RobotIdentity identity_;
  JointValues position_{};
  Command command_;
  bool was_told_ = false, goes_on_ = false;
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
