// SPDX-License-Identifier: MIT
// What a NAO's body says in one cycle of LoLA.
#pragma once

#include <array>
#include <cstdint>

#include "robots/nao/lola/joints.h"

namespace reorient::nao {

/// The keys of LoLA's packets, and their places in Measurement::fresh.
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
  double time = 0.0;  ///< s on the monotonic clock, when its packet had come
  std::uint32_t fresh =
      0;  ///< a bit for each SensorKey that the packet held in good order; the others are as they were

  JointValues position{};                ///< rad; hands: 0 closed, 1 open
  JointValues stiffness{};               ///< 0 to 1
  JointValues current{};                 ///< A
  JointValues temperature{};             ///< degrees Celsius
  JointValues status{};                  ///< 0 normal, 1 hot, 2 very hot, 3 critical
  std::array<float, 3> accelerometer{};  ///< m/s^2; (0, 0, -9.81) standing
  std::array<float, 3> gyroscope{};      ///< rad/s: falling to the right, over the toes, turning to the left
  std::array<float, 2> angles{};         ///< roll, pitch of the torso, rad; leaning forward is positive
  std::array<float, 2> sonar{};          ///< m
  std::array<float, 8> fsr{};            ///< kg: left then right foot, front left, front right, rear left, rear right
  std::array<float, 14> touch{};         ///< 0 or 1: see Touch
  std::array<float, 4> battery{};        ///< charge from 0 to 1, status, current (A), temperature

  std::uint32_t is_walked = 0;    ///< not LoLA's: a walk says where it is
  std::array<float, 3> walked{};  ///< m, m, rad since it began

  bool has(SensorKey key) const { return (fresh >> static_cast<unsigned>(key) & 1u) != 0; }
};

/// Places in Measurement::touch.
enum Touch : std::size_t { kChest, kHeadFront, kHeadMiddle, kHeadRear };

/// LoLA's RobotConfig.
struct RobotIdentity {
  std::array<char, 32> body_id{}, body_version{}, head_id{}, head_version{};
};

}  // namespace reorient::nao
