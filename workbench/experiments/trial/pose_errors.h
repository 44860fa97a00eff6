// SPDX-License-Identifier: MIT
// Errors of the belief in one trial: plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace reorient {

/// After a fall, in s since the robot stood again.
struct FallRecovery {
  std::optional<double> right_after;    ///< the belief was near the true pose and stayed near
  std::optional<double> located_after;  ///< the same of the true pose or its reflection
};
template <typename Visit, typename Recovery>
void visit_recovery(Visit&& visit, Recovery& recovery) {
  visit(recovery.right_after);
  visit(recovery.located_after);
}

/// Sums over frames in which the robot stood on its feet, and had done so for some seconds. A mirrored belief is
/// compared with the reflection of the true pose, and counted, because self-localization cannot distinguish the two.
struct PoseErrors {
  std::int64_t frames = 0;
  std::int64_t mirrored_frames = 0;
  double square_position = 0.0;  ///< m^2
  double square_rotation = 0.0;  ///< rad^2
  /// Of x, y and rotation together, by the belief's own covariance: 3 a frame on average if that is right.
  double normalized_square = 0.0;
  std::int64_t frames_within = 0;        ///< with an error within the 95 % region of the covariance
  std::optional<double> located_after;   ///< s since the trial's clock started: near the pose or its reflection
  std::vector<FallRecovery> recoveries;  ///< one for each fall
};
/// Visits all values except the recoveries, each with its name.
template <typename Visit, typename Errors>
void visit_named_errors(Visit&& visit, Errors& errors) {
  visit("pose_frames", errors.frames);
  visit("pose_mirrored_frames", errors.mirrored_frames);
  visit("pose_square_position", errors.square_position);
  visit("pose_square_rotation", errors.square_rotation);
  visit("pose_normalized_square", errors.normalized_square);
  visit("pose_frames_within", errors.frames_within);
  visit("pose_located_after", errors.located_after);
}

}  // namespace reorient
