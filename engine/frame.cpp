#include "engine/frame.h"

#include <algorithm>
#include <stdexcept>

#include "engine/covered_areas.h"
#include "engine/stage_timer.h"

namespace reorient {
namespace {

const FieldDimensions& checked(const FieldDimensions& field) {
  if (const std::string mistake = mistake_in(field); !mistake.empty()) throw std::runtime_error("field: " + mistake);
  return field;
}

}  // namespace

FrameLoop::FrameLoop(FrameSetup setup)
    : parameters_(core_parameters_for(setup.field, setup.body)),
      revision_(declare_parameters(setup.parameters)),
      field_features_{FieldFeatures(parameters_.field_features, checked(setup.field)),
                      FieldFeatures(parameters_.field_features, setup.field)},
      pose_filter_(parameters_.pose_filter, setup.field, setup.seed),
      pose_tracker_(parameters_.pose_tracker, setup.field),
      pose_search_(parameters_.pose_search, setup.field, setup.seed),
      body_(setup.body),
      external_reader_(setup.field),
      behaviors_(std::move(setup.scripts), registry_, limits_),
      world_tracker_(setup.field, body_, setup.room_awareness) {
  arbiter_.set_parameters(parameters_.arbiter);
  for (FieldPercept& percept : record_.percepts) percept.reserve();
  covered_.reserve(record_.percepts[kUpper].obstacles.capacity() + record_.percepts[kUpper].goal_posts.capacity());
  if (setup.room_awareness) room_.emplace(parameters_.room, setup.seed);
  if (room_ && setup.model) {
    room_->take_model(*setup.model);
    world_tracker_.set_trained_seconds(setup.model->learned);
    const std::optional<KnownBias>& known = setup.model->camera_bias;
    if (known && known->body == world().body) pose_tracker_.set_bias(known->bias);
  }
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
  feel_body();
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
  record_.inputs.messages.clear();
  record_.logs.clear();
  take_parameters(inputs.parameter_changes);
  record_.reloads.clear();
  if (!inputs.script_edits.empty()) record_.reloads = behaviors_.apply(inputs.script_edits, arbiter_);
  world_tracker_.begin_frame(observation_->time);
  record_.inputs.half_time = observation_->told.half_time || inputs.told.half_time;
  if (record_.inputs.half_time) change_sides();
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
  pose_tracker_.set_parameters(parameters_.pose_tracker);
  pose_search_.set_parameters(parameters_.pose_search);
  if (room_ && room_->set_parameters(parameters_.room)) world_tracker_.set_trained_seconds(0.0);
  arbiter_.set_parameters(parameters_.arbiter);
}

void FrameLoop::take_told(const Told& told) {
  if (told.referee) world_tracker_.take_referee(*told.referee);
  std::vector<Message>& messages = record_.inputs.messages;
  for (const Message& message : told.messages) {
    if (messages.size() < kMostMessages) messages.push_back({message.sender, message.text.substr(0, kLongestMessage)});
  }
  for (const std::string& note : told.notes) {
    if (record_.logs.size() < kMostNotes) record_.logs.push_back({0, 0, note.substr(0, kLongestNote), 0, true});
  }
  if (!told.initial_pose) return;
  record_.inputs.initial_pose = told.initial_pose;
  const InitialPose& initial = *told.initial_pose;
  if (repeated_pose_.note_set(initial.pose, world().pose.pose, world().time, parameters_.repeated_pose) && room_) {
    room_->turn_half();
    record_.logs.push_back(
        {0, 0, "a set pose undoes a flip: the room that was learned is turned by half a turn", 0, true});
  }
  if (!observation_->belief) external_belief_ = false;  // the told pose is newer than what another localization said
  pose_filter_.set_initial_pose(initial.pose, initial.position_deviation, initial.rotation_deviation);
  pose_tracker_.attach(pose_filter_.belief());
  world_tracker_.take_initial_pose();
  if (room_) room_->begin_anew();
}

/// Only while the robot is upright: the mean acceleration of a fall or of a lift is not that of gravity.
void FrameLoop::feel_gravity(const BodySample& body) {
  if (posture_.posture() != Posture::upright) return gravity_bias_.interrupt();
  if (const auto torso = gravity_bias_.feel(body.acceleration, body.torso, body.time))
    pose_tracker_.take_gravity(*torso);
}

/// What the posture is, and since when nothing has put the belief in doubt.
void FrameLoop::feel_body() {
  const Posture before = posture_.posture();
  const PostureEstimator::Hints hints{observation_->reported_posture, asked_to_get_up_};
  for (const BodySample& sample : observation_->body_samples) {
    if (sample.time <= observation_->time) posture_.update(sample, body_.standing_load, hints, parameters_.posture);
  }
  BodySample body = observation_->body;
  if (body.time == 0.0) body.time = observation_->time;
  posture_.update(body, body_.standing_load, hints, parameters_.posture);
  feel_gravity(body);
  record_.posture_change.reset();
  if (posture_.posture() != before) record_.posture_change = {before, posture_.posture()};
  const bool has_changed = world_tracker_.take_posture({posture_.posture(), posture_.before(), posture_.since()});
  if (world().disturbed()) repeated_pose_.forget();
  if (has_changed && !world().disturbed()) {
    pose_filter_.doubt();
    pose_tracker_.doubt();
    pose_search_.forget_before(world().time);
  }
  if (room_ && has_changed) room_->begin_anew();
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
  const CameraBias bias = pose_tracker_.bias();
  const auto see = [&](const std::optional<CameraFrame>& frame, std::optional<CameraRecord>& camera,
                       std::size_t which) {
    FieldPercept& percept = record_.percepts[which];
    percept.clear();
    camera.reset();
    if (!frame) return;
    camera = CameraRecord{frame->time, frame->camera, corrected(frame->robot_from_camera, bias, which),
                          frame->image.width, frame->image.height};
    if (frame->time != observation_->time)
      camera->robot_from_camera = to_isometry(moved_since(*frame)) * camera->robot_from_camera;
    if (world().upright()) field_features_[which].find(frame->image, frame->camera, camera->robot_from_camera, percept);
  };
  see(observation_->upper, record_.inputs.upper, kUpper);
  see(observation_->lower, record_.inputs.lower, kLower);
}

void FrameLoop::look_at_room() {
  const StageTimer timer(record_, Stage::room);
  world_tracker_.permit_views(arbiter_.last(), !record_.inputs.initial_pose.has_value());
  record_.inputs.room_camera.reset();
  if (!room_ || (!observation_->upper && !observation_->lower)) return;
  // The upper camera sees more of the wall; the lower one is looked through where there is nothing else.
  const bool is_upper = observation_->upper.has_value();
  const CameraFrame& frame = is_upper ? *observation_->upper : *observation_->lower;
  const CameraRecord& camera = is_upper ? *record_.inputs.upper : *record_.inputs.lower;
  record_.inputs.room_camera = is_upper ? HeadCamera::upper : HeadCamera::lower;
  collect_covered(record_.percepts[is_upper ? kUpper : kLower], covered_);
  room_->update({.time = observation_->time,
                 .image = frame.image,
                 .camera = frame.camera,
                 .robot_from_camera = camera.robot_from_camera,
                 .belief = world().pose.pose,
                 .odometry_rotation = observation_->odometry.rotation,
                 .covered = covered_,
                 .train = world().training,
                 .evaluate = world().evaluating});
  world_tracker_.take_view();
}

void FrameLoop::describe_world() {
  SensedField seen{.head = observation_->body.head};
  for (const FieldPercept& percept : record_.percepts) {
    seen.goal_posts += static_cast<int>(percept.goal_posts.size());
    seen.line_points += static_cast<int>(percept.line_points.size());
    seen.intersections += static_cast<int>(percept.intersections.size());
    if (percept.ball) seen.ball = percept.ball->position;
  }
  world_tracker_.take_field(seen);
  describe_room();
}

void FrameLoop::describe_room() {
  if (room_) world_tracker_.take_room(room_->confidences(), room_->informative_views());
  world_tracker_.judge_room(parameters_.room_status);
}

void FrameLoop::decide() {
  const StageTimer timer(record_, Stage::behaviors);
  behaviors_.tick(world(), record_.inputs.messages);
  const Arbitration& arbitration = arbiter_.arbitrate(behaviors_.wanted().commands, behaviors_.leases(), world());
  record_.reorientation.reset();
  record_.pose_particles.before.clear();
  if (!arbitration.granted) return;
  rearrange(*arbitration.granted);
  describe_room();  // from here on, belief and room are those after the reorientation
}

void FrameLoop::answer() {
  Answer& answer = record_.answer;
  answer.request = permitted(behaviors_.wanted().request, world());
  answer.messages = behaviors_.wanted().messages;
  asked_to_get_up_ = answer.request.get_up;
  answer.belief = {world().pose.pose, world().pose.covariance, world().pose_known};
  answer.reorientation.reset();
  if (record_.reorientation) answer.reorientation = record_.reorientation->reorientation;
  answer.room = {world().confidence.current, world().confidence.opposite, world().confidence.evidence,
                 world().room_status == RoomStatus::usable};
  answer.training_paused = !arbiter_.last().train;
  answer.evaluation_paused = !arbiter_.last().evaluate;
}

}  // namespace reorient
