// What a frame believes: our own localization or somebody else's, and what reorientations do to it.
#include <algorithm>
#include <cmath>

#include "engine/frame.h"
#include "engine/stage_timer.h"
#include "engine/world/goal_view.h"
#include "engine/world/seen_view.h"
#include "localization/reorientation.h"

namespace reorient {
namespace {

/// By what probability a pose that is not tracked lies elsewhere. With one half, 96 to 99 % of the true poses of robots
/// that were put down anywhere lay within the 95 % region of their belief (docs/evidence.md).
constexpr double kUntrackedIsWrong = 0.5;

}  // namespace

void FrameLoop::localize() {
  const StageTimer timer(record_, Stage::localization);
  std::optional<SensedBelief> sensed = take_external_belief();
  if (!sensed) sensed = locate_ourselves();
  const BeliefJump jump = world_tracker_.take_belief(*sensed, odometry_step_, parameters_.pose_filter.clusters);
  if (room_) follow_jump(jump);
}

SensedBelief FrameLoop::locate_ourselves() {
  if (external_belief_) go_on_by_ourselves();
  pose_filter_.predict(odometry_step_, world().time_step);
  pose_tracker_.predict(odometry_step_, world().time_step, parameters_.pose_filter.motion);
  const std::array<CameraPercept, 2> seen = percepts_of_cameras();
  const std::optional<SeenView> view =
      room_ ? seen_view(*room_, observation_->odometry.rotation, parameters_.seen_view) : std::nullopt;
  pose_filter_.update(record_.percepts[kUpper], record_.percepts[kLower],
                      room_ ? seen_goal(room_->confidences(), parameters_.goal_view) : SeenGoal::unknown, view,
                      bias_deviation(seen));
  search_pose(seen, view);
  pose_tracker_.update(seen, pose_filter_.belief(), world().time_step);
  SensedBelief sensed{pose_tracker_.belief(pose_filter_.belief()), is_pose_known()};
  if (!sensed.tracked)
    sensed.belief.covariance =
        doubted_covariance(sensed.belief, kUntrackedIsWrong, {world().field.length, world().field.width});
  world_tracker_.take_camera_bias(pose_tracker_.bias());
  const bool looks = world().upright() && (observation_->upper || observation_->lower);
  if (looks && !record_.percepts[kUpper].has_landmarks() && !record_.percepts[kLower].has_landmarks())
    pose_filter_.see_nothing(world().time_step);
  sensed.recovery_probability =
      pose_filter_.recovery().recovery_probability(parameters_.pose_filter.injection.lost_margin);
  return sensed;
}

std::array<CameraPercept, 2> FrameLoop::percepts_of_cameras() const {
  std::array<CameraPercept, 2> seen;
  const std::array cameras{&record_.inputs.upper, &record_.inputs.lower};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (*cameras[i]) seen[i] = {&record_.percepts[i], (*cameras[i])->robot_from_camera};
  }
  return seen;
}

/// Of the camera whose tilt is known less well.
double FrameLoop::bias_deviation(const std::array<CameraPercept, 2>& seen) const {
  double deviation = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].percept != nullptr)
      deviation = std::max(deviation, pose_tracker_.bias_deviation(seen[i].robot_from_camera, i));
  }
  return deviation;
}

/// Up to its reflection.
bool FrameLoop::is_pose_known() const {
  return parameters_.pose_tracker.enabled ? pose_tracker_.is_attached() : !pose_filter_.is_lost();
}

/// While the pose is not known, the search matches all that was seen in the last seconds.
void FrameLoop::search_pose(const std::array<CameraPercept, 2>& seen, const std::optional<SeenView>& view) {
  constexpr double kBeforeItIsNoticed = 1.0;  // s
  const CameraBias bias = pose_tracker_.bias();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].percept != nullptr)
      pose_search_.see(*seen[i].percept, i, seen[i].robot_from_camera, bias_of(bias, i, seen[i].robot_from_camera),
                       observation_->odometry, world().time);
  }
  if (pose_filter_.is_lost() && pose_tracker_.is_attached()) pose_tracker_.let_go();
  const bool is_known = is_pose_known();
  if (!is_known && was_known_) pose_search_.forget_before(world().time - kBeforeItIsNoticed);
  was_known_ = is_known;
  if (is_known || !world().upright()) return pose_search_.stop();
  const std::optional<PoseHypothesis> found = pose_search_.search(pose_filter_.map(), pose_tracker_.prior(),
                                                                  observation_->odometry, pose_filter_.belief().pose);
  if (!found) return;
  pose_filter_.take_found(found->field_from_odometry * observation_->odometry, view);
  pose_tracker_.take_found(found->bias);
  pose_tracker_.attach(pose_filter_.belief());
}

