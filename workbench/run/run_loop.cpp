// SPDX-License-Identifier: MIT
#include "workbench/run/run_loop.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// For actions that only add inputs, to a robot without an operator.
class NoOperator : public Operator {
  void pick_up() override {}
  void put_down(const Pose2& /*where*/) override {}
  void push_over() override {}
  void penalize(bool /*penalized*/) override {}
  void set_exposure_compensation(double /*stops*/) override {}
  void change_light() override {}
};

}  // namespace

RunLoop::RunLoop(RunParts parts) : parts_(std::move(parts)) {}

std::optional<RunEnd> RunLoop::is_over() const {
  // Wait for the first frame, because without it there is no record and no picture.
  if (any_frame_ && parts_.stop && parts_.stop()) return RunEnd::stopped;
  if (scene_.scenario.verdict && !(parts_.continues && parts_.continues())) return RunEnd::verdict;
  const double time = parts_.engine.record().world.time - first_time_;
  if (any_frame_ && parts_.longest > 0.0 && time >= parts_.longest) return RunEnd::time_up;
  return std::nullopt;
}

std::optional<RunEnd> RunLoop::step() {
  if (const std::optional<RunEnd> end = is_over()) return end;
  carry_out_requests();
  const Clock::time_point begin = Clock::now();
  if (!parts_.robot.robot->observe(inputs_.observation)) return RunEnd::robot_gone;
  scene_.observing = seconds_since(begin);
  for (InputSource* source : parts_.sources) source->add_to(inputs_);
  Topics wanted;
  // In a pause, questions are answered from this frame.
  if (parts_.controls != nullptr && parts_.controls->pace().is_paused()) wanted = {Topic::conditions, Topic::costs};
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
  show_requests();
  if (parts_.controls != nullptr) parts_.controls->pace().count_frame();
  const Clock::time_point end = Clock::now();
  for (Observer* observer : parts_.observers) observer->observe(record, scene_);
  scene_.showing = seconds_since(end);
  if (parts_.in_real_time && parts_.robot.clock == RobotInstance::Clock::simulated) wait();
  return std::nullopt;
}

void RunLoop::carry_out_requests() {
  issued_.clear();
  actions_.clear();
  if (parts_.controls == nullptr || parts_.controls->waiting() == 0) return;
  issued_ = parts_.controls->take();
  const World& world = parts_.engine.record().world;
  // The scenario may have changed the sides for the coming frame.
  bool sides_changed = world.sides_changed != inputs_.external.half_time;
  NoOperator none;
  Operator& the_operator = parts_.robot.the_operator != nullptr ? *parts_.robot.the_operator : none;
  for (const auto& [request, issuer] : issued_) {
    OperatorAction action = request.action;
    if (request.mirrors) {
      const std::optional<GroundTruth> truth = parts_.robot.truth->truth();
      if (!truth) continue;
      action.pose = reflect(in_axes_of_team(truth->pose, sides_changed));
      actions_.push_back({OperatorAction::Kind::pick_up, {}, 0.0, false});
      carry_out(actions_.back(), the_operator, inputs_.external, sides_changed, world.referee);
    }
    actions_.push_back(action);
    carry_out(action, the_operator, inputs_.external, sides_changed, world.referee);
  }
}

/// Requests are shown as the actions and notes of a scenario.
void RunLoop::show_requests() {
  if (parts_.scenario == nullptr && !scene_.scenario.logs.empty()) scene_.scenario = {};  // of the frame before
  if (issued_.empty()) return;
  ScenarioRecord& scenario = scene_.scenario;
  auto names = std::make_shared<NameTable>(*scenario.names);
  for (const auto& [request, issuer] : issued_) {
    const std::optional<NameId> known = names->find(issuer);
    if (!known) names->names.emplace_back(issuer);
    const NameId name = known.value_or(static_cast<NameId>(names->names.size() - 1));
    scenario.logs.push_back({name, kNoName, request.text(), 0, true});
  }
  scenario.names = std::move(names);
  scenario.actions.insert(scenario.actions.end(), actions_.begin(), actions_.end());
}

void RunLoop::play_scenario() {
  const FrameRecord& record = parts_.engine.record();
  parts_.behaviors->show(*record.names, record.machines, record.published, record.world.time);
  bool sides_changed = record.world.sides_changed;
  std::optional<BallTruth> ball = parts_.robot.truth != nullptr ? parts_.robot.truth->true_ball() : std::nullopt;
  if (ball) ball = score_.count(*ball, sides_changed);
  scene_.scenario = parts_.scenario->tick({record.world, record.application, scene_.truth, ball});
  for (const OperatorAction& action : scene_.scenario.actions)
    carry_out(action, *parts_.robot.the_operator, inputs_.external, sides_changed, record.world.referee);
}

RunEnd RunLoop::run() {
  std::optional<RunEnd> end;
  while (!(end = parts_.controls != nullptr && !parts_.controls->pace().permits_frame() ? rest() : step())) {
  }
  if (any_frame_) {
    for (Observer* observer : parts_.observers) observer->finish(parts_.engine.record(), scene_);
  }
  return *end;
}

/// A short part of a pause, in which requests of the user are taken.
std::optional<RunEnd> RunLoop::rest() {
  if (const std::optional<RunEnd> end = is_over()) return end;
  for (InputSource* source : parts_.sources) source->add_while_paused(inputs_, parts_.engine.record(), scene_);
  constexpr std::chrono::milliseconds kShortRest{10};
  if (!parts_.controls->pace().permits_frame()) std::this_thread::sleep_for(kShortRest);
  return std::nullopt;
}

void RunLoop::wait() {
  RunPace& pace = parts_.controls != nullptr ? parts_.controls->pace() : real_time_;
  const Clock::time_point due = pace.due(parts_.engine.record().world.time);
  // In parts, because a slow run with few images would not end for minutes.
  constexpr std::chrono::milliseconds kPart{100};
  while (Clock::now() < due && !(parts_.stop && parts_.stop()))
    std::this_thread::sleep_until(std::min(due, Clock::now() + kPart));
}

}  // namespace reorient
