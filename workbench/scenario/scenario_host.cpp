// SPDX-License-Identifier: MIT
#include "workbench/scenario/scenario_host.h"

#include <algorithm>
#include <utility>

namespace reorient {

bool RecordedBehaviors::look_up(std::string_view name, MachineSight& sight) const {
  if (machines_ == nullptr) return false;
  for (const MachineStatus& status : *machines_) {
    if ((*names_)[status.machine] != name) continue;
    sight = {(*names_)[status.state], time_ - status.entered_at};
    return true;
  }
  return false;
}

bool RecordedBehaviors::is_published(std::string_view flag) const {
  if (published_ == nullptr) return false;
  return std::any_of(published_->begin(), published_->end(), [&](NameId id) { return (*names_)[id] == flag; });
}

ScenarioHost::ScenarioHost(ScriptTexts texts, const std::string& name, const std::vector<ParameterChange>& parameters,
                           const MachineDirectory& behaviors, std::uint64_t seed)
    : language_(seed), host_(std::move(texts), language_, parameters_, kDefaultLimits, &behaviors) {
  for (const ParameterChange& change : parameters) parameters_.set_early(change);
  host_.load(name);
  record_.names = host_.names().table();
}

std::vector<std::string> ScenarioHost::wanted_behaviors() const {
  std::vector<std::string> all;
  for (const MachineDefinition* machine : host_.definitions())
    all.insert(all.end(), machine->behaviors.begin(), machine->behaviors.end());
  return all;
}

ScenarioSetting ScenarioHost::setting() const {
  const std::vector<const MachineDefinition*> machines = host_.definitions();
  return machines.empty() ? ScenarioSetting() : machines.front()->setting;
}

const ScenarioRecord& ScenarioHost::tick(const ScenarioView& view) {
  values_.clear();
  append_scenario_world(view.world, view.truth, view.ball, values_);
  language_.actions().set_application(view.application);
  const ScriptOutput& said = host_.tick(view.world.time, values_);
  record_.names = host_.names().table();
  host_.read_status(record_.machines);
  record_.transitions.assign(said.transitions.begin(), said.transitions.end());
  record_.logs.assign(said.logs.begin(), said.logs.end());
  record_.faults.assign(said.faults.begin(), said.faults.end());
  record_.actions.assign(language_.actions().actions().begin(), language_.actions().actions().end());
  record_.verdict = language_.actions().verdict();
  record_.reloads = std::exchange(reloads_, {});
  return record_;
}

void ScenarioHost::apply(std::span<const ScriptEdit> edits) {
  for (ReloadRecord& reload : host_.apply(edits)) reloads_.push_back(std::move(reload));
}

std::optional<ParameterOutcome> ScenarioHost::change(const ParameterChange& change) {
  if (parameters_.find(change.name) == nullptr) return std::nullopt;
  return parameters_.change(change);
}

void carry_out(const OperatorAction& action, Operator& the_operator, ExternalInputs& external, bool& sides_changed,
               const RefereeState& referee) {
  const auto said = [&]() -> RefereeState& {
    return external.referee ? *external.referee : external.referee.emplace(referee);
  };
  using Kind = OperatorAction::Kind;
  switch (action.kind) {
    case Kind::pick_up:
      return the_operator.pick_up();
    case Kind::put_down:
      return the_operator.put_down(in_axes_of_team(action.pose, sides_changed));
    case Kind::push_over:
      return the_operator.push_over();
    case Kind::put_ball:
      return the_operator.put_ball(in_axes_of_team(action.pose, sides_changed).position);
    case Kind::penalize:
      said().penalized = action.penalized;
      return the_operator.penalize(action.penalized);
    case Kind::set_exposure_compensation:
      return the_operator.set_exposure_compensation(action.stops);
    case Kind::change_light:
      return the_operator.change_light();
    case Kind::set_initial_pose:
      external.initial_pose = InitialPose{action.pose};
      return;
    case Kind::tell_message:
      external.messages.push_back(action.message);
      return;
    case Kind::set_game_state:
      said().state = action.referee.state;
      return;
    case Kind::stop_game:
      said().stopped = action.referee.stopped;
      return;
    case Kind::set_kick_off:
      said().kick_off = action.referee.kick_off;
      return;
    case Kind::set_input:
      external.values.push_back(action.value);
      return;
    case Kind::report_action:
      external.reports.push_back(action.report);
      return;
    case Kind::half_time:
      sides_changed = !sides_changed;
      external.half_time = !external.half_time;
      if (external.initial_pose) external.initial_pose->pose = reflect(external.initial_pose->pose);  // set just before
  }
}

BallTruth TeamScore::count(const BallTruth& now, bool sides_changed) {
  int at_positive_x = now.goals - last_.goals;
  int at_negative_x = now.opponents_goals - last_.opponents_goals;
  last_ = now;
  if (sides_changed) std::swap(at_positive_x, at_negative_x);
  team_.goals += at_positive_x;
  team_.opponents_goals += at_negative_x;
  team_.position = sides_changed ? Eigen::Vector2d(-now.position) : now.position;
  return team_;
}

}  // namespace reorient
