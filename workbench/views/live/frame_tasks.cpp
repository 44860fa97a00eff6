// SPDX-License-Identifier: MIT
#include "workbench/views/live/frame_tasks.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"

namespace reorient::live {
namespace {

constexpr std::size_t kMostChanges = 200;    // of a request, because they take time of a frame
constexpr std::size_t kMostSuggestions = 3;  // of names, for the same reason
constexpr std::size_t kMostDelayed = 200;    // changes that wait for the next frame of a paused run

const Parameter* parameter_named(const std::vector<Parameter>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// Whether the record of the next frame contains the answer.
bool needs_frame(const FrameTask& task) {
  return std::holds_alternative<ChangeParameters>(task) || std::holds_alternative<UndoChange>(task) ||
         std::holds_alternative<AddNote>(task) || std::holds_alternative<ReloadScripts>(task);
}

std::string unknown_text(const std::vector<Parameter>& all, const std::string& name, bool suggests) {
  constexpr std::size_t kLongestName = 100;
  if (!suggests || name.size() > kLongestName)
    return "unknown parameter '" + as_line(name.substr(0, kLongestName)) + "'";
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Parameter& one : all) names.push_back(one.name);
  return "unknown parameter '" + as_line(name) + "'" + did_you_mean(name, names);
}

}  // namespace

void FrameTasks::begin(FrameRequest request, FrameInputs& inputs) {
  Pending pending{.to = std::move(request.to), .refused = {}, .changed = {}, .reply = {}, .machine = {}, .failure = {}};
  try {
    pending.needs_frame = needs_frame(request.task);
    if (pending.needs_frame && pending_.size() >= kMostDelayed)
      throw std::runtime_error("expected at most " + std::to_string(kMostDelayed) +
                               " requests that wait for the next frame, found more; resume the run first");
    std::visit([&](auto&& task) { start(std::forward<decltype(task)>(task), pending, inputs); },
               std::move(request.task));
  } catch (const std::runtime_error& error) {
    pending.failure = as_line(error.what());
    pending.needs_frame = false;
  }
  pending_.push_back(std::move(pending));
}

void FrameTasks::start(ListParameters&& /*task*/, Pending& /*pending*/, FrameInputs& /*inputs*/) {}

void FrameTasks::start(ChangeParameters&& task, Pending& pending, FrameInputs& inputs) {
  if (task.changes.size() > kMostChanges)
    throw std::runtime_error("expected at most " + std::to_string(kMostChanges) + " parameters in one request, found " +
                             std::to_string(task.changes.size()));
  const std::vector<Parameter> all = subject_.parameters();
  for (const ParameterText& wanted : task.changes) {
    const Parameter* const parameter = parameter_named(all, wanted.name);
    if (parameter == nullptr) {
      pending.refused.push_back(
          {wanted.name, "", unknown_text(all, wanted.name, pending.refused.size() < kMostSuggestions)});
    } else if (!wanted.value) {
      pending.refused.push_back({wanted.name, to_text(parameter->value),
                                 wanted.name + ": expected a value (" + range_text(*parameter) + "), found none"});
    } else {
      const ParameterChange change{wanted.name, *wanted.value, ParameterOrigin::live, ""};
      const std::uint64_t number = before_.add(change_back_to(*parameter, inputs));
      pending.changed.push_back({request_change(change, subject_.scenario, inputs), number});
    }
  }
}

void FrameTasks::start(UndoChange&& /*task*/, Pending& pending, FrameInputs& inputs) {
  const std::optional<ParameterChange> back = before_.take_last();
  if (!back) throw std::runtime_error("no change of a viewer to undo");
  pending.changed.push_back({request_change(*back, subject_.scenario, inputs), {}});
}

void FrameTasks::start(AddNote&& task, Pending& pending, FrameInputs& inputs) {
  pending.reads_parameters = false;
  inputs.external.notes.push_back(std::move(task.text));
}

void FrameTasks::start(ReloadScripts&& task, Pending& pending, FrameInputs& inputs) {
  pending.reads_parameters = false;
  pending.reloads = true;
  for (ScriptEdit& edit : task.edits) inputs.script_edits.push_back(std::move(edit));
}

void FrameTasks::start(AskPrompt&& task, Pending& pending, FrameInputs& /*inputs*/) {
  pending.reads_parameters = false;
  if (!subject_.ask) throw std::runtime_error("this run has no prompt");
  pending.reply = subject_.ask(task.words);
}

void FrameTasks::start(DescribeMachine&& task, Pending& pending, FrameInputs& /*inputs*/) {
  pending.reads_parameters = false;
  pending.machine = std::move(task.name);
}

void FrameTasks::describe_machine(const std::string& name, FrameAnswer& answer) const {
  const FrameLoop* const engine = subject_.engine ? subject_.engine() : nullptr;
  if (engine == nullptr) {
    answer.failure = "expected a robot with behaviors, found none";
    return;
  }
  std::vector<std::string> names;
  const auto find = [&](const std::vector<const MachineDefinition*>& machines, const ScriptTexts& texts) {
    for (const MachineDefinition* const machine : machines) {
      if (machine->name == name && !answer.machine)
        answer.machine = std::make_shared<const RunningMachine>(RunningMachine{*machine, texts});
      names.push_back(machine->name);
    }
  };
  find(engine->machines(), engine->scripts());
  if (subject_.scenario != nullptr) find(subject_.scenario->machines(), subject_.scenario->host().texts());
  if (!answer.machine) answer.failure = as_line("unknown machine '" + as_line(name) + "'" + did_you_mean(name, names));
}

RunControls& FrameTasks::controls() const {
  if (subject_.controls == nullptr) throw std::runtime_error("expected a run, found a replay");
  return *subject_.controls;
}

RunState FrameTasks::run_state() const {
  const RunControls* const controls = subject_.controls;
  if (controls == nullptr) return {};
  const RunPace& pace = controls->pace();
  return {controls->has_operator(), controls->sets_pace(), pace.is_paused(), pace.speed()};
}

void FrameTasks::start(ShowRun&& /*task*/, Pending& pending, FrameInputs& /*inputs*/) {
  pending.reads_parameters = false;
}

void FrameTasks::start(ActAsOperator&& task, Pending& pending, FrameInputs& /*inputs*/) {
  pending.reads_parameters = false;
  controls().request(std::move(task.request), kViewerName);
}

void FrameTasks::start(ChangePace&& task, Pending& pending, FrameInputs& /*inputs*/) {
  pending.reads_parameters = false;
  switch (task.change) {
    case ChangePace::Change::pause:
      return controls().change_pace("pause").pause();
    case ChangePace::Change::resume:
      return controls().change_pace("resume").resume();
    case ChangePace::Change::frame:
      return controls().take_frames(task.frames);
    case ChangePace::Change::speed:
      return controls().set_speed(task.speed);
  }
}

Topics FrameTasks::wanted() const {
  const bool any = std::any_of(pending_.begin(), pending_.end(), [](const Pending& one) { return bool(one.reply); });
  return any ? Topics{Topic::conditions, Topic::costs} : Topics();
}

/// False: it needs a later frame.
bool FrameTasks::complete(Pending& pending, const FrameRecord& frame, const SceneTruth& scene, FrameAnswer& answer) {
  answer.failure = pending.failure;
  if (pending.reply) {
    try {
      const std::optional<std::string> text = pending.reply(frame, scene);
      if (!text) return false;
      answer.text = *text;
    } catch (const std::runtime_error& error) {
      answer.failure = as_line(error.what());
    }
  }
  if (pending.machine) describe_machine(*pending.machine, answer);
  answer.outcomes = pending.refused;
  for (const PendingChange& changed : pending.changed) {
    answer.outcomes.push_back(outcome_of_change(changed.change, frame));
    if (changed.number && !answer.outcomes.back().refusal.empty()) before_.remove(*changed.number);
  }
  if (pending.reloads) {
    for (const auto* reloads : {&frame.reloads, &scene.scenario.reloads})
      answer.reloads.insert(answer.reloads.end(), reloads->begin(), reloads->end());
  }
  return true;
}

/// False: it needs a later frame.
bool FrameTasks::append_answer(Pending& pending, const FrameRecord& frame, const SceneTruth& scene,
                               std::vector<FrameAnswer>& answers) {
  FrameAnswer answer{.to = pending.to, .time = frame.world.time};
  if (!complete(pending, frame, scene, answer)) return false;
  answer.run = run_state();
  if (pending.reads_parameters) {
    // Several answers share one list.
    const bool is_read = !answers.empty() && answers.back().parameters && answers.back().time == answer.time;
    answer.parameters =
        is_read ? answers.back().parameters : std::make_shared<const std::vector<Parameter>>(subject_.parameters());
    if (subject_.kept_parameters) answer.kept = subject_.kept_parameters();
  }
  answers.push_back(std::move(answer));
  return true;
}

void FrameTasks::answer(const FrameRecord& frame, const SceneTruth& scene, std::vector<FrameAnswer>& answers) {
  std::erase_if(pending_, [&](Pending& pending) { return append_answer(pending, frame, scene, answers); });
}

void FrameTasks::answer_while_paused(const FrameRecord& last, const SceneTruth& scene,
                                     std::vector<FrameAnswer>& answers) {
  std::erase_if(pending_,
                [&](Pending& pending) { return !pending.needs_frame && append_answer(pending, last, scene, answers); });
  for (Pending& pending : pending_) {
    if (!pending.needs_frame || pending.is_told) continue;
    const bool knows = std::any_of(pending_.begin(), pending_.end(), [&](const Pending& other) {
      return other.is_told && other.to.viewer == pending.to.viewer;
    });
    pending.is_told = true;
    if (!knows) answers.push_back({.to = pending.to, .is_delayed = true});
  }
}

FrameAnswer FrameTasks::refuse(const FrameRequest& request, const std::string& reason) const {
  FrameAnswer answer{.to = request.to, .run = run_state()};
  if (const auto* const task = std::get_if<DescribeMachine>(&request.task)) {
    describe_machine(task->name, answer);
  } else if (!std::holds_alternative<ListParameters>(request.task) && !std::holds_alternative<ShowRun>(request.task)) {
    answer.failure = reason;
  }
  answer.parameters = std::make_shared<const std::vector<Parameter>>(subject_.parameters());
  return answer;
}

}  // namespace reorient::live
