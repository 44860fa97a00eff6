// SPDX-License-Identifier: MIT
// External inputs of a client's frames, stored until a frame is used.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/pose2.h"
#include "robots/companion/frame_message.h"
#include "robots/robot.h"

namespace reorient {

/// Inputs that are sent once must not be lost with a frame that is superseded or unusable.
class PendingExternalInputs {
 public:
  /// This client has said hello. Where it is another process, the one before it was so sure of a pose that it told.
  void begin_client(std::uint64_t client);
  /// The next frame defines the axes: nothing is known yet that half-time could rotate.
  void begin_axes() { is_other_half_.reset(); }

  /// Whether the frame contained an initial pose.
  bool hear(const FrameMessage& message);
  /// What the GameController says.
  void hear(const ExternalInputs& game);

  /// With the frame that is looked at. The robot may have moved on since a pose was told, and the axes may be those of
  /// the other half by now. Each frame says in which half it is, so that half-time is lost with none.
  ExternalInputs take(const FrameMessage& message);

  /// What a process that takes this one's place has to know.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.is_other_half_, self.referee_, self.external_.half_time);
  }

 private:
  ExternalInputs external_;             ///< half-time: as the GameController says it
  std::optional<Pose2> odometry_;       ///< the client's where the pose was told, if it made sense
  bool is_pose_of_other_half_ = false;  ///< its axes
  std::optional<bool> is_other_half_;   ///< the axes of the frame before, of the same client
  std::uint64_t client_ = 0;
  RefereeState referee_;  ///< what was said last
};

}  // namespace reorient
