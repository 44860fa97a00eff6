#include "engine/frame.h"

#include <algorithm>

namespace reorient {
namespace {

/// What stands on the field hides the room behind it: a tile counts only where it is really seen.
void collect_covered(const FieldPercept& percept, std::vector<CoveredArea>& covered) {
  covered.clear();
  for (const Obstacle& obstacle : percept.obstacles) {
    covered.push_back({obstacle.left, obstacle.top, obstacle.right, obstacle.bottom});
  }
  for (const GoalPost& post : percept.goal_posts) {
    const auto [left, right] = std::minmax(post.base.x(), post.top.x());
    const float half_width = 0.1f * (post.base.y() - post.top.y());  // a post is an eighth as wide as it is high
    covered.push_back({static_cast<int>(left - half_width), static_cast<int>(post.top.y()),
                       static_cast<int>(right + half_width), static_cast<int>(post.base.y())});
  }
}

}  // namespace

FrameLoop::FrameLoop(Robot& robot, ScriptHost& scripts, const CoreParameters& parameters, const FieldDimensions& field,
                     const FrameOptions& options)
    : robot_(robot),
      scripts_(scripts),
      parameters_(parameters),
      field_features_(parameters.field_features, field),
      pose_filter_(parameters.pose_filter, field, options.seed),
      percept_(&nothing_seen_),
      script_output_(&nothing_said_),
      arbitration_(&nothing_asked_) {
  if (options.room_awareness) room_.emplace(parameters.room, options.seed);
  world_.field = field;
}

bool FrameLoop::step() {
  if (!robot_.observe(observation_)) return false;
  take_parameters();
  measure_state();
  see_field();
  localize();
  look_at_room();
  describe_world();
  decide();
  robot_.request(script_output_->request);
  fingerprint();
  return true;
}

void FrameLoop::take_parameters() {
  field_features_.set_parameters(parameters_.field_features);
  pose_filter_.set_parameters(parameters_.pose_filter);
  if (room_) room_->set_parameters(parameters_.room);
  arbiter_.parameters() = parameters_.arbiter;
}

void FrameLoop::measure_state() {
  if (world_.frame > 0) world_.time_step = std::max(0.0, observation_.time - world_.time);
  world_.time = observation_.time;
  ++world_.frame;
  state_.update(observation_, world_.time_step, parameters_.robot_state);

  odometry_step_ = last_odometry_ ? last_odometry_->inverse() * observation_.odometry : Pose2();
  last_odometry_ = observation_.odometry;
  robot_from_camera_ =
      reorient::robot_from_camera(robot_.dimensions(), observation_.head, observation_.torso, observation_.hip_height);
}

void FrameLoop::see_field() {
  percept_ = state_.upright() ? &field_features_.find(observation_.image, observation_.camera, robot_from_camera_)
                              : &nothing_seen_;
  collect_covered(*percept_, covered_);
}

void FrameLoop::localize() {
  pose_filter_.predict(odometry_step_, world_.time_step);
  pose_filter_.update(*percept_, room_ ? seen_goal(room_->confidences(), parameters_.goal_view) : SeenGoal::unknown);
}

void FrameLoop::look_at_room() {
  // The arbitration is the last frame's: what behaviours paused then rests now.
  world_.training = room_ && state_.upright() && world_.pose_known && arbitration_->train;
  world_.evaluating = room_ && state_.upright() && arbitration_->evaluate;
  if (!room_) return;
  world_.confidence = room_->update({.time = observation_.time,
                                     .image = observation_.image,
                                     .camera = observation_.camera,
                                     .robot_from_camera = robot_from_camera_,
                                     .belief = pose_filter_.belief().pose,
                                     .odometry_rotation = observation_.odometry.rotation,
                                     .covered = covered_,
                                     .train = world_.training,
                                     .evaluate = world_.evaluating});
  if (world_.training) world_.trained_seconds += world_.time_step;
}

void FrameLoop::describe_world() {
  world_.fallen = state_.fallen();
  world_.carried = state_.carried();
  world_.penalized = observation_.penalized;
  world_.head = observation_.head;
  world_.pose = pose_filter_.belief();
  world_.recovery_probability =
      pose_filter_.recovery().recovery_probability(parameters_.pose_filter.injection.lost_margin);
  world_.goal_posts = static_cast<int>(percept_->goal_posts.size());
  world_.line_points = static_cast<int>(percept_->line_points.size());
  world_.truth = robot_.ground_truth();
}

void FrameLoop::decide() {
  script_output_ = &scripts_.tick(world_);
  arbitration_ = &arbiter_.arbitrate(script_output_->commands, script_output_->leases, world_);
  rearrangement_.reset();
  if (arbitration_->reorientation) rearrange(*arbitration_->reorientation);
  for (const ExperimenterAction& action : script_output_->actions) {
    if (action.kind == ExperimenterAction::Kind::set_initial_pose) set_initial_pose(action.pose);
  }
  world_.pose = pose_filter_.belief();
}

void FrameLoop::set_initial_pose(const Pose2& told) {
  constexpr double kPositionDeviation = 0.1;  // m, of somebody who places a robot by eye
  constexpr double kRotationDeviation = from_degrees(5.0);
  pose_filter_.set_initial_pose(told, kPositionDeviation, kRotationDeviation);
  world_.pose_known = true;
}

void FrameLoop::rearrange(Command command) {
  rearrangement_.emplace();
  rearrangement_->time = world_.time;
  rearrangement_->command = command;
  rearrangement_->truth = world_.truth;
  rearrangement_->belief_before = pose_filter_.belief();
  pose_filter_.append_poses(rearrangement_->particles_before);
  switch (command) {
    case Command::flip_pose:
      pose_filter_.flip_pose();
      if (room_) room_->on_flip();
      break;
    case Command::purge_reflection:
      pose_filter_.purge_reflection();
      if (room_) room_->on_purge();
      break;
    case Command::reset_orientation:
      pose_filter_.reset_orientation();
      if (room_) room_->on_reset();
      break;
    case Command::pause_training:
    case Command::pause_evaluation:
      break;
  }
  // After a reset nobody knows the orientation; a flip or a purge says that the room, or somebody, has told it.
  world_.pose_known = command != Command::reset_orientation;
  rearrangement_->belief_after = pose_filter_.belief();
  pose_filter_.append_poses(rearrangement_->particles_after);
}

void FrameLoop::fingerprint() {
  digest_.add(observation_.time);
  for (int y = 0; y < observation_.image.height; ++y) {
    digest_.add(
        std::as_bytes(std::span(observation_.image.row(y), static_cast<std::size_t>(2 * observation_.image.width))));
  }
  for (const double value : {observation_.head.yaw,
                             observation_.head.pitch,
                             observation_.torso.roll,
                             observation_.torso.pitch,
                             observation_.odometry.position.x(),
                             observation_.odometry.position.y(),
                             observation_.odometry.rotation,
                             observation_.foot_load,
                             observation_.hip_height,
                             observation_.penalized ? 1.0 : 0.0,
                             observation_.camera.focal.x(),
                             observation_.camera.focal.y(),
                             observation_.camera.center.x(),
                             observation_.camera.center.y(),
                             observation_.camera.k1,
                             observation_.camera.k2,
                             world_.pose.pose.position.x(),
                             world_.pose.pose.position.y(),
                             world_.pose.pose.rotation,
                             world_.pose.cluster_weight,
                             world_.confidence.current,
                             world_.confidence.opposite}) {
    digest_.add(value);
  }
  for (const CommandRecord& record : arbitration_->records) {
    digest_.add(static_cast<std::uint64_t>(record.request.command));
    digest_.add(static_cast<std::uint64_t>(record.verdict));
    digest_.add(record.request.issuer);
  }
}

}  // namespace reorient
