// SPDX-License-Identifier: MIT
// The engine's own localization as one: the pose particle filter, the tracker that follows its best hypothesis, and the
// search that finds the pose of a lost robot.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/camera_bias.h"
#include "geometry/field_dimensions.h"
#include "geometry/head.h"
#include "geometry/pose2.h"
#include "localization/pose_belief.h"
#include "localization/pose_filter.h"
#include "localization/search/pose_search.h"
#include "localization/tracking/gravity_bias.h"
#include "localization/tracking/pose_tracker.h"

namespace reorient {

struct LocalizerParameters {
  PoseFilterParameters filter;
  PoseTrackerParameters tracker;
  PoseSearchParameters search;
};

/// What the localization uses of one frame.
struct LocalizerInputs {
  double time = 0.0;                  ///< s
  double time_step = 0.0;             ///< s since the frame before
  Pose2 odometry;                     ///< dead reckoning since the start
  Pose2 odometry_step;                ///< the same since the frame before
  bool upright = true;                ///< otherwise the poses of the cameras are not known
  std::array<CameraPercept, 2> seen;  ///< by the upper and the lower camera
  SeenGoal goal = SeenGoal::unknown;
  std::optional<SeenView> view{};
};

class Localizer {
 public:
  Localizer(const LocalizerParameters& parameters, const FieldDimensions& field, std::uint64_t seed);

  /// From the next frame on.
  void set_parameters(const LocalizerParameters& parameters);

  /// A pose is set from outside. Standard deviations in m (along each axis) and rad.
  void set_initial_pose(const Pose2& pose, double position_deviation, double rotation_deviation);
  /// Starts where another localization has ended.
  void continue_from(const PoseBelief& believed);
  /// One sample of the accelerometer, see GravityBias. Only a robot that is upright feels gravity alone: the mean
  /// acceleration of a fall or of a lift is another one.
  void feel_gravity(bool upright, const Eigen::Vector3d& acceleration, const TorsoAttitude& torso, double time);
  /// The robot fell or was carried: it may stand elsewhere than before `time`, s.
  void doubt(double time);

  /// One frame.
  SensedBelief update(const LocalizerInputs& inputs);

  // The commands; belief() is up to date when they return.
  void flip_pose();
  void purge_reflection() { filter_.purge_reflection(); }
  void reset_orientation();

  PoseBelief belief() const { return tracker_.belief(filter_.belief()); }
  CameraBias bias() const { return tracker_.bias(); }
  /// What was saved of this body.
  void set_bias(const CameraBias& bias) { tracker_.set_bias(bias); }
  /// The poses of all particles, appended.
  void append_poses(std::vector<Pose2>& poses) const { filter_.append_poses(poses); }

  /// All that decides what comes next; parameters and field are as they are. Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.filter_, self.tracker_, self.gravity_, self.search_, self.was_known_);
  }

 private:
  double bias_deviation(const std::array<CameraPercept, 2>& seen) const;
  bool is_pose_known() const;
  void search(const LocalizerInputs& inputs);

  LocalizerParameters parameters_;
  Eigen::Vector2d field_size_;  ///< m
  PoseFilter filter_;
  PoseTracker tracker_;
  GravityBias gravity_;
  PoseSearch search_;
  bool was_known_ = false;  ///< the pose, in the frame before
};

}  // namespace reorient
