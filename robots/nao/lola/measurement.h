// SPDX-License-Identifier: MIT
// The sensor values that a NAO's body sends in one cycle of LoLA.
#pragma once

#include <array>
#include <cstdint>

#include "robots/nao/lola/joints.h"

namespace reorient::nao {

/// The keys of LoLA's packets, and their bit positions in Measurement::fresh.
enum class SensorKey : std::uint8_t {
  position,
  stiffness,
  current,
  temperature,
  status,
  accelerometer,
  gyroscope,
  angles,
  sonar,
  fsr,
  touch,
  battery,
  robot_config,
};
inline constexpr int kSensorKeys = 13;

struct Measurement {
  double time = 0.0;        ///< s on the monotonic clock, when its packet had arrived
  std::uint32_t fresh = 0;  ///< a bit for each SensorKey with valid values in the packet; other values are unchanged

  JointValues position{};                ///< rad; hands: 0 closed, 1 open
  JointValues stiffness{};               ///< 0 to 1
  JointValues current{};                 ///< A
  JointValues temperature{};             ///< degrees Celsius
  JointValues status{};                  ///< 0 normal, 1 hot, 2 very hot, 3 critical
  std::array<float, 3> accelerometer{};  ///< m/s^2; (0, 0, -9.81) standing
  std::array<float, 3> gyroscope{};      ///< rad/s: rolling to the right, pitching forward, turning to the left
  std::array<float, 2> angles{};         ///< roll, pitch of the torso, rad; leaning forward is positive
  std::array<float, 2> sonar{};          ///< m
  std::array<float, 8> fsr{};            ///< kg: left then right foot, front left, front right, rear left, rear right
  std::array<float, 14> touch{};         ///< 0 or 1: see Touch
  std::array<float, 4> battery{};        ///< charge from 0 to 1, status, current (A), temperature

  std::uint32_t is_walked = 0;    ///< not from LoLA: `walked` is the odometry of a walk
  std::array<float, 3> walked{};  ///< m, m, rad since the walk started

  bool has(SensorKey key) const { return (fresh >> static_cast<unsigned>(key) & 1u) != 0; }
};

/// Indices in Measurement::touch.
enum Touch : std::size_t { kChest, kHeadFront, kHeadMiddle, kHeadRear };

/// LoLA's RobotConfig.
struct RobotIdentity {
  std::array<char, 32> body_id{}, body_version{}, head_id{}, head_version{};
};

}  // namespace reorient::nao
