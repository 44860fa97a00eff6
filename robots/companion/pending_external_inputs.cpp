// SPDX-License-Identifier: MIT
#include "robots/companion/pending_external_inputs.h"

#include <algorithm>
#include <utility>

namespace reorient {

void PendingExternalInputs::begin_client(std::uint64_t client) {
  if (std::exchange(client_, client) == client) return;
  external_.initial_pose.reset();
  external_.values.clear();
  external_.reports.clear();
}

bool PendingExternalInputs::add(const FrameMessage& message) {
  const reorient_frame& frame = message.frame;
  if (message.has(REORIENT_HAS_REFEREE)) {
    referee_.penalized = frame.penalized != 0;
    external_.referee = referee_;
  }
  for (const Message& word : message.messages) {
    if (external_.messages.size() < kMostMessages) external_.messages.push_back(word);
  }
  if (!message.has(REORIENT_HAS_TOLD_POSE) || !is_initial_pose_valid(frame)) return false;
  external_.initial_pose = InitialPose{pose_of(frame.told_pose), frame.told_deviation[0], frame.told_deviation[1]};
  odometry_.reset();
  if (is_odometry_valid(frame)) odometry_ = pose_of(frame.odometry);
  is_pose_of_other_half_ = message.has(REORIENT_OTHER_HALF);
  return true;
}

void PendingExternalInputs::add(const ExternalInputs& game) {
  if (game.referee) external_.referee = referee_ = *game.referee;
  if (!game.half_time) return;
  external_.half_time = !external_.half_time;
  if (external_.initial_pose) external_.initial_pose->pose = reflect(external_.initial_pose->pose);
}

void PendingExternalInputs::add(std::vector<SetValue> values) {
  for (SetValue& value : values) {
    const auto known = std::find_if(external_.values.begin(), external_.values.end(),
                                    [&](const SetValue& other) { return other.value == value.value; });
    if (known != external_.values.end()) {
      *known = std::move(value);
    } else {
      external_.values.push_back(std::move(value));
    }
  }
}

void PendingExternalInputs::add(ActionReport report) {
  if (external_.reports.size() < kMostReports) external_.reports.push_back(std::move(report));
}

ExternalInputs PendingExternalInputs::take(const FrameMessage& message) {
  const bool is_other_half = message.has(REORIENT_OTHER_HALF);
  ExternalInputs external = std::exchange(external_, {});
  if (external.initial_pose) {
    Pose2& pose = external.initial_pose->pose;
    if (odometry_) pose = pose * (odometry_->inverse() * pose_of(message.frame.odometry));
    if (is_pose_of_other_half_ != is_other_half) pose = reflect(pose);
  }
  if (is_other_half != is_other_half_.value_or(is_other_half)) external.half_time = !external.half_time;
  is_other_half_ = is_other_half;
  return external;
}

}  // namespace reorient
