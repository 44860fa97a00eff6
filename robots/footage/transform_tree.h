// SPDX-License-Identifier: MIT
// Coordinate frames of a robot log and the rigid motions between them over time. As in ROS's tf and in Foxglove, each
// frame has at most one parent.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/transform.h"
#include "robots/footage/messages/messages.h"

namespace reorient {

/// Empty if a number is not finite or too large, or if the quaternion has not length 1.
std::optional<Isometry3> isometry_of(const messages::Motion& motion);
std::optional<Eigen::Matrix3d> rotation_of(const messages::Quaternion& quaternion);

/// Limits in time for the use of samples of a rigid motion.
struct MotionLimits {
  double max_gap = 1.0;  ///< s, between two samples for interpolation
  double max_age = 0.2;  ///< s, from a single sample without interpolation
};

/// One rigid motion over time: the samples of the last 30 s.
class MotionTrack {
 public:
  /// Samples may come in any order.
  void add(messages::Time time, const Isometry3& motion);
  void clear() { samples_.clear(); }

  /// The motion at `time`, interpolated linearly between its two neighbors (quaternions by their normalized sum), or
  /// else the nearest sample. Empty if no sample is within the limits.
  std::optional<Isometry3> at(messages::Time time, const MotionLimits& limits) const;
  /// The last sample before `time`, or else the first one; empty without samples.
  std::optional<Isometry3> latest(messages::Time time) const;

 private:
  struct Sample {
    messages::Time time;
    Isometry3 motion;
  };
  std::deque<Sample> samples_;  // by time
};

class TransformTree {
 public:
  enum class Validity {
    limited,  ///< within MotionLimits: transforms of ROS
    lasting,  ///< until the next transform: Foxglove
    fixed,    ///< always: /tf_static of ROS
  };

  /// False: the transform is invalid and ignored. Throws BadFootage for more than 10000 frames.
  bool add(const messages::Transform& transform, Validity validity);

  /// The motion target_from_source. Empty if the two frames are not connected at `time`.
  std::optional<Isometry3> find(std::string_view target, std::string_view source, messages::Time time,
                                const MotionLimits& limits) const;

  /// Names of the frames, for an error message.
  std::string names() const;

 private:
  struct Edge {
    std::string parent;
    Validity validity = Validity::limited;
    MotionTrack parent_from_child;
  };
  std::map<std::string, Edge, std::less<>> edges_;  // by child
};

/// The name without the leading '/' of old versions of ROS.
std::string_view plain_frame(std::string_view name);

}  // namespace reorient
