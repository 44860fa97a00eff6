// SPDX-License-Identifier: MIT
// The engine's own localization: the pose filter, the tracker that follows its best hypothesis, and the search that
// finds the pose of a lost robot.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/bytes.h"
#include "geometry/camera_bias.h"
#include "geometry/field_dimensions.h"
#include "geometry/head.h"
#include "geometry/pose2.h"
#include "localization/measurement/field_line_map.h"
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

/// The inputs of one frame.
struct LocalizerInputs {
  double time = 0.0;                  ///< s
  double time_step = 0.0;             ///< s since the previous frame
  Pose2 odometry;                     ///< dead reckoning since the start
  Pose2 odometry_step;                ///< the same since the previous frame
  bool upright = true;                ///< false: the poses of the cameras are unknown
  std::array<CameraPercept, 2> seen;  ///< of the upper and the lower camera
  SeenGoal goal = SeenGoal::unknown;
  std::optional<SeenView> view{};
};

class Localizer {
 public:
  Localizer(const LocalizerParameters& parameters, const FieldDimensions& field, std::uint64_t seed);

  /// Applies from the next frame.
  void set_parameters(const LocalizerParameters& parameters);

  /// Sets a pose from outside. Standard deviations in m (along each axis) and rad.
  void set_initial_pose(const Pose2& pose, double position_deviation, double rotation_deviation);
  /// Continues from the belief of another localization.
  void continue_from(const PoseBelief& believed);
  /// One sample of the accelerometer, see GravityBias. The mean acceleration is gravity only while the robot is
  /// upright, not while it falls or is lifted.
  void feel_gravity(bool upright, const Eigen::Vector3d& acceleration, const TorsoAttitude& torso, double time);
  /// The robot fell or was lifted at `time`, s, and may have moved.
  void doubt(double time);

  /// Processes one frame.
  SensedBelief update(const LocalizerInputs& inputs);

  // The commands. belief() is up to date when they return.
  void flip_pose();
  void purge_reflection() { filter_.purge_reflection(); }
  void reset_orientation();

  PoseBelief belief() const { return tracker_.belief(filter_.belief()); }
  CameraBias bias() const { return tracker_.bias(); }
  /// Sets the bias that was saved for this body.
  void set_bias(const CameraBias& bias) { tracker_.set_bias(bias); }
  /// Appends the poses of all particles.
  void append_poses(std::vector<Pose2>& poses) const { filter_.append_poses(poses); }
  /// How well the features of a percept of the last frame fit at a pose.
  void feature_fits(const FieldPercept& percept, const Pose2& pose, FeatureFits& fits) {
    filter_.feature_fits(percept, pose, fits);
  }

  /// Everything that future results depend on, except parameters and field. Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.filter_, self.tracker_, self.gravity_, self.search_, self.was_known_, self.doubt_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  /// Checks the state after reading.
  void complete() const {
    check_bytes(doubt_ >= 0.0 && doubt_ <= 1.0, "localizer: the doubt about the pose is outside of 0 to 1");
  }
  double bias_deviation(const std::array<CameraPercept, 2>& seen) const;
  bool expects_lines(const std::array<CameraPercept, 2>& seen) const;
  bool is_pose_known() const;
  void search(const LocalizerInputs& inputs);

  LocalizerParameters parameters_;
  Eigen::Vector2d field_size_;  ///< m
  FieldLineMap lines_;
  PoseFilter filter_;
  PoseTracker tracker_;
  GravityBias gravity_;
  PoseSearch search_;
  bool was_known_ = false;  ///< whether the pose was known in the previous frame
  double doubt_ = 0.0;      ///< probability that the believed pose, and its reflection, are wrong
};

}  // namespace reorient
