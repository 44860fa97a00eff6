#include "engine/frame.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "engine/world/goal_view.h"

namespace reorient {
namespace {

constexpr std::size_t kUpper = 0;
constexpr std::size_t kLower = 1;

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

const FieldDimensions& checked(const FieldDimensions& field) {
  if (const std::string mistake = mistake_in(field); !mistake.empty()) throw std::runtime_error("field: " + mistake);
  return field;
}

/// Adds the time until its end to a stage, where somebody wants to know.
class StageTimer {
 public:
  StageTimer(FrameRecord& record, Stage stage) : record_(record), stage_(stage) {
    if (record_.filled.has(Topic::costs)) begin_ = std::chrono::steady_clock::now();
  }
  ~StageTimer() {
    if (!record_.filled.has(Topic::costs)) return;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin_;
    record_.costs.seconds[static_cast<std::size_t>(stage_)] = took.count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  FrameRecord& record_;
  Stage stage_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace

FrameLoop::FrameLoop(FrameSetup setup)
    : revision_(declare_parameters(setup.parameters)),
      field_features_{FieldFeatures(parameters_.field_features, checked(setup.field)),
                      FieldFeatures(parameters_.field_features, setup.field)},
      pose_filter_(parameters_.pose_filter, setup.field, setup.seed),
      behaviors_(std::move(setup.scripts), registry_, limits_) {
  arbiter_.set_parameters(parameters_.arbiter);
  if (setup.room_awareness) room_.emplace(parameters_.room, setup.seed);
  world_.field = setup.field;
  for (const std::string& behavior : setup.behaviors) behaviors_.host().load(behavior);
  record_.names = behaviors_.host().names().table();
}

/// Before the modules are made: they begin with the overridden values.
std::uint64_t FrameLoop::declare_parameters(const std::vector<ParameterChange>& overrides) {
  for (const ParameterChange& change : overrides) registry_.set_early(change);
  declare(parameters_, registry_);
  registry_.bind("script", limits_);
  return registry_.revision();
}

const FrameRecord& FrameLoop::step(const FrameInputs& inputs, Topics wanted) {
  observation_ = &inputs.observation;
  record_.filled = Topics::always() | wanted;
  take_inputs(inputs);
  measure_state();
  see_field();
  localize();
  look_at_room();
  describe_world();
  decide();
  answer();
  complete_record();
  return record_;
}

void FrameLoop::take_inputs(const FrameInputs& inputs) {
  const StageTimer timer(record_, Stage::inputs);
  record_.inputs.initial_pose.reset();
  record_.inputs.messages = 0;
  take_parameters(inputs.parameter_changes);
  record_.reloads.clear();
  if (!inputs.script_edits.empty()) record_.reloads = behaviors_.host().apply(inputs.script_edits);
  if (world_.frame > 0) world_.time_step = std::max(0.0, observation_->time - world_.time);
  world_.time = observation_->time;
  ++world_.frame;
  take_told(observation_->told);
  take_told(inputs.told);
}

void FrameLoop::take_parameters(const std::vector<ParameterChange>& changes) {
  record_.parameter_changes.clear();
  for (const ParameterChange& change : changes) record_.parameter_changes.push_back(registry_.change(change));
  if (revision_ == registry_.revision()) return;
  revision_ = registry_.revision();
  for (FieldFeatures& features : field_features_) features.set_parameters(parameters_.field_features);
  pose_filter_.set_parameters(parameters_.pose_filter);
  if (room_) room_->set_parameters(parameters_.room);
  arbiter_.set_parameters(parameters_.arbiter);
}

void FrameLoop::take_told(const Told& told) {
  if (told.referee) world_.penalized = told.referee->penalized;
  record_.inputs.messages += static_cast<int>(std::min(told.messages.size(), kMostMessages));
  if (!told.initial_pose) return;
  record_.inputs.initial_pose = told.initial_pose;
  const InitialPose& initial = *told.initial_pose;
  pose_filter_.set_initial_pose(initial.pose, initial.position_deviation, initial.rotation_deviation);
  world_.pose_known = true;
}

void FrameLoop::measure_state() {
  state_.update(observation_->body, world_.time_step, parameters_.robot_state);
  odometry_step_ = last_odometry_ ? last_odometry_->inverse() * observation_->odometry : Pose2();
  last_odometry_ = observation_->odometry;
}

/// The robot's motion from when the image was exposed until now, in its present frame: two cameras are seldom
/// exposed at the same instant.
Pose2 FrameLoop::moved_since(const CameraFrame& frame) const {
  return observation_->odometry.inverse() * frame.odometry;
}

void FrameLoop::see_field() {
  const StageTimer timer(record_, Stage::field);
  const auto see = [&](const std::optional<CameraFrame>& frame, std::optional<CameraRecord>& camera,
                       std::size_t which) {
    FieldPercept& percept = record_.percepts[which];
    percept.clear();
    camera.reset();
    if (!frame) return;
    camera =
        CameraRecord{frame->time, frame->camera, frame->robot_from_camera, frame->image.width, frame->image.height};
    if (frame->time != observation_->time)
      camera->robot_from_camera = to_isometry(moved_since(*frame)) * frame->robot_from_camera;
    if (state_.upright()) field_features_[which].find(frame->image, frame->camera, camera->robot_from_camera, percept);
  };
  see(observation_->upper, record_.inputs.upper, kUpper);
  see(observation_->lower, record_.inputs.lower, kLower);
}

void FrameLoop::localize() {
  const StageTimer timer(record_, Stage::localization);
  pose_filter_.predict(odometry_step_, world_.time_step);
  pose_filter_.update(record_.percepts[kUpper],
                      room_ ? seen_goal(room_->confidences(), parameters_.goal_view) : SeenGoal::unknown);
}

void FrameLoop::look_at_room() {
  const StageTimer timer(record_, Stage::room);
  // The arbitration is the last frame's: what behaviours paused then rests now.
  world_.training = room_ && state_.upright() && world_.pose_known && arbiter_.last().train;
  world_.evaluating = room_ && state_.upright() && arbiter_.last().evaluate;
  if (!room_ || !observation_->upper) return;
  collect_covered(record_.percepts[kUpper], covered_);
  world_.confidence = room_->update({.time = observation_->time,
                                     .image = observation_->upper->image,
                                     .camera = observation_->upper->camera,
                                     .robot_from_camera = record_.inputs.upper->robot_from_camera,
                                     .belief = pose_filter_.belief().pose,
                                     .odometry_rotation = observation_->odometry.rotation,
                                     .covered = covered_,
                                     .train = world_.training,
                                     .evaluate = world_.evaluating});
  if (world_.training) world_.trained_seconds += world_.time_step;
}

void FrameLoop::describe_world() {
  world_.fallen = state_.fallen();
  world_.carried = state_.carried();
  world_.head = observation_->body.head;
  world_.pose = pose_filter_.belief();
  world_.recovery_probability =
      pose_filter_.recovery().recovery_probability(parameters_.pose_filter.injection.lost_margin);
  world_.goal_posts = 0;
  world_.line_points = 0;
  for (const FieldPercept& percept : record_.percepts) {
    world_.goal_posts += static_cast<int>(percept.goal_posts.size());
    world_.line_points += static_cast<int>(percept.line_points.size());
  }
}

void FrameLoop::decide() {
  const StageTimer timer(record_, Stage::behaviors);
  behaviors_.tick(world_);
  const Arbitration& arbitration = arbiter_.arbitrate(behaviors_.wanted().commands, behaviors_.leases(), world_);
  record_.reorientation.reset();
  record_.pose_particles.before.clear();
  if (arbitration.granted) rearrange(*arbitration.granted);
  world_.pose = pose_filter_.belief();
}

void FrameLoop::rearrange(const CommandRecord& granted) {
  ReorientationRecord& record = record_.reorientation.emplace();
  record.reorientation = granted.request.reorientation;
  record.issuer = granted.request.issuer;
  record.belief_before = pose_filter_.belief();
  if (record_.filled.has(Topic::pose_particles)) pose_filter_.append_poses(record_.pose_particles.before);
  switch (granted.request.reorientation) {
    case Reorientation::flip_pose:
      pose_filter_.flip_pose();
      if (room_) room_->on_flip();
      break;
    case Reorientation::purge_reflection:
      pose_filter_.purge_reflection();
      if (room_) room_->on_purge();
      break;
    case Reorientation::reset_orientation:
      pose_filter_.reset_orientation();
      if (room_) room_->on_reset();
      break;
  }
  // After a reset nobody knows the orientation; a flip or a purge says that the room, or somebody, has told it.
  world_.pose_known = granted.request.reorientation != Reorientation::reset_orientation;
  record.belief_after = pose_filter_.belief();
}

void FrameLoop::answer() {
  Answer& answer = record_.answer;
  answer.request = behaviors_.wanted().request;
  answer.reorientation.reset();
  if (record_.reorientation) answer.reorientation = record_.reorientation->reorientation;
  answer.room = {world_.confidence.current, world_.confidence.opposite};
  answer.training_paused = !arbiter_.last().train;
  answer.evaluation_paused = !arbiter_.last().evaluate;
}

void FrameLoop::complete_record() {
  const StageTimer timer(record_, Stage::record);
  record_.names = behaviors_.host().names().table();
  record_.inputs.body = observation_->body;
  record_.inputs.odometry = observation_->odometry;
  record_.inputs.body_samples = static_cast<int>(observation_->body_samples.size());
  record_.inputs.reported_posture = observation_->reported_posture;
  record_.inputs.external_belief = observation_->belief.has_value();
  record_.world = world_;
  behaviors_.host().read_status(record_.machines);
  const ScriptOutput& said = behaviors_.said();
  record_.transitions.assign(said.transitions.begin(), said.transitions.end());
  record_.logs.assign(said.logs.begin(), said.logs.end());
  record_.faults.assign(said.faults.begin(), said.faults.end());
  record_.commands.assign(arbiter_.last().commands.begin(), arbiter_.last().commands.end());
  record_.begun.assign(arbiter_.last().begun.begin(), arbiter_.last().begun.end());
  record_.leases.assign(behaviors_.leases().begin(), behaviors_.leases().end());

  if (record_.filled.has(Topic::images)) {
    record_.images.upper = observation_->upper ? observation_->upper->image : ImageView();
    record_.images.lower = observation_->lower ? observation_->lower->image : ImageView();
  }
  if (record_.filled.has(Topic::pose_particles)) {
    record_.pose_particles.particles.clear();
    pose_filter_.append_poses(record_.pose_particles.particles);
  }
  if (record_.filled.has(Topic::room)) fill_room();
  if (record_.filled.has(Topic::conditions)) behaviors_.host().read_conditions(record_.conditions);
  if (record_.filled.has(Topic::parameters)) record_.parameters = registry_.list();
  if (record_.filled.has(Topic::costs)) behaviors_.host().read_costs(record_.costs.machines);
}

void FrameLoop::fill_room() {
  if (!room_) return;
  RoomRecord& record = record_.room;
  record.wall = parameters_.room.wall;
  record.half_width = parameters_.room.confidence.half_width;
  record.goal_half_width = parameters_.room.confidence.goal_half_width;
  record.center_of_view = room_->center_of_view();
  record.light = room_->light();
  record.model.assign(room_->model().tiles().begin(), room_->model().tiles().end());
  record.perceived.assign(room_->perceived().begin(), room_->perceived().end());
  record.particles.assign(room_->particles().begin(), room_->particles().end());
  record.clusters.assign(room_->clusters().begin(), room_->clusters().end());
}

}  // namespace reorient
