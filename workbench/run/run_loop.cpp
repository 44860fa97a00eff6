// SPDX-License-Identifier: MIT
#include "workbench/run/run_loop.h"

#include <thread>
#include <utility>

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

RunLoop::RunLoop(RunParts parts) : parts_(std::move(parts)), start_(Clock::now()) {}

std::optional<RunEnd> RunLoop::is_over() const {
  // Wait for the first frame, because without it there is no record and no picture.
  if (any_frame_ && parts_.stop && parts_.stop()) return RunEnd::stopped;
  if (scene_.scenario.verdict) return RunEnd::verdict;
  const double time = parts_.engine.record().world.time - first_time_;
  if (any_frame_ && parts_.longest > 0.0 && time >= parts_.longest) return RunEnd::time_up;
  return std::nullopt;
}

std::optional<RunEnd> RunLoop::step() {
  if (const std::optional<RunEnd> end = is_over()) return end;
  const Clock::time_point begin = Clock::now();
  if (!parts_.robot.robot->observe(inputs_.observation)) return RunEnd::robot_gone;
  scene_.observing = seconds_since(begin);
  for (InputSource* source : parts_.sources) source->add_to(inputs_);
  Topics wanted;
  for (Observer* observer : parts_.observers) observer->before(inputs_, parts_.engine);
  for (const Observer* observer : parts_.observers) wanted = wanted | observer->wanted();
  const FrameRecord& record = parts_.engine.step(inputs_, wanted);
  scene_.stepping = seconds_since(begin) - scene_.observing;
  parts_.robot.robot->answer(record.answer);
  if (!std::exchange(any_frame_, true)) first_time_ = record.world.time;
  if (parts_.robot.truth != nullptr) {
    scene_.truth = parts_.robot.truth->truth();
    if (scene_.truth) scene_.truth->pose = in_axes_of_team(scene_.truth->pose, record.world.sides_changed);
  }

  // Changes that were set now enter the next frame.
  const std::vector<ScriptEdit> edits = std::exchange(inputs_.script_edits, {});
  inputs_.parameter_changes.clear();
  inputs_.external = {};
  if (parts_.scenario != nullptr) {
    if (!edits.empty()) parts_.scenario->apply(edits);
    play_scenario();
  }
  for (Observer* observer : parts_.observers) observer->observe(record, scene_);
  if (parts_.in_real_time && parts_.robot.clock == RobotInstance::Clock::simulated) wait();
  return std::nullopt;
}

void RunLoop::play_scenario() {
  const FrameRecord& record = parts_.engine.record();
  parts_.behaviors->show(*record.names, record.machines, record.published, record.world.time);
  scene_.scenario = parts_.scenario->tick({record.world, scene_.truth});
  bool sides_changed = record.world.sides_changed;
  for (const OperatorAction& action : scene_.scenario.actions)
    carry_out(action, *parts_.robot.the_operator, inputs_.external, sides_changed, record.world.referee);
}

RunEnd RunLoop::run() {
  std::optional<RunEnd> end;
  while (!(end = step())) {
  }
  if (any_frame_) {
    for (Observer* observer : parts_.observers) observer->finish(parts_.engine.record(), scene_);
  }
  return *end;
}

void RunLoop::wait() const {
  const double time = parts_.engine.record().world.time - first_time_;
  std::this_thread::sleep_until(start_ +
                                std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time)));
}

}  // namespace reorient
