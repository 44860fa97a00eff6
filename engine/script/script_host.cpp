// SPDX-License-Identifier: MIT
#include "engine/script/script_host.h"

#include <algorithm>
#include <cmath>

#include "engine/script/script_error.h"
#include "engine/script/script_frame.h"
#include "engine/script/script_slot.h"

namespace reorient {

void require_room(const std::vector<std::unique_ptr<ScriptSlot>>& slots, const ScriptSlot& slot,
                  const ScriptLimits& limits) {
  struct Bound {
    const char* name;
    int ScriptLimits::*limit;
    std::int64_t most;
  };
  // Some seconds and half a gigabyte: about 200 scripts with the default limits.
  constexpr Bound kBounds[] = {{"instructions_per_frame", &ScriptLimits::instructions_per_frame, 20'000'000},
                               {"instructions_per_load", &ScriptLimits::instructions_per_load, 400'000'000},
                               {"max_memory", &ScriptLimits::max_memory, 512 * 1024}};
  for (const Bound& bound : kBounds) {
    std::int64_t sum = limits.*bound.limit;
    const auto add = [&](const ScriptSlot& other) {
      for (const Script* const script : {other.script.get(), other.last_good.get()}) {
        if (script != nullptr) sum += script->limits().*bound.limit;
      }
    };
    for (const auto& other : slots) {
      if (other.get() != &slot) add(*other);
    }
    add(slot);
    if (sum > bound.most) {
      throw ScriptError({slot.file,
                         0,
                         "script." + std::string(bound.name) + ": expected at most " + std::to_string(bound.most) +
                             " for all scripts together, found " + std::to_string(sum),
                         {}});
    }
  }
}

ScriptHost::ScriptHost(ScriptTexts texts, ScriptLanguage& language, ParameterRegistry& parameters,
                       const ScriptLimits& limits, const MachineDirectory* directory)
    : texts_(std::move(texts)),
      language_(language),
      parameters_(parameters),
      limits_(limits),
      directory_(directory != nullptr ? *directory : *this) {}

ScriptHost::~ScriptHost() = default;

void ScriptHost::load(const std::string& name, std::vector<CallArgument> arguments) {
  auto slot = std::make_unique<ScriptSlot>();
  slot->file = script_file(language_.folder(), name);
  for (const auto& other : slots_) {
    if (other->file == slot->file && other->caller == nullptr) return;
  }
  std::unique_ptr<Script> script = compile(*slot, slot->read);
  slot->given = std::move(arguments);
  check_callers(*slot, *script);
  std::vector<Callee> callees;
  compile_callees(*slot, *script, slot->read, callees);
  const auto check_overrides = [&](const Script& one) {
    // At the start an invalid setting is an error, which is not at a place of the script; at a reload it is clamped.
    for (const ParameterDeclaration& declaration : one.parameters()) parameters_.check_override(declaration);
  };
  check_overrides(*script);
  for (const Callee& callee : callees) check_overrides(*callee.script);
  swap_in(*slot, script);
  slots_.push_back(std::move(slot));
  take_in_callees(*slots_.back(), callees);
}

std::unique_ptr<Script> ScriptHost::compile(const ScriptSlot& slot, BundleHashes& hashes) const {
  require_room(slots_, slot, limits_);
  auto script =
      std::make_unique<Script>(texts_, slot.file, language_, limits_, parameters_, directory_, hashes, slot.called);
  refuse_taken_names(slot, *script);
  return script;
}

void ScriptHost::refuse_taken_names(const ScriptSlot& slot, const Script& script) const {
  for (const auto& other : slots_) {
    if (other.get() == &slot) continue;
    for (const ScriptSlot::Running& running : other->machines) {
      for (const MachineDefinition& machine : script.machines()) {
        if (machine.name != running.machine.definition().name) continue;
        throw ScriptError(
            {machine.file,
             machine.position.line,
             "'" + machine.name + "' is also declared in " + other->file + " (rename or omit one of them)",
             {},
             machine.position.column});
      }
    }
  }
  for (const ParameterDeclaration& declaration : script.parameters()) {
    if (!parameters_.belongs_to_program(declaration.name)) continue;
    throw ScriptError({slot.file, 0, "param " + declaration.name + ": name is used by the program (rename it)", {}});
  }
}

/// Replaces the current version of the script with another one, which takes over its data. Returns warnings.
std::vector<std::string> ScriptHost::swap_in(ScriptSlot& slot, std::unique_ptr<Script>& script) {
  std::vector<std::string> warnings = parameters_.declare_for(slot.file, script->parameters());
  if (slot.script) {
    std::vector<std::string> left_out;
    script->take_over(*slot.script, left_out);
    for (const std::string& name : left_out) warnings.push_back("keep: '" + name + "' cannot survive a reload");
  }
  script->intern(names_);
  std::vector<ScriptSlot::Running> machines;
  for (const MachineDefinition& definition : script->machines()) {
    machines.push_back({Machine(definition), {}, 0.0});
    for (const ScriptSlot::Running& before : slot.machines) {
      if (before.machine.definition().name != definition.name) continue;
      const std::string warning = machines.back().machine.adopt(before.machine);
      if (!warning.empty()) warnings.push_back(warning);
      machines.back().see_as(before);
    }
  }
  slot.machines = std::move(machines);
  slot.script.swap(script);
  if (slot.called) slot.script->set_priorities(slot.called->priorities);
  slot.swapped_at = time_;
  slot.recent_errors = 0;
  slot.stopped = false;
  slot.frames = 0;
  slot.instructions_before = slot.script->sandbox().instructions();
  return warnings;
}

ReloadRecord ScriptHost::reload(ScriptSlot& slot) {
  ReloadRecord report{slot.file, false, {}, {}};
  BundleHashes hashes;
  try {
    std::unique_ptr<Script> script = compile(slot, hashes);
    check_callers(slot, *script);
    std::vector<Callee> callees;
    compile_callees(slot, *script, hashes, callees);
    const bool runs_well = slot.recent_errors == 0 && !slot.stopped;
    const bool is_proven = slot.frames > 0 && time_ - slot.swapped_at >= limits_.trial_time;
    report.warnings = swap_in(slot, script);
    take_in_callees(slot, callees);
    if (runs_well && (is_proven || !slot.last_good)) slot.last_good = std::move(script);
    report.accepted = true;
  } catch (const ScriptError& error) {
    report.fault = error.fault;
  }
  slot.read = std::move(hashes);
  slot.was_refused = !report.accepted;
  return report;
}

std::vector<ReloadRecord> ScriptHost::apply(std::span<const ScriptEdit> edits) {
  std::set<std::string> again;
  for (const ScriptEdit& edit : edits) {
    texts_.apply(edit);
    if (edit.again) again.insert(edit.file);
  }
  const auto has_changed = [&](const ScriptSlot& slot) {
    return std::any_of(slot.read.begin(), slot.read.end(), [&](const auto& file) {
      const ScriptText* const text = texts_.find(file.first);
      return again.contains(file.first) ||
             file.second != (text != nullptr ? std::optional<std::uint64_t>(content_hash(text->text + text->problem))
                                             : std::nullopt);
    });
  };
  std::vector<ReloadRecord> reports;
  // A reload may add and remove the slots after its own, which are the behaviors that it runs.
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    ScriptSlot& slot = *slots_[i];
    // A behavior that was refused because of its caller gets another chance with the caller's new version.
    const bool is_retried = slot.was_refused && slot.caller != nullptr && slot.caller->swapped_at == time_;
    if (has_changed(slot) || is_retried) reports.push_back(reload(slot));
  }
  if (names_.size() > Names::kMany) renew_names();
  return reports;
}

