// SPDX-License-Identifier: MIT
#include "tests/robots/nao/twin/twin_body.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace reorient::nao {
namespace {

constexpr float kTick = 0.012f;     // s
constexpr float kWeight = 5.3f;     // kg
constexpr float kFallSpeed = 2.5f;  // rad/s
constexpr float kOnItsFace = 1.5f;  // rad
constexpr float kStiff = 0.1001f;   // more than a sitting robot's hips
constexpr float kKneesBent = 1.6f;  // rad, above which it rests on its calves

float knees(const JointValues& joints) { return std::min(joints[kLeftKneePitch], joints[kRightKneePitch]); }

}  // namespace

TwinBody::TwinBody() {
  const auto set = [](std::array<char, 32>& field, std::string_view text) {
    std::copy(text.begin(), text.end(), field.begin());
  };
  set(identity_.body_id, "P0000073A03S83I00011");
  set(identity_.body_version, "6.0.0");
  set(identity_.head_id, "P0000074A04S83I00012");
  set(identity_.head_version, "6.0.0");
  // It sits when it is switched on.
  for (const std::size_t knee : {kLeftKneePitch, kRightKneePitch}) position_[knee] = 2.09f;
  for (const std::size_t hip : {kLeftHipPitch, kRightHipPitch}) position_[hip] = -0.87f;
  for (const std::size_t ankle : {kLeftAnklePitch, kRightAnklePitch}) position_[ankle] = -1.17f;
  for (const std::size_t shoulder : {kLeftShoulderPitch, kRightShoulderPitch}) position_[shoulder] = 0.9f;
  position_[kLeftElbowRoll] = -0.5f;
  position_[kRightElbowRoll] = 0.5f;
  position_[kHeadPitch] = 0.2f;
}

void TwinBody::complain(const char* what, std::size_t joint, float value) {
  if (!complaint_.empty()) return;
  complaint_ = "cycle " + std::to_string(cycles_) + ", joint " + std::to_string(joint) + ": " + what + " (" +
               std::to_string(value) + ")";
}

void TwinBody::take(const Command& command) {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const float stiffness = command.stiffness[joint], to = command.position[joint];
    if (!std::isfinite(to) || !std::isfinite(stiffness)) complain("target or stiffness is not finite", joint, to);
    if (stiffness > 1.0f) complain("stiffness above 1", joint, stiffness);
    if (stiffness <= 0.0f) continue;
    const JointLimits& limits = kJointLimits[joint];
    constexpr float kRounding = 1e-4f;
    const bool continues = goes_on_ && command_.stiffness[joint] > 0.0f;
    const float from = continues ? command_.position[joint] : position_[joint];
    const float most = limits.speed * kTick + kRounding;
    if (std::fabs(to - from) > most) complain("target is too fast for the motor", joint, (to - from) / kTick);
    const float outside = std::max(limits.least - to, to - limits.most);
    if (outside > kRounding && outside > std::max(limits.least - from, from - limits.most) + kRounding)
      complain("target out of range", joint, to);
  }
  if (command.stiffness[kHeadPitch] > 0.0f) {
    const PitchRange range = head_pitch_range(command.position[kHeadYaw]);
    const float pitch = command.position[kHeadPitch], before = command_.position[kHeadPitch];
    const auto outside = [&range](float value) { return std::max(range.least - value, value - range.most); };
    constexpr float kSlack = 0.01f;
    if (goes_on_ && outside(pitch) > kSlack && outside(pitch) > outside(before) + kSlack)
      complain("the head touches the shoulders", kHeadPitch, pitch);
  }
  command_ = command;
  has_command_ = goes_on_ = true;
}

void TwinBody::step() {
  ++cycles_;
  if (has_command_) {
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      if (command_.stiffness[joint] < 0.05f || joint == blocked_) continue;
      const float most = kJointLimits[joint].speed * kTick;
      position_[joint] += std::clamp(command_.position[joint] - position_[joint], -most, most);
    }
  }
  float legs = 0.0f;
  for (std::size_t joint = kHipYawPitch; joint <= kRightAnkleRoll; ++joint)
    legs += has_command_ ? std::max(command_.stiffness[joint], 0.0f) : 0.0f;
  const bool holds = legs > 0.2f * 11.0f || knees(position_) > kKneesBent;
  if (!holds && !lies()) falling_ = true;
  if (falling_) {
    if (pitch_ <= 0.0f) ++falls_;
    pitch_ = std::min(pitch_ + kFallSpeed * kTick, kOnItsFace);
    if (pitch_ >= kOnItsFace) falling_ = false;
  }
}

void TwinBody::pick_up_and_put_down() {
  pitch_ = 0.0f;
  falling_ = false;
  // Folded when it is placed, because soft legs would not carry it.
  for (const std::size_t knee : {kLeftKneePitch, kRightKneePitch}) position_[knee] = 2.09f;
  for (const std::size_t hip : {kLeftHipPitch, kRightHipPitch}) position_[hip] = -0.87f;
  for (const std::size_t ankle : {kLeftAnklePitch, kRightAnklePitch}) position_[ankle] = -1.17f;
}

Measurement TwinBody::measurement() const {
  Measurement measurement;
  measurement.fresh = (1u << kSensorKeys) - 1;
  measurement.position = position_;
  measurement.temperature.fill(35.0f);
  measurement.status.fill(0.0f);
  measurement.status[kLeftKneePitch] = status_;
  if (has_command_) {
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      measurement.stiffness[joint] = std::max(command_.stiffness[joint], 0.0f);
  }
  const float roll = held_roll_, pitch = pitch_ + held_pitch_;
  constexpr float kGravity = 9.81f;
  measurement.angles = {roll, pitch};
  measurement.accelerometer = {kGravity * std::sin(pitch), -kGravity * std::sin(roll) * std::cos(pitch),
                               -kGravity * std::cos(roll) * std::cos(pitch)};
  if (falling_) measurement.gyroscope = {0.0f, kFallSpeed, 0.0f};
  measurement.fsr.fill(lies() || roll != 0.0f || held_pitch_ != 0.0f ? 0.0f : kWeight / 8.0f);
  measurement.touch[kChest] = chest_ ? 1.0f : 0.0f;
  measurement.battery = {charge_, -32552.0f, 0.016f, 3.6f};
  return measurement;
}

bool TwinBody::is_soft() const {
  return !has_command_ || std::all_of(command_.stiffness.begin() + kHipYawPitch, command_.stiffness.end(),
                                      [](float stiffness) { return stiffness < kStiff; });
}

bool TwinBody::stands() const { return !lies() && knees(position_) < 0.5f; }

bool TwinBody::sits() const { return !lies() && knees(position_) > kKneesBent; }

}  // namespace reorient::nao
