// SPDX-License-Identifier: MIT
// External inputs of a client's frames, stored until a frame is used.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/pose2.h"
#include "robots/companion/frame_message.h"
#include "robots/robot.h"

namespace reorient {

/// Inputs that are sent once must not be lost with a frame that is superseded or unusable.
class PendingExternalInputs {
 public:
  /// Call after the hello of a client. If it is another process, drops an initial pose that the previous one sent.
  void begin_client(std::uint64_t client);
  /// The next frame defines the axes: no belief exists yet that half-time could rotate.
  void begin_axes() { is_other_half_.reset(); }

  /// Whether the frame contained an initial pose.
  bool add(const FrameMessage& message);
  /// Adds the inputs from a datagram of the GameController.
  void add(const ExternalInputs& game);

  /// Adds values of the application. The latest of each counts.
  void add(std::vector<SetValue> values);
  void add(ActionReport report);

  /// Returns the inputs for the frame that is used. Corrects an initial pose for the motion since it was set and for a
  /// change of the axes at half-time. Each frame contains its half, so that half-time is never lost.
  ExternalInputs take(const FrameMessage& message);

  /// The state that the next process continues from.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.is_other_half_, self.referee_, self.external_.half_time);
  }

 private:
  ExternalInputs external_;             ///< its half-time is from the GameController
  std::optional<Pose2> odometry_;       ///< the client's when the initial pose was set, if it was valid
  bool is_pose_of_other_half_ = false;  ///< axes of the initial pose
  std::optional<bool> is_other_half_;   ///< axes of the previous frame of this client
  std::uint64_t client_ = 0;
  RefereeState referee_;  ///< the last one, from frames or the GameController
};

}  // namespace reorient
