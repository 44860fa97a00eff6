// SPDX-License-Identifier: MIT
#include "engine/frame.h"

#include <stdexcept>
#include <utility>

#include "engine/stage_timer.h"
#include "geometry/settable_pose.h"

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
      body_(setup.body),
      field_vision_{FieldFeatures(parameters_.field_features, checked(setup.field)),
                    FieldFeatures(parameters_.field_features, setup.field)},
      localizer_(parameters_.localizer, setup.field, setup.seed),
      external_reader_(setup.field),
      carried_{.world = WorldTracker(setup.field, body_, setup.room_awareness),
               .application = ApplicationState(std::move(setup.application))},
      behaviors_(std::move(setup.scripts), carried_.application, registry_, limits_) {
  arbiter_.set_parameters(parameters_.arbiter);
  for (FieldPercept& percept : record_.percepts) percept.reserve();
  for (FeatureFits& fits : record_.feature_fits) fits.reserve(record_.percepts[0]);
  covered_.reserve(record_.percepts[0].obstacles.capacity() + record_.percepts[0].goal_posts.capacity());
  if (setup.room_awareness) room_.emplace(parameters_.room, setup.seed);
  if (room_ && setup.model) {
    room_->take_model(*setup.model);
    carried_.world.set_trained_seconds(setup.model->learned);
    const std::optional<KnownBias>& known = setup.model->camera_bias;
    if (known && known->body == world().body) localizer_.set_bias(known->bias);
  }
  for (const std::string& behavior : setup.behaviors) behaviors_.host().load(behavior);
  record_.names = behaviors_.host().names().table();
  record_.application.take(carried_.application);
}

/// Runs before the modules are constructed, so that they start with the overridden values.
std::uint64_t FrameLoop::declare_parameters(const std::vector<ParameterChange>& overrides) {
  for (const ParameterChange& change : overrides) registry_.set_early(change);
  declare(parameters_, registry_);
  registry_.bind("script", limits_);
  return registry_.revision();
}

const FrameRecord& FrameLoop::step(const FrameInputs& inputs, Topics requested) {
  const Observation& observation = inputs.observation;
  record_.filled = Topics::always() | requested;
  take_inputs(inputs);
  const BodySample felt = latest_sample(observation);
  follow_posture(sense_posture(observation, felt, body_, carried_.get_up_requested, parameters_.posture, posture_),
                 felt);
  const CameraPercepts seen = see_field(observation);
  localize(observation, seen);
  see_room(observation, seen);
  carried_.world.take_field(summary_of(record_.percepts, observation.body.head));
  describe_room();
  const Decision decision = act();
  fill_answer(world(), decision, record_.reorientation, record_.answer);
  record_.answer.actions.assign(carried_.application.started().begin(), carried_.application.started().end());
  carried_.get_up_requested = record_.answer.request.get_up;
  carried_.odometry = observation.odometry;
  complete_record(observation, decision);
  carried_.world.take_request(record_.answer.request);
  return record_;
}

void FrameLoop::take_inputs(const FrameInputs& inputs) {
  const StageTimer timer(record_, Stage::inputs);
  const Observation& observation = inputs.observation;
  record_.inputs.initial_pose.reset();
  record_.inputs.messages.clear();
  record_.logs.clear();
  take_parameters(inputs.parameter_changes);
  record_.reloads.clear();
  if (!inputs.script_edits.empty())
    record_.reloads = behaviors_.apply(inputs.script_edits, arbiter_, carried_.application);
  carried_.world.begin_frame(observation.time);
  carried_.application.begin_frame(observation.time);
  record_.inputs.half_time = observation.external.half_time || inputs.external.half_time;
  if (record_.inputs.half_time) change_sides();
  for (const ExternalInputs* const external : {&observation.external, &inputs.external})
    take_external_inputs(*external, observation.belief.has_value());
}

void FrameLoop::take_parameters(const std::vector<ParameterChange>& changes) {
  record_.parameter_changes.clear();
  for (const ParameterChange& change : changes) record_.parameter_changes.push_back(registry_.change(change));
  if (revision_ == registry_.revision()) return;
  revision_ = registry_.revision();
  for (FieldFeatures& features : field_vision_) features.set_parameters(parameters_.field_features);
  localizer_.set_parameters(parameters_.localizer);
  if (room_ && room_->set_parameters(parameters_.room)) carried_.world.set_trained_seconds(0.0);
  arbiter_.set_parameters(parameters_.arbiter);
}

void FrameLoop::take_external_inputs(const ExternalInputs& external, bool has_external_belief) {
  if (external.referee) carried_.world.take_referee(*external.referee);
  std::vector<Message>& messages = record_.inputs.messages;
  for (const Message& message : external.messages) {
    if (messages.size() < kMostMessages) messages.push_back({message.sender, message.text.substr(0, kLongestMessage)});
  }
  for (const std::string& note : external.notes) {
    if (record_.logs.size() < kMostNotes) record_.logs.push_back({0, 0, note.substr(0, kLongestNote), 0, true});
  }
  take_application(external);
  if (!external.initial_pose) return;
  if (const std::string mistake = mistake_in_pose(external.initial_pose->pose); !mistake.empty()) {
    record_.logs.push_back({0, 0, "initial pose ignored: " + mistake, 0, true});
    return;
  }
  set_pose(*external.initial_pose, has_external_belief);
}