/// Numbers only the names that are in use now.
void ScriptHost::renew_names() {
  const std::shared_ptr<const NameTable> before = names_.table();
  names_.clear();
  for (const auto& slot : slots_) {
    slot->script->intern(names_);
    if (slot->last_good) slot->last_good->intern(names_);
    for (ScriptSlot::Running& running : slot->machines) running.machine.rename(*before, names_);
  }
}

const ScriptOutput& ScriptHost::tick(double time, std::span<const double> world) {
  time_ = time;
  output_.clear();
  language_.actions().begin_frame(output_, time);
  for (const auto& slot : slots_) {
    for (ScriptSlot::Running& running : slot->machines) {
      running.seen_state = running.machine.state();
      running.seen_entered_at = running.machine.entered_at();
    }
  }
  read_published(published_);
  for (const auto& slot : slots_) {
    if (slot->caller == nullptr) tick(*slot, world);  // with the behaviors that it runs
  }
  renew_callees();
  return output_;
}

/// A script that does not run holds no leases; once it is fixed, it resumes its state and its leases.
void ScriptHost::append_leases(std::vector<Lease>& leases) const {
  for (const auto& slot : slots_) {
    if (!slot->is_running()) continue;
    for (const ScriptSlot::Running& running : slot->machines) running.machine.append_leases(leases);
  }
}

