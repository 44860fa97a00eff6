// SPDX-License-Identifier: MIT
#include "robots/companion/pending_told.h"

#include <utility>

namespace reorient {

void PendingTold::begin_client(std::uint64_t client) {
  if (std::exchange(client_, client) != client) told_.initial_pose.reset();
}

bool PendingTold::hear(const FrameMessage& message) {
  const reorient_frame& frame = message.frame;
  if (message.has(REORIENT_HAS_REFEREE)) {
    referee_.penalized = frame.penalized != 0;
    told_.referee = referee_;
  }
  for (const Message& word : message.messages) {
    if (told_.messages.size() < kMostMessages) told_.messages.push_back(word);
  }
  if (!message.has(REORIENT_HAS_TOLD_POSE) || !is_told_pose_sound(frame)) return false;
  told_.initial_pose = InitialPose{pose_of(frame.told_pose), frame.told_deviation[0], frame.told_deviation[1]};
  odometry_.reset();
  if (is_odometry_sound(frame)) odometry_ = pose_of(frame.odometry);
  is_pose_of_other_half_ = message.has(REORIENT_OTHER_HALF);
  return true;
}

void PendingTold::hear(const Told& game) {
  if (game.referee) told_.referee = referee_ = *game.referee;
  if (!game.half_time) return;
  told_.half_time = !told_.half_time;
  if (told_.initial_pose) told_.initial_pose->pose = reflect(told_.initial_pose->pose);
}

Told PendingTold::take(const FrameMessage& message) {
  const bool is_other_half = message.has(REORIENT_OTHER_HALF);
  Told told = std::exchange(told_, {});
  if (told.initial_pose) {
    Pose2& pose = told.initial_pose->pose;
    if (odometry_) pose = pose * (odometry_->inverse() * pose_of(message.frame.odometry));
    if (is_pose_of_other_half_ != is_other_half) pose = reflect(pose);
  }
  if (is_other_half != is_other_half_.value_or(is_other_half)) told.half_time = !told.half_time;
  is_other_half_ = is_other_half;
  return told;
}

}  // namespace reorient