/// Then our pose filter rests. If no belief can be read, the last one moves with the odometry for a while.
std::optional<SensedBelief> FrameLoop::take_external_belief() {
  std::optional<PoseBelief> belief;
  if (observation_->belief)
    belief = external_reader_.read(*observation_->belief, world().pose, parameters_.pose_filter.clusters);
  has_read_belief_ = belief.has_value();
  if (!belief) {
    without_external_belief_ += world().time_step;
    if (!external_belief_ || without_external_belief_ > parameters_.external_belief.patience) return std::nullopt;
    belief = world().pose;
    belief->pose = belief->pose * odometry_step_;
    return SensedBelief{*belief, world().pose_tracked};
  }
  without_external_belief_ = 0.0;
  external_belief_ = true;
  world_tracker_.take_pose_known(is_known(*belief));
  return SensedBelief{*belief, world().pose_known};
}

/// The other localization says no more: ours begins where that has ended.
void FrameLoop::go_on_by_ourselves() {
  constexpr double kLeastPosition = 0.1, kMostPosition = 2.0;  // m
  const double least_rotation = from_degrees(5.0);
  const Eigen::Vector3d deviation = world().pose.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  pose_filter_.set_initial_pose(world().pose.pose,
                                std::clamp(deviation.head<2>().maxCoeff(), kLeastPosition, kMostPosition),
                                std::clamp(deviation.z(), least_rotation, kPi));
  pose_tracker_.let_go();
  external_belief_ = false;
}

/// A belief that jumps is another belief: what was seen before was compared with the old one.
void FrameLoop::follow_jump(BeliefJump jump) {
  switch (jump) {
    case BeliefJump::none:
      break;
    case BeliefJump::to_reflection:
      room_->on_flip();
      break;
    case BeliefJump::elsewhere:
      room_->on_reset();
      break;
  }
}

/// Half-time: the axes are the team's, so whatever is believed and known gets the coordinates of the reflected place.
/// A belief of another localization is turned by that itself.
void FrameLoop::change_sides() {
  world_tracker_.change_sides();
  pose_filter_.flip_pose();
  pose_tracker_.flip();
  repeated_pose_.forget();
  if (room_) room_->turn_half();
}

void FrameLoop::rearrange(const CommandRecord& granted) {
  ReorientationRecord& record = record_.reorientation.emplace();
  record.reorientation = granted.request.reorientation;
  record.issuer = granted.request.issuer;
  record.belief_before = world().pose;
  if (record_.filled.has(Topic::pose_particles)) append_poses(record_.pose_particles.before);
  if (external_belief_) {
    // It is carried out elsewhere, or not: what becomes of the belief, the next observations say.
    record.belief_after = expected_after(record.reorientation, world().pose);
    if (room_ && record.reorientation == Reorientation::purge_reflection) room_->on_purge();
    if (record.reorientation == Reorientation::flip_pose) flip_between_equals();
    return;
  }
  switch (granted.request.reorientation) {
    case Reorientation::flip_pose:
      pose_filter_.flip_pose();
      pose_tracker_.flip();
      repeated_pose_.note_flip(world().time);
      if (room_) room_->on_flip();
      break;
    case Reorientation::purge_reflection:
      pose_filter_.purge_reflection();
      if (room_) room_->on_purge();
      break;
    case Reorientation::reset_orientation:
      pose_filter_.reset_orientation();
      pose_tracker_.let_go();
      if (room_) room_->on_reset();
      break;
  }
  record.belief_after = pose_tracker_.belief(pose_filter_.belief());
  world_tracker_.take_reorientation(record.reorientation, record.belief_after);
}

/// If another localization has two opposite hypotheses of about equal weight, the engine keeps the one that it
/// believes. The flip of such a pair is the same pair, which no observation can show. So the engine flips its own
/// belief here.
void FrameLoop::flip_between_equals() {
  if (world().pose.cluster_weight > parameters_.pose_filter.clusters.lead_to_switch * world().pose.reflected_weight)
    return;
  world_tracker_.take_flip(flipped(world().pose));
  if (room_) room_->on_flip();
}

void FrameLoop::append_poses(std::vector<Pose2>& poses) const {
  if (!external_belief_) return pose_filter_.append_poses(poses);
  if (has_read_belief_) return external_reader_.append_poses(poses);
  poses.push_back(world().pose.pose);
}

}  // namespace reorient
