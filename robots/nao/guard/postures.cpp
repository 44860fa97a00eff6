// SPDX-License-Identifier: MIT
#include "robots/nao/guard/postures.h"

#include <algorithm>
#include <cmath>

namespace reorient::nao {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Leg {
  float hip_pitch, knee, ankle;
};
struct Arm {
  float shoulder_pitch, shoulder_roll, elbow_yaw, elbow_roll, wrist_yaw;  // of the left arm
};

constexpr JointValues posture(const Leg& leg, const Arm& arm) {
  JointValues values{};
  values[kLeftHipPitch] = values[kRightHipPitch] = leg.hip_pitch;
  values[kLeftKneePitch] = values[kRightKneePitch] = leg.knee;
  values[kLeftAnklePitch] = values[kRightAnklePitch] = leg.ankle;
  values[kLeftShoulderPitch] = values[kRightShoulderPitch] = arm.shoulder_pitch;
  values[kLeftShoulderRoll] = arm.shoulder_roll;
  values[kRightShoulderRoll] = -arm.shoulder_roll;
  values[kLeftElbowYaw] = arm.elbow_yaw;
  values[kRightElbowYaw] = -arm.elbow_yaw;
  values[kLeftElbowRoll] = arm.elbow_roll;
  values[kRightElbowRoll] = -arm.elbow_roll;
  values[kLeftWristYaw] = arm.wrist_yaw;
  values[kRightWristYaw] = -arm.wrist_yaw;
  return values;
}

constexpr Leg kBent{-0.855f, 2.11f, -1.18f};
constexpr JointValues kStanding = posture({-0.15f, 0.30f, -0.15f}, {1.5f, 0.15f, 0.0f, -0.10f, 0.0f});
constexpr JointValues kCrouching = posture(kBent, {0.712f, 0.164f, 0.080f, -0.045f, 0.0f});
constexpr JointValues kSitting = posture(kBent, {0.89f, 0.06f, 0.26f, -0.62f, -1.57f});

}  // namespace

const JointValues& standing_posture() { return kStanding; }
const JointValues& crouching_posture() { return kCrouching; }
const JointValues& sitting_posture() { return kSitting; }

Glide::Glide(const JointValues& from, const JointValues& to, double seconds)
    : from_(from), to_(to), share_(kCycle / std::max(seconds, kCycle)), done_(0.0) {}

JointValues Glide::step() {
  done_ = std::min(done_ + share_, 1.0);
  const auto weight = static_cast<float>(0.5 * (1.0 - std::cos(kPi * done_)));
  JointValues now{};
  for (std::size_t joint = 0; joint < kJoints; ++joint) now[joint] = std::lerp(from_[joint], to_[joint], weight);
  return now;
}

}  // namespace reorient::nao
