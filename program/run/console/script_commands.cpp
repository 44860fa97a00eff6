// SPDX-License-Identifier: MIT
#include "program/run/console/script_commands.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "program/run/console/name_pattern.h"
#include "program/run/console/world_commands.h"
#include "workbench/files/script_files.h"
#include "workbench/script_tools/graph/condition_fields.h"

namespace reorient {
namespace {

const char* stopped_text(const MachineStatus& status) { return status.stopped ? "  stopped after errors" : ""; }

std::string state_text(const MachineStatus& status, const NameTable& names, double now) {
  return fmt::format("  {:<22} {:<24} for {:6.1f} s{}", names[status.machine], names[status.state],
                     now - status.entered_at, stopped_text(status));
}

std::string states_text(const FrameRecord& frame, const SceneTruth& scene) {
  std::string text;
  for (std::size_t i = 0; i < frame.machines.size(); ++i) {
    text += state_text(frame.machines[i], *frame.names, frame.world.time);
    if (i < frame.costs.machines.size()) {
      const MachineCost& cost = frame.costs.machines[i];
      text += fmt::format("  {:5.1f} us, {:4} KiB", cost.microseconds, cost.memory / 1024);
    }
    text += "\n";
  }
  for (const MachineStatus& status : scene.scenario.machines)
    text += state_text(status, *scene.scenario.names, frame.world.time) + "\n";
  return text;
}

std::string dwell_text(double so_far, double needed) {
  return std::isnan(needed) ? fmt::format("{:.1f} s", so_far) : fmt::format("{:.1f} of {:.1f} s", so_far, needed);
}

/// "yes, 0.3 of 0.5 s": result of the condition, its dwell time so far, and the time since its state was entered.
std::string progress_text(const OpenCondition& condition) {
  constexpr const char* kResults[] = {"", "not evaluated yet", "no", "yes", "failed"};
  static_assert(std::size(kResults) == enum_count(WhenValue()));
  std::string text = kResults[static_cast<std::size_t>(condition.when)];
  if (condition.lasting != 0.0) text += ", " + dwell_text(condition.held, condition.lasting);
  if (condition.after != 0.0)
    text += (text.empty() ? "after " : ", after ") + dwell_text(condition.waited, condition.after);
  return text;
}

/// The file of the machine: by convention they have the same name. Empty: unknown.
/// `machine`: "walk_to", or after those that run it "striker/walk_to".
std::string file_of(const std::string& machine, const ScriptTexts& texts) {
  const std::string behavior = machine.substr(machine.rfind('/') + 1);
  for (const std::string& file : texts.files()) {
    if (std::filesystem::path(file).stem() == behavior && !file.starts_with("lib/")) return file;
  }
  return {};
}

/// "confidence.evidence = -3.2, robot.penalized = false": what the condition reads, in this frame.
std::string values_text(const std::vector<std::string>& fields, const FrameRecord& frame) {
  std::string text;
  for (const std::string& field : fields)
    text.append(text.empty() ? "" : ", ").append(field).append(" = ").append(value_text(frame, field));
  return text;
}

/// "    has the legs (priority 35)": what it got of the body in this frame.
std::string parts_text(NameId machine, const FrameRecord& frame) {
  const std::vector<std::string> parts = body_parts(*frame.application.declared);
  std::string text;
  for (const PartClaim& claim : frame.claims) {
    if (claim.issuer.machine != machine || claim.part >= parts.size()) continue;
    const bool has_it = claim.outranked_by == kNoName;
    text += fmt::format("    {} the {} (priority {:g}){}\n", has_it ? "has" : "does not get", parts[claim.part],
                        claim.priority, has_it ? "" : ": " + frame.name(claim.outranked_by) + " has it");
  }
  return text;
}

std::string why_text(const MachineStatus& status, const std::vector<OpenCondition>& conditions, const NameTable& names,
                     const ScriptTexts& texts, const FrameRecord& frame) {
  const double now = frame.world.time;
  const std::string file = file_of(names[status.machine], texts);
  ConditionFields fields(texts);
  std::string text = fmt::format("  {}: {} for {:.1f} s{}\n", names[status.machine], names[status.state],
                                 now - status.entered_at, stopped_text(status));
  if (&names == frame.names.get()) text += parts_text(status.machine, frame);  // not of a scenario
  std::size_t target_width = 0, progress_width = 0;
  for (const OpenCondition& one : conditions) {
    if (one.machine != status.machine) continue;
    target_width = std::max(target_width, names[one.target].size());
    progress_width = std::max(progress_width, progress_text(one).size());
  }
  if (target_width == 0) return text + "    no transition leaves this state\n";
  for (const OpenCondition& one : conditions) {
    if (one.machine != status.machine) continue;
    text += fmt::format("    -> {:<{}}  {:<{}}  {} (line {})\n", names[one.target], target_width, progress_text(one),
                        progress_width, as_line(names[one.reason]), one.line);
    if (const std::string values = values_text(fields.read_at(file, {one.line, 0}), frame); !values.empty())
      text += "       " + values + "\n";
  }
  return text;
}

const MachineStatus* find(const std::vector<MachineStatus>& machines, const NameTable& names, std::string_view name) {
  for (const MachineStatus& status : machines) {
    if (names[status.machine] == name) return &status;
  }
  return nullptr;
}

}  // namespace

ScriptCommands::ScriptCommands(ScenarioHost* scenario, std::function<const ScriptTexts*()> on_disk,
                               std::function<const FrameLoop*()> engine)
    : scenario_(scenario), on_disk_(std::move(on_disk)), engine_(std::move(engine)) {}

Reply ScriptCommands::states() { return states_text; }

Reply ScriptCommands::why(const std::string& machine) const {
  if (std::find(machines_.begin(), machines_.end(), machine) == machines_.end())
    throw std::runtime_error("unknown machine '" + machine + "'" + did_you_mean(machine, machines_));
  return [this, machine](const FrameRecord& frame, const SceneTruth& scene) -> std::string {
    if (const MachineStatus* const status = find(frame.machines, *frame.names, machine)) {
      const FrameLoop* const engine = engine_ ? engine_() : nullptr;
      const ScriptTexts unknown;
      return why_text(*status, frame.conditions, *frame.names, engine != nullptr ? engine->scripts() : unknown, frame);
    }
    const MachineStatus* const status = find(scene.scenario.machines, *scene.scenario.names, machine);
    if (status == nullptr || scenario_ == nullptr) return "  this machine no longer exists\n";
    std::vector<OpenCondition> conditions;
    scenario_->host().read_conditions(conditions);
    return why_text(*status, conditions, *scene.scenario.names, scenario_->host().texts(), frame);
  };
}

Reply ScriptCommands::reload(const std::string& name, FrameInputs& inputs) const {
  const ScriptTexts& texts = *on_disk_();
  std::vector<ScriptEdit> edits = reloads_of(texts, name);
  if (edits.empty())
    throw std::runtime_error("unknown script '" + name + "' below " + texts.root() + did_you_mean(name, scripts()));
  std::move(edits.begin(), edits.end(), std::back_inserter(inputs.script_edits));
  return [](const FrameRecord& frame, const SceneTruth& scene) -> std::string {
    std::string text;
    for (const auto* reloads : {&frame.reloads, &scene.scenario.reloads}) {
      for (const ReloadRecord& reload : *reloads)
        text += "  " + as_line(reload.script) +
                (reload.accepted
                     ? " was reloaded\n"
                     : ": refused; the previous version keeps running: " + printable(reload.fault.text()) + "\n");
    }
    return text.empty() ? "  no running script uses it\n" : text;
  };
}

void ScriptCommands::observe(const FrameRecord& frame, const SceneTruth& scene) {
  machines_.clear();
  for (const MachineStatus& status : frame.machines) machines_.push_back(frame.name(status.machine));
  for (const MachineStatus& status : scene.scenario.machines) machines_.push_back(scene.scenario.name(status.machine));
}

Words ScriptCommands::scripts() const {
  Words names;
  for (const std::string& file : on_disk_()->files()) names.push_back(short_script_name(file));
  return names;
}

}  // namespace reorient
