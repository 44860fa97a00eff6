// SPDX-License-Identifier: MIT
// Coordinate frames of a robot log and the rigid motions between them over time, as ROS's tf and Foxglove define them:
// each frame has at most one parent.
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

/// Empty: a number is not finite or absurdly large, or the quaternion is not of length 1.
std::optional<Isometry3> isometry_of(const messages::Motion& motion);
std::optional<Eigen::Matrix3d> rotation_of(const messages::Quaternion& quaternion);

/// How far from a sample in time a rigid motion may be used.
struct MotionLimits {
  double max_gap = 1.0;  ///< s, between two samples, for interpolation
  double max_age = 0.2;  ///< s, from a sample, where there is no interpolation
};

/// One rigid motion over time: the samples of the last 30 s.
class MotionTrack {
 public:
  /// Samples may come in any order.
  void add(messages::Time time, const Isometry3& motion);
  void clear() { samples_.clear(); }

  /// Interpolated between the two neighbors of `time`, linearly (quaternions by their normalized sum); else that of the
  /// nearest sample. Empty: no sample is near enough.
  std::optional<Isometry3> at(messages::Time time, const MotionLimits& limits) const;
  /// The last sample before `time`, else the first one; empty: there is no sample.
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
    limited,  ///< as MotionLimits say: transforms of ROS
    lasting,  ///< until the next one: transforms of Foxglove
    fixed,    ///< at all times: ROS's /tf_static
  };

  /// False: the transform is invalid and ignored. Throws BadFootage where there are more frames than in any robot.
  bool add(const messages::Transform& transform, Validity validity);

  /// target_from_source. Empty: the two frames are not connected at `time`.
  std::optional<Isometry3> find(std::string_view target, std::string_view source, messages::Time time,
                                const MotionLimits& limits) const;

  /// The names of all frames, for an error message.
  std::string names() const;

 private:
  struct Edge {
    std::string parent;
    Validity validity = Validity::limited;
    MotionTrack parent_from_child;
  };
  std::map<std::string, Edge, std::less<>> edges_;  // by child
};

/// Without the leading '/' of old versions of ROS.
std::string_view plain_frame(std::string_view name);

}  // namespace reorient
