// SPDX-License-Identifier: MIT
// Fills the parts of a frame's record that the stages have not filled already.
#include "engine/frame.h"
#include "engine/stage_timer.h"

namespace reorient {

void FrameLoop::complete_record(const Observation& observation, const Decision& decision) {
  const StageTimer timer(record_, Stage::record);
  record_.names = behaviors_.host().names().table();
  record_.inputs.body = observation.body;
  record_.inputs.odometry = observation.odometry;
  record_.inputs.body_samples = static_cast<int>(observation.body_samples.size());
  record_.inputs.reported_posture = observation.reported_posture;
  record_.inputs.external_belief = carried_.external.in_use;
  record_.world = world();
  behaviors_.host().read_status(record_.machines);
  behaviors_.host().read_published(record_.published);
  const ScriptOutput& output = behaviors_.said();
  record_.transitions.assign(output.transitions.begin(), output.transitions.end());
  record_.logs.insert(record_.logs.end(), output.logs.begin(), output.logs.end());  // after notes of the operator
  record_.faults.assign(output.faults.begin(), output.faults.end());
  record_.commands.assign(decision.arbitration.commands.begin(), decision.arbitration.commands.end());
  record_.begun.assign(decision.arbitration.begun.begin(), decision.arbitration.begun.end());
  record_.leases.assign(behaviors_.leases().begin(), behaviors_.leases().end());
  record_.claims.assign(behaviors_.claims().begin(), behaviors_.claims().end());
  record_.application.take(carried_.application);

  if (record_.filled.has(Topic::images)) {
    record_.images.upper = observation.upper ? observation.upper->image : ImageView();
    record_.images.lower = observation.lower ? observation.lower->image : ImageView();
  }
  if (record_.filled.has(Topic::pose_particles)) {
    record_.pose_particles.particles.clear();
    append_poses(record_.pose_particles.particles);
  }
  if (record_.filled.has(Topic::feature_fits)) fill_feature_fits();
  if (record_.filled.has(Topic::room)) fill_room();
  if (record_.filled.has(Topic::conditions)) behaviors_.host().read_conditions(record_.conditions);
  if (record_.filled.has(Topic::parameters) && listed_revision_ != registry_.revision()) {
    listed_revision_ = registry_.revision();
    record_.parameters = registry_.list();
  }
  if (record_.filled.has(Topic::costs)) behaviors_.host().read_costs(record_.costs.machines);
}

void FrameLoop::fill_feature_fits() {
  const Pose2& believed = record_.reorientation ? record_.reorientation->belief_before.pose : world().pose.pose;
  for (std::size_t i = 0; i < record_.percepts.size(); ++i) {
    FeatureFits& fits = record_.feature_fits[i];
    fits.clear();
    if (!carried_.external.in_use) localizer_.feature_fits(record_.percepts[i], believed, fits);
  }
}

void FrameLoop::fill_room() {
  if (!room_) return;
  RoomRecord& record = record_.room;
  record.basis = room_->basis();
  record.half_width = parameters_.room.confidence.half_width;
  record.goal_half_width = parameters_.room.confidence.goal_half_width;
  record.center_of_view = room_->center_of_view();
  record.light = room_->light();
  record.model.assign(room_->model().tiles().begin(), room_->model().tiles().end());
  record.perceived.clear();
  record.perceived.reserve(record.model.size());
  record.compared.clear();
  record.compared.reserve(record.model.size());
  if (record_.inputs.room_camera) {
    record.perceived.assign(room_->perceived().begin(), room_->perceived().end());
    record.compared.assign(room_->scores().places().begin(), room_->scores().places().end());
  }
  const ViewFilter& filter = room_->view_filter();
  record.particles.assign(filter.particles().begin(), filter.particles().end());
  record.cells.clear();
  for (std::size_t i = 0; i < filter.grid().cells(); ++i) record.cells.push_back(filter.grid().cell(i));
  record.clusters.reserve(record.particles.size() + record.cells.size());
  record.clusters.assign(filter.clusters().begin(), filter.clusters().end());
}

}  // namespace reorient
