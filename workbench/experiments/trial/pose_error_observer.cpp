// SPDX-License-Identifier: MIT
#include "workbench/experiments/trial/pose_error_observer.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "workbench/run/run_summary.h"

namespace reorient {
namespace {

constexpr double kNear = 0.3;                       // m
constexpr double kTurned = from_degrees(10.0);      // rad
constexpr double kStays = 2.0;                      // s for which a belief must stay near
constexpr double kSettled = 5.0;                    // s on its feet after a fall or after it was lifted
constexpr double kNinetyFivePercent = 7.81;         // of a chi-squared distribution with 3 degrees of freedom
constexpr double kLeastPosition = 1e-4;             // m, of a stated deviation
constexpr double kLeastRotation = 1e-4;             // rad
constexpr double kMostNormalizedSquare = 10'000.0;  // limit, so that one frame cannot dominate

bool is_near(const Pose2& belief, const Pose2& truth) {
  const PoseError error = pose_error(belief, truth);
  return error.position < kNear && error.rotation < kTurned;
}

/// Square of the Mahalanobis distance of the truth from the belief.
double normalized_square(const PoseBelief& belief, const Pose2& truth) {
  Eigen::Matrix3d covariance = belief.covariance;
  covariance.diagonal() += Eigen::Vector3d(kLeastPosition * kLeastPosition, kLeastPosition * kLeastPosition,
                                           kLeastRotation * kLeastRotation);
  Eigen::Vector3d error;
  error << truth.position - belief.pose.position, angle_difference(truth.rotation, belief.pose.rotation);
  const double square = error.dot(covariance.ldlt().solve(error));
  return square >= 0.0 && square <= kMostNormalizedSquare ? square : kMostNormalizedSquare;
}

}  // namespace

void PoseErrorObserver::observe(const FrameRecord& frame, const SceneTruth& scene) {
  const TrialResult& trial = trial_.result();
  if (!trial.started || !scene.truth) return;
  const double time = trial.seconds;
  const GroundTruth& truth = *scene.truth;
  const PoseBelief& belief = frame.world.pose;
  const bool is_standing = !truth.fallen && !truth.carried;
  if (!is_standing) was_disturbed_ = true;
  if (truth.fallen && !has_fallen_) errors_.recoveries.emplace_back();
  if (truth.fallen) stood_up_at_.reset();
  if (has_fallen_ && !truth.fallen) stood_up_at_ = time;
  has_fallen_ = truth.fallen;

  const Pose2 reflected = reflect(truth.pose);
  const bool is_right = is_standing && is_near(belief.pose, truth.pose);
  right_.note(is_right, time);
  located_.note(is_right || (is_standing && is_near(belief.pose, reflected)), time);
  stands_.note(is_standing, time);
  watch_recovery(time);

  const bool is_settled = is_standing && (!was_disturbed_ || time - *stands_.time >= kSettled);
  if (!is_settled) return;
  const bool is_mirrored = std::abs(angle_difference(belief.pose.rotation, truth.pose.rotation)) > kPi / 2.0;
  const Pose2& compared = is_mirrored ? reflected : truth.pose;
  const PoseError error = pose_error(belief.pose, compared);
  const double square = normalized_square(belief, compared);
  ++errors_.frames;
  errors_.mirrored_frames += is_mirrored ? 1 : 0;
  errors_.square_position += error.position * error.position;
  errors_.square_rotation += error.rotation * error.rotation;
  errors_.normalized_square += square;
  errors_.frames_within += square <= kNinetyFivePercent ? 1 : 0;
}

void PoseErrorObserver::watch_recovery(double time) {
  const auto stays = [time](const Since& since) { return since.time && time - *since.time >= kStays; };
  if (!errors_.located_after && stays(located_)) errors_.located_after = *located_.time;
  if (!stood_up_at_) return;
  FallRecovery& recovery = errors_.recoveries.back();
  if (!recovery.right_after && stays(right_)) recovery.right_after = std::max(0.0, *right_.time - *stood_up_at_);
  if (!recovery.located_after && stays(located_))
    recovery.located_after = std::max(0.0, *located_.time - *stood_up_at_);
}

}  // namespace reorient