void FrameLoop::take_application(const ExternalInputs& external) {
  std::vector<std::string> mistakes;
  carried_.application.take(external.values, world().time, mistakes);
  carried_.application.take(external.reports, world().time);
  for (std::string& mistake : mistakes) record_.logs.push_back({0, 0, std::move(mistake), 0, true});
}

void FrameLoop::set_pose(const InitialPose& initial, bool has_external_belief) {
  record_.inputs.initial_pose = initial;
  if (repeated_pose_.note_set(initial.pose, world().pose.pose, world().time, parameters_.repeated_pose) && room_) {
    room_->rotate_by_180_degrees();
    record_.logs.push_back({0, 0, "a set pose undoes a flip: the learned room is rotated by 180 degrees", 0, true});
  }
  // It is newer than the last belief of the external localization.
  if (!has_external_belief) carried_.external.in_use = false;
  localizer_.set_initial_pose(initial.pose, initial.position_deviation, initial.rotation_deviation);
  carried_.world.take_initial_pose();
  if (room_) room_->restart();
}

/// Half-time: the axes are the team's, so belief and room get the coordinates of the mirrored pose.
/// An external localization mirrors its belief itself.
void FrameLoop::change_sides() {
  carried_.world.change_sides();
  localizer_.flip_pose();
  repeated_pose_.forget();
  if (room_) room_->rotate_by_180_degrees();
}

/// A robot that fell or was lifted may stand elsewhere, so earlier observations are not valid.
void FrameLoop::follow_posture(const SensedPosture& posture, const BodySample& body) {
  localizer_.feel_gravity(posture.now == Posture::upright, body.acceleration, body.torso, body.time);
  record_.posture_change.reset();
  if (posture.now != world().posture) record_.posture_change = {world().posture, posture.now};
  const bool has_changed = carried_.world.take_posture(posture);
  if (world().disturbed()) repeated_pose_.forget();
  if (has_changed && !world().disturbed()) localizer_.doubt(world().time);
  if (room_ && has_changed) room_->restart();
}

CameraPercepts FrameLoop::see_field(const Observation& observation) {
  const StageTimer timer(record_, Stage::field);
  return reorient::see_field(observation, world(), localizer_.bias(), parameters_, field_vision_, record_.inputs,
                             record_.percepts);
}

/// After a jump of the belief the confidences restart, since they were computed for the old belief.
void FrameLoop::localize(const Observation& observation, const CameraPercepts& seen) {
  const StageTimer timer(record_, Stage::localization);
  const Pose2 odometry_step = carried_.odometry ? carried_.odometry->inverse() * observation.odometry : Pose2();
  std::optional<SensedBelief> sensed =
      read_external_belief(observation, world(), odometry_step, parameters_, external_reader_, carried_.external);
  if (!external_reader_.poses().empty()) carried_.world.take_pose_known(sensed->tracked);
  if (!sensed) sensed = locate_ourselves(observation, seen, odometry_step);
  const BeliefJump jump = carried_.world.take_belief(*sensed, odometry_step, parameters_.localizer.filter.clusters);
  if (room_ && jump == BeliefJump::to_reflection) room_->on_flip();
  if (room_ && jump == BeliefJump::elsewhere) room_->on_reset();
}

SensedBelief FrameLoop::locate_ourselves(const Observation& observation, const CameraPercepts& seen,
                                         const Pose2& odometry_step) {
  if (std::exchange(carried_.external.in_use, false)) localizer_.continue_from(world().pose);
  SensedBelief sensed =
      localizer_.update(localizer_inputs(observation, world(), odometry_step, seen, room_, parameters_));
  carried_.world.take_camera_bias(localizer_.bias());
  return sensed;
}

void FrameLoop::see_room(const Observation& observation, const CameraPercepts& seen) {
  const StageTimer timer(record_, Stage::room);
  carried_.world.permit_views(arbiter_.last(), !record_.inputs.initial_pose.has_value());
  record_.inputs.room_camera.reset();
  if (room_) record_.inputs.room_camera = look_at_room(observation, seen, world(), covered_, *room_);
  if (record_.inputs.room_camera) carried_.world.take_view();
}

void FrameLoop::describe_room() {
  if (room_) carried_.world.take_room(room_->confidences(), room_->informative_views());
  carried_.world.judge_room(parameters_.room_status);
}

/// From this stage on, belief and room are those after the granted reorientation, if any.
Decision FrameLoop::act() {
  const StageTimer timer(record_, Stage::behaviors);
  const Decision decision = decide(world(), record_.inputs.messages, behaviors_, arbiter_);
  carried_.application.start(decision.requests.actions, world().time);
  record_.reorientation.reset();
  record_.pose_particles.before.clear();
  if (room_ && record_.filled.has(Topic::room)) room_->tile_evidence(record_.room.evidence);
  if (!decision.arbitration.granted) return decision;
  if (record_.filled.has(Topic::pose_particles)) append_poses(record_.pose_particles.before);
  record_.reorientation =
      apply(*decision.arbitration.granted, carried_.external.in_use, parameters_.localizer.filter.clusters, localizer_,
            room_, repeated_pose_, carried_.world);
  describe_room();
  return decision;
}

void FrameLoop::append_poses(std::vector<Pose2>& poses) const {
  reorient::append_poses(carried_.external, external_reader_, localizer_, world().pose.pose, poses);
}

}  // namespace reorient
