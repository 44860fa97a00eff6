#include "program/run/simulated_run.h"

#include "workbench/files/field_file.h"
#include "workbench/files/home.h"

namespace reorient {
namespace {

void obey(const ExperimenterAction& action, Experimenter& experimenter) {
  using Kind = ExperimenterAction::Kind;
  switch (action.kind) {
    case Kind::pick_up:
      experimenter.pick_up();
      break;
    case Kind::put_down:
      experimenter.put_down(action.pose);
      break;
    case Kind::push_over:
      experimenter.push_over();
      break;
    case Kind::penalize:
      experimenter.penalize(action.penalized);
      break;
    case Kind::set_exposure_compensation:
      experimenter.set_exposure_compensation(action.stops);
      break;
    case Kind::set_initial_pose:
      break;  // said to the robot, not done to it: the frame loop's
  }
}

}  // namespace

SimulatedRun::SimulatedRun(const SimulationOptions& options) : longest_(options.seconds), tuning_(options.width) {
  tuning_.override_by(options.parameters);
  scripts_ = std::make_unique<ScriptHost>(options.scripts, tuning_.registry, tuning_.script);
  for (const std::string& behavior : options.with) scripts_->load_behavior(behavior);
  scripts_->load_scenario(options.scenario);
  tuning_.require_all_claimed();
  const FieldDimensions field =
      load_field(options.field.empty() ? find_home() / "assets" / "fields" / "spl.toml" : options.field);
  room_ = std::make_unique<Room>(options.room.empty() ? procedural_hall(options.hall, tuning_.room_shape)
                                                      : load_room(options.room, tuning_.room_shape));
  const Pose2 beside_the_field(-field.penalty_mark_x, -0.5 * field.width - 0.5, kPi / 2.0);
  simulator_ = std::make_unique<Simulator>(tuning_.simulator, field, *room_, beside_the_field, options.seed);
  timed_robot_ = std::make_unique<TimedRobot>(*simulator_);
  frame_ = std::make_unique<FrameLoop>(*timed_robot_, *scripts_, tuning_.core, field,
                                       FrameOptions{options.seed, options.room_awareness});
}

bool SimulatedRun::step() {
  if (verdict() || frame_->world().time >= longest_ || !frame_->step()) return false;
  for (const ExperimenterAction& action : frame_->script_output().actions) obey(action, *simulator_);
  return true;
}

}  // namespace reorient
