// SPDX-License-Identifier: MIT
// The 25 joints of a NAO in LoLA's order, and the limits of its motors and its shell. Sources: data sheet of the NAO v6
// (joints, motors); B-Human 2024 and nao_lola (order).
#pragma once

#include <array>
#include <cstddef>

namespace reorient::nao {

enum Joint : std::size_t {
  kHeadYaw,
  kHeadPitch,
  kLeftShoulderPitch,
  kLeftShoulderRoll,
  kLeftElbowYaw,
  kLeftElbowRoll,
  kLeftWristYaw,
  kHipYawPitch,  // one motor turns both legs
  kLeftHipRoll,
  kLeftHipPitch,
  kLeftKneePitch,
  kLeftAnklePitch,
  kLeftAnkleRoll,
  kRightHipRoll,
  kRightHipPitch,
  kRightKneePitch,
  kRightAnklePitch,
  kRightAnkleRoll,
  kRightShoulderPitch,
  kRightShoulderRoll,
  kRightElbowYaw,
  kRightElbowRoll,
  kRightWristYaw,
  kLeftHand,
  kRightHand,
  kJoints
};

using JointValues = std::array<float, kJoints>;

struct JointLimits {
  float least, most;  ///< rad; hands: 0 closed, 1 open
  float speed;        ///< rad/s without load; hands: 1/s
};

inline constexpr std::array<JointLimits, kJoints> kJointLimits{{
    {-2.0857f, 2.0857f, 8.26f}, {-0.6720f, 0.5149f, 7.19f},  {-2.0857f, 2.0857f, 8.26f}, {-0.3142f, 1.3265f, 7.19f},
    {-2.0857f, 2.0857f, 8.26f}, {-1.5446f, -0.0349f, 7.19f}, {-1.8238f, 1.8238f, 24.6f}, {-1.1453f, 0.7408f, 4.16f},
    {-0.3794f, 0.7904f, 4.16f}, {-1.5358f, 0.4840f, 6.40f},  {-0.0923f, 2.1125f, 6.40f}, {-1.1895f, 0.9227f, 6.40f},
    {-0.3978f, 0.7690f, 4.16f}, {-0.7904f, 0.3794f, 4.16f},  {-1.5358f, 0.4840f, 6.40f}, {-0.1030f, 2.1201f, 6.40f},
    {-1.1864f, 0.9320f, 6.40f}, {-0.7689f, 0.3979f, 4.16f},  {-2.0857f, 2.0857f, 8.26f}, {-1.3265f, 0.3142f, 7.19f},
    {-2.0857f, 2.0857f, 8.26f}, {0.0349f, 1.5446f, 7.19f},   {-1.8238f, 1.8238f, 24.6f}, {0.0f, 1.0f, 8.33f},
    {0.0f, 1.0f, 8.33f},
}};

inline constexpr bool is_leg(std::size_t joint) { return joint >= kHipYawPitch && joint <= kRightAnkleRoll; }
inline constexpr bool is_head(std::size_t joint) { return joint <= kHeadPitch; }

/// Limits of the head's pitch at `yaw`, beyond which its shell touches the shoulders (table of the head's limits in the
/// data sheet, linear between its rows).
struct PitchRange {
  float least, most;
};
PitchRange head_pitch_range(float yaw);

}  // namespace reorient::nao
