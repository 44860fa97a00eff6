// SPDX-License-Identifier: MIT
// Reads and checks the frames of a client.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "robots/companion/message.h"
#include "robots/companion/percept_message.h"
#include "robots/robot.h"

namespace reorient {

struct FrameMessage {
  reorient_frame frame{};
  std::vector<ExternalBelief::Particle> particles;
  std::vector<Message> messages;
  bool has_percepts = false;  ///< the client's detector has looked at the images
  PerceptMessage percepts;

  bool has(std::uint32_t what) const { return (frame.has & what) != 0; }
};

/// Throws BadMessage for a wrong size, too many particles, messages or percepts, or an unknown value of a field that is
/// a choice. `has_detector`: the hello permits percepts.
void read_frame(std::span<const std::byte> bytes, bool has_detector, FrameMessage& message);

/// Which numbers are invalid, and what is expected; empty if valid. An invalid frame is dropped, the client stays.
std::string error_in(const FrameMessage& message);

/// Checks of parts that are used even if the rest is invalid.
bool is_odometry_valid(const reorient_frame& frame);
bool is_initial_pose_valid(const reorient_frame& frame);

Pose2 pose_of(const double (&numbers)[3]);

/// Reads a sample. Throws BadMessage for a wrong size or unknown bits.
reorient_sample read_sample(std::span<const std::byte> bytes);
bool is_valid(const reorient_sample& sample);

/// The sensor values of the body in a frame or a sample, at `time` (s). Missing values are those of a standing robot.
BodySample body_sample(const reorient_frame& frame, double time);
BodySample body_sample(const reorient_sample& sample, double time);

}  // namespace reorient
