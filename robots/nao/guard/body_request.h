// SPDX-License-Identifier: MIT
// Requests of the engine and of a walk to the guard, and the guard's report. Plain values in shared memory: each side
// checks the values of the others and uses only valid ones.
#pragma once

#include <array>
#include <cstdint>

#include "robots/nao/lola/command.h"
#include "robots/nao/lola/measurement.h"

namespace reorient::nao {

enum class WantedPosture : std::uint32_t { soft, sit, stand };

struct BodyRequest {
  double time = 0.0;  ///< s on the monotonic clock, when it was written
  WantedPosture posture = WantedPosture::soft;
  std::uint32_t moves_head = 0;                 ///< 0: the head does not move
  float head_yaw = 0.0f, head_pitch = 0.0f;     ///< rad
  float head_speed = 0.0f;                      ///< rad/s, limited to that of the motors
  float walk_forward = 0.0f, walk_left = 0.0f;  ///< m/s; for a walk, if one runs
  float walk_turn = 0.0f;                       ///< rad/s, to the left
  Lights lights;
};

/// Written in each cycle by a walk, a separate process that reads the measurements and the engine's request.
struct WalkTargets {
  double time = 0.0;               ///< s on the monotonic clock, when it was written
  std::uint32_t moves_joints = 0;  ///< while the guard stands, all joints but the head follow `joints`
  JointValues joints{};            ///< rad
  JointValues stiffness{};         ///< 0 to 1
  /// Odometry of the walk since its start: m forward and to the left, rad. Only changes between cycles are used, so it
  /// may restart; rotations come from the inertial unit.
  std::array<float, 3> odometry{};
};

/// What the guard does with the body.
enum class GuardState : std::uint32_t {
  waiting,  ///< waiting for LoLA
  soft,     ///< no stiffness
  standing_up,
  standing,
  sitting_down,
  sitting,
  fallen,  ///< soft, until a request for another posture than standing
};
inline constexpr int kGuardStates = 7;

/// Reasons why the guard does not carry out a request, one bit each.
enum GuardWarning : std::uint32_t {
  kNoRequest = 1u << 0,  ///< no request arrived for 100 ms
  kTilted = 1u << 1,     ///< tilted too far to stand up or sit down
  kHot = 1u << 2,        ///< a motor is hot
  kTooHot = 1u << 3,     ///< a motor is too hot; the robot sits down
  kBatteryLow = 1u << 4,
  kBatteryEmpty = 1u << 5,  ///< the robot sits down
  kJointStuck = 1u << 6,    ///< a joint does not reach its target
  kJointGivenUp = 1u << 7,  ///< a leg joint was stuck for too long; the robot sits down
  kBlind = 1u << 8,         ///< LoLA's packets contain no positions or angles
  kForeignBody = 1u << 9,   ///< not version 6: limits and postures do not apply to this robot
  /// It stands up only after a request for another posture, since no requests arrived for 1 s or the guard has started.
  kStandRefused = 1u << 10,
};

struct GuardReport {
  double time = 0.0;  ///< s on the monotonic clock
  GuardState state = GuardState::waiting;
  std::uint32_t warnings = 0;
  std::uint32_t joint = 0;  ///< joint of kHot, kTooHot, kJointStuck and kJointGivenUp
  std::uint32_t connections = 0;
  std::uint64_t cycles = 0;    ///< packets that arrived
  std::uint64_t late = 0;      ///< cycles whose answer was not written within 12 ms
  std::uint64_t unusable = 0;  ///< packets without positions or angles
};

}  // namespace reorient::nao