void ScriptHost::tick(ScriptSlot& slot, std::span<const double> world) {
  if (slot.stopped) return;
  run_frame(slot, world, [&] {
    if (!slot.given.empty()) slot.script->take_arguments(slot.given, *slot.script, slot.machines.front().machine, 0);
    for (ScriptSlot::Running& running : slot.machines) running.machine.tick(*slot.script, time_, output_.transitions);
  });
  tick_callees(slot, world);
}

/// Records the faults of one frame and one version. Errors of a version in its last frame do not count against the
/// version that replaces it.
void ScriptHost::note_faults(ScriptSlot& slot, std::vector<ScriptFault> faults) {
  bool has_ended = false;
  for (ScriptFault& fault : faults) {
    if (fault.file.empty()) fault.file = slot.file;  // Lua reports no position if memory is exhausted
    const auto consequence = has_ended ? FaultRecord::Consequence::none : count_fault(slot, fault);
    has_ended |= consequence != FaultRecord::Consequence::none;
    output_.faults.push_back({slot.file, std::move(fault), consequence});
  }
}

/// After too many errors the last good version replaces this one, or the script is stopped.
FaultRecord::Consequence ScriptHost::count_fault(ScriptSlot& slot, const ScriptFault& fault) {
  if (time_ - slot.last_error_at > limits_.error_window) slot.recent_errors = 0;
  ++slot.errors;
  ++slot.recent_errors;
  slot.last_error_at = time_;
  slot.last_error = fault.text();
  if (slot.recent_errors < limits_.max_errors) return FaultRecord::Consequence::none;
  if (!slot.last_good) {
    slot.stopped = true;
    return FaultRecord::Consequence::stopped;
  }
  std::unique_ptr<Script> script = std::move(slot.last_good);
  slot.has_other_calls = true;
  for (const std::string& warning : swap_in(slot, script)) {
    const NameId machine = slot.machines.empty() ? kNoName : slot.machines.front().machine.definition().name_id;
    output_.logs.push_back({machine, kNoName, "the previous version took over: " + warning, 0, false});
  }
  return FaultRecord::Consequence::rolled_back;
}

bool ScriptHost::look_up(std::string_view name, MachineSight& sight) const {
  for (const auto& slot : slots_) {
    for (const ScriptSlot::Running& running : slot->machines) {
      if (running.machine.definition().name != name) continue;
      sight = {running.seen_state, time_ - running.seen_entered_at};
      return true;
    }
  }
  return false;
}

bool ScriptHost::is_published(std::string_view flag) const {
  const NameTable& names = *names_.table();
  return std::any_of(published_.begin(), published_.end(), [&](NameId id) { return names[id] == flag; });
}

std::vector<const MachineDefinition*> ScriptHost::definitions() const {
  std::vector<const MachineDefinition*> all;
  for (const auto& slot : slots_) {
    for (const ScriptSlot::Running& running : slot->machines) all.push_back(&running.machine.definition());
  }
  return all;
}

std::map<std::string, std::set<std::string>> ScriptHost::module_fields() const {
  std::map<std::string, std::set<std::string>> all;
  for (const auto& slot : slots_) all.merge(slot->script->module_fields());
  return all;
}

void ScriptHost::read_status(std::vector<MachineStatus>& all) const {
  all.clear();
  for (const auto& slot : slots_) {
    for (const ScriptSlot::Running& running : slot->machines) {
      const Machine& machine = running.machine;
      all.push_back(
          {machine.definition().name_id, machine.state_id(), machine.entered_at(), slot->stopped, slot->errors});
    }
  }
}

void ScriptHost::read_costs(std::vector<MachineCost>& all) const {
  all.clear();
  for (const auto& slot : slots_) {
    const Sandbox& sandbox = slot->script->sandbox();
    const std::int64_t spent = sandbox.instructions() - slot->instructions_before;
    for (const ScriptSlot::Running& running : slot->machines) {
      all.push_back({running.machine.definition().name_id, slot->microseconds,
                     slot->frames > 0 ? spent / slot->frames : 0, sandbox.memory()});
    }
  }
}

void ScriptHost::read_published(std::vector<NameId>& all) const {
  all.clear();
  for (const auto& slot : slots_) {
    if (!slot->is_running()) continue;
    for (const ScriptSlot::Running& running : slot->machines) running.machine.append_published(all);
  }
}

void ScriptHost::read_conditions(std::vector<OpenCondition>& all) const {
  all.clear();
  for (const auto& slot : slots_) {
    for (ScriptSlot::Running& running : slot->machines) running.machine.append_conditions(*slot->script, time_, all);
  }
}

}  // namespace reorient
