// SPDX-License-Identifier: MIT
// A frame as a client sends it, checked: whatever is in it afterwards can be used.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "robots/companion/message.h"
#include "robots/robot.h"

namespace reorient {

struct FrameMessage {
  reorient_frame frame{};
  std::vector<ExternalBelief::Particle> particles;
  std::vector<Message> messages;

  bool has(std::uint32_t what) const { return (frame.has & what) != 0; }
};

/// Throws BadMessage where it is none: its size, how many particles or messages there are, what is no posture.
void read_frame(std::span<const std::byte> bytes, FrameMessage& message);

/// Why its numbers make no sense, and what would; empty: they do. Such a frame is left out, and the client stays.
std::string nonsense_in(const FrameMessage& message);

/// Of a part that counts even where the rest makes no sense.
bool is_odometry_sound(const reorient_frame& frame);
bool is_told_pose_sound(const reorient_frame& frame);

Pose2 pose_of(const double (&numbers)[3]);

/// The same of a sample. Throws BadMessage where it is none.
reorient_sample read_sample(std::span<const std::byte> bytes);
bool is_sound(const reorient_sample& sample);

/// What a frame or a sample says of the body, at `time` (s); where it says nothing, as a robot that stands straight.
BodySample body_sample(const reorient_frame& frame, double time);
BodySample body_sample(const reorient_sample& sample, double time);

}  // namespace reorient
