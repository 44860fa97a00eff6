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
  const Pose2 expected = world_.pose.pose * odometry_step_;
  if (!take_external_belief()) {
    if (external_belief_) go_on_by_ourselves();
    pose_filter_.predict(odometry_step_, world_.time_step);
    pose_tracker_.predict(odometry_step_, world_.time_step, parameters_.pose_filter.motion);
    const std::array<CameraPercept, 2> seen = percepts_of_cameras();
    const std::optional<SeenView> view =
        room_ ? seen_view(*room_, observation_->odometry.rotation, parameters_.seen_view) : std::nullopt;
    pose_filter_.update(record_.percepts[kUpper], record_.percepts[kLower],
                        room_ ? seen_goal(room_->confidences(), parameters_.goal_view) : SeenGoal::unknown, view,
                        bias_deviation(seen));
    search_pose(seen, view);
    pose_tracker_.update(seen, pose_filter_.belief(), world_.time_step);
    world_.pose = pose_tracker_.belief(pose_filter_.belief());
    world_.pose_tracked = is_pose_known();
    if (!world_.pose_tracked)
      world_.pose.covariance =
          doubted_covariance(world_.pose, kUntrackedIsWrong, {world_.field.length, world_.field.width});
    world_.camera_bias = pose_tracker_.bias();
    const bool looks = world_.upright() && (observation_->upper || observation_->lower);
    if (looks && !record_.percepts[kUpper].has_landmarks() && !record_.percepts[kLower].has_landmarks())
      pose_filter_.see_nothing(world_.time_step);
    world_.recovery_probability =
        pose_filter_.recovery().recovery_probability(parameters_.pose_filter.injection.lost_margin);
  }
  if (room_) watch_belief(expected);
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
                       observation_->odometry, world_.time);
  }
  if (pose_filter_.is_lost() && pose_tracker_.is_attached()) pose_tracker_.let_go();
  const bool is_known = is_pose_known();
  if (!is_known && was_known_) pose_search_.forget_before(world_.time - kBeforeItIsNoticed);
  was_known_ = is_known;
  if (is_known || !world_.upright()) return pose_search_.stop();
  const std::optional<PoseHypothesis> found = pose_search_.search(pose_filter_.map(), pose_tracker_.prior(),
                                                                  observation_->odometry, pose_filter_.belief().pose);
  if (!found) return;
  pose_filter_.take_found(found->field_from_odometry * observation_->odometry, view);
  pose_tracker_.take_found(found->bias);
  pose_tracker_.attach(pose_filter_.belief());
}

/// Then our pose filter rests.
bool FrameLoop::take_external_belief() {
  if (!observation_->belief) return false;
  const std::optional<PoseBelief> belief =
      external_reader_.read(*observation_->belief, world_.pose, parameters_.pose_filter.clusters);
  if (!belief) return false;
  external_belief_ = true;
  world_.pose = *belief;
  world_.pose_known = is_known(*belief);
  world_.recovery_probability = 0.0;
  world_.pose_tracked = world_.pose_known;
  return true;
}

/// The other localization says no more: ours begins where that has ended.
void FrameLoop::go_on_by_ourselves() {
  constexpr double kLeastPosition = 0.1, kMostPosition = 2.0;  // m
  const double least_rotation = from_degrees(5.0);
  const Eigen::Vector3d deviation = world_.pose.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  pose_filter_.set_initial_pose(world_.pose.pose,
                                std::clamp(deviation.head<2>().maxCoeff(), kLeastPosition, kMostPosition),
                                std::clamp(deviation.z(), least_rotation, kPi));
  pose_tracker_.let_go();
  external_belief_ = false;
}

/// A belief that jumps is another belief: what was seen before was compared with the old one.
void FrameLoop::watch_belief(const Pose2& expected) {
  const PoseClusterParameters& cluster = parameters_.pose_filter.clusters;
  const auto is_near = [&](const Pose2& pose) {
    return are_near(world_.pose.pose, pose, cluster.radius, cluster.max_rotation_difference);
  };
  if (is_near(expected)) return;
  if (is_near(reflect(expected))) {
    room_->on_belief_reflected();
  } else {
    room_->on_reset();
  }
}

/// Half-time: the axes are the team's, so whatever is believed and known gets the coordinates of the reflected place.
/// A belief of another localization is turned by that itself.
void FrameLoop::change_sides() {
  world_.sides_changed = !world_.sides_changed;
  pose_filter_.flip_pose();
  pose_tracker_.flip();
  repeated_pose_.forget();
  world_.pose = flipped(world_.pose);
  if (room_) room_->turn_half();
}

void FrameLoop::rearrange(const CommandRecord& granted) {
  ReorientationRecord& record = record_.reorientation.emplace();
  record.reorientation = granted.request.reorientation;
  record.issuer = granted.request.issuer;
  record.belief_before = world_.pose;
  if (record_.filled.has(Topic::pose_particles)) append_poses(record_.pose_particles.before);
  if (external_belief_) {
    // It is carried out elsewhere, or not: what becomes of the belief, the next observations say.
    record.belief_after = expected_after(record.reorientation, world_.pose);
    if (room_ && record.reorientation == Reorientation::purge_reflection) room_->on_purge();
    if (record.reorientation == Reorientation::flip_pose) flip_between_equals();
    return;
  }
  switch (granted.request.reorientation) {
    case Reorientation::flip_pose:
      pose_filter_.flip_pose();
      pose_tracker_.flip();
      repeated_pose_.note_flip(world_.time);
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
  // After a reset nobody knows the orientation; a flip or a purge says that the room, or somebody, has told it.
  world_.pose_known = granted.request.reorientation != Reorientation::reset_orientation;
  record.belief_after = world_.pose = pose_tracker_.belief(pose_filter_.belief());
}

/// If another localization has two opposite hypotheses of about equal weight, the engine keeps the one that it
/// believes. The flip of such a pair is the same pair, which no observation can show. So the engine flips its own
/// belief here.
void FrameLoop::flip_between_equals() {
  if (world_.pose.cluster_weight > parameters_.pose_filter.clusters.lead_to_switch * world_.pose.reflected_weight)
    return;
  world_.pose = flipped(world_.pose);
  if (room_) room_->on_flip();
}

void FrameLoop::append_poses(std::vector<Pose2>& poses) const {
  if (external_belief_) {
    external_reader_.append_poses(poses);
  } else {
    pose_filter_.append_poses(poses);
  }
}

}  // namespace reorient
