// SPDX-License-Identifier: MIT
// One frame for corner landmarks: the corners above the horizon, and the projection of points of the room.
#pragma once

#include <optional>
#include <vector>

#include "perception/room/room_observation.h"
#include "workbench/experiments/peers/corner_features.h"

namespace reorient {

/// A corner, seen from the believed pose.
struct SeenCorner {
  Eigen::Vector3d ray;  ///< line of sight, field frame, of length 1
  CornerDescriptor descriptor{};
};

class CornerView {
 public:
  /// At most `most` corners with at least this contrast (luma steps), the best first. No value without an image,
  /// if a number is not finite, or if the camera is more than 50 m from the field's center.
  static std::optional<CornerView> of(const RoomObservation& view, int contrast, int most);

  const std::vector<SeenCorner>& corners() const { return corners_; }
  const Eigen::Vector3d& eye() const { return eye_; }  ///< the camera's position, field frame, m

  /// Whether a corner at this position (field frame, m) would be found: above the horizon, within the part of the image
  /// that is searched, and not covered by a robot or a goal.
  bool shows(const Eigen::Vector3d& place) const;

 private:
  CornerView(const RoomObservation& view, const CameraModel& camera);

  bool is_searched(const Eigen::Vector2d& pixel) const;
  int rows_above_horizon() const;
  void find(int contrast, int most);

  const RoomObservation* view_;
  CameraModel camera_;  // at the image's resolution
  Isometry3 field_from_camera_;
  Eigen::Vector3d eye_;
  std::vector<SeenCorner> corners_;
};

}  // namespace reorient
