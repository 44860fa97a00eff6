// SPDX-License-Identifier: MIT
// Behaviors that run others. Each call of a caller's machine has a script of its own, whose machine ticks after that of
// its caller while the caller is in a state that runs it.
#include <algorithm>
#include <iterator>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/script_arguments.h"
#include "engine/script/script_error.h"
#include "engine/script/script_frame.h"
#include "engine/script/script_host.h"
#include "engine/script/script_slot.h"

namespace reorient {
namespace {

constexpr std::size_t kMostCallees = 50;  // that one behavior runs, directly and through others

/// An error in the file of a call.
ScriptError error_at(const MachineDefinition& machine, int state, TextPosition position, const std::string& message) {
  const std::string& file = machine.states[static_cast<std::size_t>(state)].file;
  return ScriptError({file, position.line, message, {}, position.column});
}

/// A constant argument must fit; the result of a function is checked when it is known.
void check_arguments(const MachineDefinition& machine, const CallDefinition& call, const Script& callee) {
  const std::vector<ParameterDeclaration> declared = callee.arguments();
  std::vector<std::string> names;
  names.reserve(declared.size());
  for (const ParameterDeclaration& argument : declared) names.push_back(argument.name);
  for (const CallArgument& given : call.arguments) {
    const auto found = std::find(names.begin(), names.end(), given.name);
    const std::string what = "run \"" + call.behavior + "\": ";
    if (found == names.end()) {
      throw error_at(machine, call.state, given.position,
                     what + "unknown argument '" + given.name + "'" + did_you_mean(given.name, names));
    }
    if (given.function != LUA_NOREF) continue;
    try {
      fitted_argument(declared[static_cast<std::size_t>(found - names.begin())], given.value, OutOfRange::refuse);
    } catch (const std::runtime_error& error) {
      throw error_at(machine, call.state, given.position, what + error.what());
    }
  }
}

/// Whether the caller gives one of the choices of the argument, which needs no copy of its text.
bool is_constant_choice(const ParameterDeclaration& argument, const CallArgument& given) {
  const auto* const text = std::get_if<std::string>(&given.value);
  return given.function == LUA_NOREF && argument.kind == ParameterKind::choice && text != nullptr &&
         std::find(argument.choices.begin(), argument.choices.end(), *text) != argument.choices.end();
}

bool is_call(const CallDefinition& call, const MachineDefinition& machine, const ScriptSlot& callee) {
  return callee.called->caller == machine.name && callee.called->behavior == call.behavior;
}

const StateDefinition& state_of(const Machine& machine, const CallDefinition& call) {
  return machine.definition().states[static_cast<std::size_t>(call.state)];
}

/// Whether the callee runs since the caller entered the state that it is in.
bool is_visited(const Machine& caller, const CallDefinition& call, const ScriptSlot& callee) {
  return callee.visit && callee.visit->entered_at == caller.entered_at(call.state) &&
         callee.visit->state == state_of(caller, call).path;
}

bool is_declared(const ScriptSlot& callee, const Script& caller) {
  const auto& machines = caller.machines();
  return std::any_of(machines.begin(), machines.end(), [&](const MachineDefinition& machine) {
    return std::any_of(machine.calls.begin(), machine.calls.end(),
                       [&](const CallDefinition& call) { return is_call(call, machine, callee); });
  });
}

}  // namespace

// ---- a script that another one runs

void Script::name_as_called(const CalledAs& called) {
  const MachineDefinition& only = declarations_->machines.front();
  if (declarations_->machines.size() > 1) {
    throw ScriptError({only.file,
                       1,
                       "expected one behavior in a file that " + called.caller + " runs, found " +
                           std::to_string(declarations_->machines.size()),
                       {}});
  }
  if (only.name != called.behavior) {
    throw ScriptError(
        {only.file,
         only.position.line,
         "expected the behavior '" + called.behavior + "', which " + called.caller + " runs, found '" + only.name + "'",
         {},
         only.position.column});
  }
  MachineDefinition& machine = declarations_->machines.front();
  machine.caller = called.caller;
  machine.name = called.name();
  machine.priorities = called.priorities;
}

void Script::set_priorities(const Priorities& priorities) { declarations_->machines.front().priorities = priorities; }

std::vector<ParameterDeclaration> Script::arguments() const {
  std::vector<ParameterDeclaration> all;
  for (const DeclaredParameter& parameter : declarations_->parameters) {
    if (!parameter.is_argument) continue;
    all.push_back(parameter.declaration);
    all.back().name = parameter.key;
  }
  return all;
}

ParameterValue Script::argument_value(const ParameterDeclaration& argument, const CallArgument& given, Machine& machine,
                                      int state) {
  if (given.function == LUA_NOREF) return fitted_argument(argument, given.value, OutOfRange::clamp);
  language_.actions().set_running(&machine, state, ScriptActions::Phase::evaluating);
  push_function(given.function);
  std::optional<ScriptFault> fault = sandbox_.call(0, 1);
  language_.actions().clear_running();
  if (fault) throw ScriptError(std::move(*fault));
  const std::optional<ParameterValue> value = parameter_value(sandbox_.state(), -1);
  const char* const found = luaL_typename(sandbox_.state(), -1);
  lua_pop(sandbox_.state(), 1);
  if (!value) throw std::runtime_error(given.name + ": expected a value, found a " + found);
  return fitted_argument(argument, *value, OutOfRange::clamp);
}

void Script::take_arguments(std::span<const CallArgument> given, Script& caller, Machine& machine, int state) {
  for (DeclaredParameter& parameter : declarations_->parameters) {
    if (!parameter.is_argument) continue;
    const auto found =
        std::find_if(given.begin(), given.end(), [&](const CallArgument& one) { return one.name == parameter.key; });
    if (found == given.end()) {
      declarations_->set_value(parameter, parameter.declaration.default_value);
      continue;
    }
    try {
      if (is_constant_choice(parameter.declaration, *found)) {
        declarations_->set_value(parameter, found->value);
      } else {
        declarations_->set_value(parameter, caller.argument_value(parameter.declaration, *found, machine, state));
      }
    } catch (const std::runtime_error& error) {
      const std::string& file = machine.definition().states[static_cast<std::size_t>(state)].file;
      throw ScriptError({file, found->position.line, error.what(), {}, found->position.column});
    }
  }
}

// ---- loading

/// Appends the behaviors that `script`, a new version of `slot`, runs and that do not run yet. `hashes` gets the files
/// that it tried to read if it throws ScriptError.
void ScriptHost::compile_callees(ScriptSlot& slot, const Script& script, BundleHashes& hashes,
                                 std::vector<Callee>& all) const {
  for (const MachineDefinition& machine : script.machines()) {
    for (const CallDefinition& call : machine.calls) {
      const Script* callee = known_callee(slot, machine, call, all);
      const bool is_new = callee == nullptr;
      if (is_new) callee = &compile_callee(slot, machine, call, hashes, all);
      check_arguments(machine, call, *callee);
      if (is_new) compile_callees(*all.back().slot, *callee, hashes, all);
    }
  }
}

/// The script of a call of `slot` that runs, or was compiled into `all`; nullptr: neither.
const Script* ScriptHost::known_callee(const ScriptSlot& slot, const MachineDefinition& machine,
                                       const CallDefinition& call, const std::vector<Callee>& all) {
  for (const ScriptSlot* const callee : slot.callees) {
    if (is_call(call, machine, *callee)) return callee->script.get();
  }
  for (const Callee& callee : all) {
    if (callee.slot->caller == &slot && is_call(call, machine, *callee.slot)) return callee.script.get();
  }
  return nullptr;
}

/// Appends the script of a call of `caller`.
const Script& ScriptHost::compile_callee(ScriptSlot& caller, const MachineDefinition& machine,
                                         const CallDefinition& call, BundleHashes& hashes,
                                         std::vector<Callee>& all) const {
  const auto fail = [&](const std::string& message) {
    throw error_at(machine, call.state, call.position, "run \"" + call.behavior + "\": " + message);
  };
  if (all.size() >= kMostCallees) fail("too many behaviors (expected at most 50 that one behavior runs)");
  auto slot = std::make_unique<ScriptSlot>();
  slot->file = script_file(language_.folder(), call.behavior);
  slot->called = CalledAs{call.behavior, machine.name, machine.priorities};
  slot->caller = &caller;
  for (const ScriptSlot* above = &caller; above != nullptr; above = above->caller) {
    if (above->file == slot->file) fail("it runs itself: " + slot->called->name());
  }
  if (texts_.find(slot->file) == nullptr) {
    hashes[slot->file] = std::nullopt;
    fail("script not found" + did_you_mean(slot->file, texts_.in_folder(language_.folder())));
  }
  try {
    std::unique_ptr<Script> script = compile(*slot, slot->read);
    return *all.emplace_back(Callee{std::move(slot), std::move(script)}).script;
  } catch (const ScriptError&) {
    hashes.insert(slot->read.begin(), slot->read.end());
    throw;
  }
}

/// After a version of `slot` was accepted: removes the behaviors that it no longer runs, and adds the new ones.
void ScriptHost::take_in_callees(ScriptSlot& slot, std::vector<Callee>& callees) {
  for (const std::vector<ScriptSlot*> before = slot.callees; ScriptSlot* const callee : before) {
    if (!is_declared(*callee, *slot.script)) remove(*callee);
  }
  set_priorities(slot);
  for (Callee& callee : callees) {
    ScriptSlot& added = *callee.slot;
    swap_in(added, callee.script);
    added.caller->callees.push_back(&added);
    // After its caller and the others that this one runs.
    auto place = std::find_if(slots_.begin(), slots_.end(), [&](const auto& one) { return one.get() == added.caller; });
    const auto belongs = [&](const ScriptSlot* one) {
      while (one != nullptr && one != added.caller) one = one->caller;
      return one != nullptr;
    };
    while (place != slots_.end() && belongs(place->get())) ++place;
    slots_.insert(place, std::move(callee.slot));
  }
}

void ScriptHost::remove(ScriptSlot& slot) {
  while (!slot.callees.empty()) remove(*slot.callees.back());
  std::erase(slot.caller->callees, &slot);
  std::erase_if(slots_, [&](const auto& one) { return one.get() == &slot; });
}

/// Called behaviors have the priorities of their callers.
void ScriptHost::set_priorities(ScriptSlot& slot) {
  for (ScriptSlot* const callee : slot.callees) {
    callee->called->priorities = slot.machine_named(callee->called->caller)->definition().priorities;
    callee->script->set_priorities(callee->called->priorities);
    set_priorities(*callee);
  }
}

/// Throws ScriptError if the arguments that `slot` gets do not fit its new version.
void ScriptHost::check_callers(const ScriptSlot& slot, const Script& script) const {
  if (slot.caller == nullptr) {
    CallDefinition call;
    call.behavior = script.machines().front().name;
    call.arguments = slot.given;
    if (!slot.given.empty()) check_arguments(script.machines().front(), call, script);
    return;
  }
  const MachineDefinition& machine = slot.caller->machine_named(slot.called->caller)->definition();
  for (const CallDefinition& call : machine.calls) {
    if (call.behavior == slot.called->behavior) check_arguments(machine, call, script);
  }
}

/// After rollbacks, whose versions may run other behaviors.
void ScriptHost::renew_callees() {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    ScriptSlot& slot = *slots_[i];
    if (!slot.has_other_calls) continue;
    slot.has_other_calls = false;
    std::vector<Callee> callees;
    try {
      compile_callees(slot, *slot.script, slot.read, callees);
    } catch (const ScriptError& error) {
      callees.clear();
      const NameId machine = slot.machines.front().machine.definition().name_id;
      output_.logs.push_back(
          {machine, kNoName, "the previous version took over: " + std::string(error.what()), 0, false});
    }
    take_in_callees(slot, callees);
  }
}

std::vector<ParameterDeclaration> ScriptHost::arguments_of(const std::string& file) const {
  const auto found = std::find_if(slots_.begin(), slots_.end(),
                                  [&](const auto& slot) { return slot->file == file && slot->caller == nullptr; });
  return found == slots_.end() ? std::vector<ParameterDeclaration>() : (*found)->script->arguments();
}

// ---- a frame

void ScriptHost::tick_callees(ScriptSlot& caller, std::span<const double> world) {
  for (ScriptSlot* const callee : caller.callees) tick_callee(caller, *callee, world);
}

void ScriptHost::tick_callee(ScriptSlot& caller, ScriptSlot& callee, std::span<const double> world) {
  Machine* const machine = caller.machine_named(callee.called->caller);
  const CallDefinition* const call = machine == nullptr ? nullptr : machine->active_call(callee.called->behavior);
  if (call == nullptr && !callee.visit) return;
  const bool continues = call != nullptr && is_visited(*machine, *call, callee);
  const bool has_ended = continues && callee.machines.front().machine.outcome() != BehaviorEnd::none;
  if (call != nullptr && !has_ended && !give_arguments(caller, callee, *machine, *call)) return;
  const auto begin_visit = [&] {
    callee.leave();
    if (call == nullptr) return;
    callee.set_end(BehaviorEnd::none, "");
    callee.visit_from(state_of(*machine, *call).path, machine->entered_at(call->state));
  };
  if (callee.stopped) {
    if (!continues) {
      callee.machines.front().machine.clear();  // once it is fixed, it starts again
      begin_visit();
    }
    if (call != nullptr) callee.set_end(BehaviorEnd::failed, "its script was stopped after errors");
    return;
  }
  if (!has_ended) {
    run_frame(callee, world, [&] {
      Machine& its_machine = callee.machines.front().machine;
      if (!continues) {
        its_machine.stop(*callee.script, output_.transitions);
        begin_visit();
      }
      if (call != nullptr) its_machine.tick(*callee.script, time_, output_.transitions);
    });
  }
  if (const Machine& its_machine = callee.machines.front().machine;
      callee.visit && callee.end.how == BehaviorEnd::none && its_machine.outcome() != BehaviorEnd::none)
    callee.set_end(its_machine.outcome(), names_[its_machine.reason()]);
  tick_callees(callee, world);
}

/// Returns false after an error in a function of the caller.
bool ScriptHost::give_arguments(ScriptSlot& caller, ScriptSlot& callee, Machine& machine, const CallDefinition& call) {
  try {
    callee.script->take_arguments(call.arguments, *caller.script, machine, call.state);
    return true;
  } catch (ScriptError& error) {
    std::vector<ScriptFault> faults;
    faults.push_back(std::move(error.fault));
    note_faults(caller, std::move(faults));
    return false;
  }
}

bool ScriptHost::look_up_called(const Machine& caller, std::string_view behavior, CalledSight& sight) const {
  sight = {};
  const auto& calls = caller.definition().calls;
  if (std::none_of(calls.begin(), calls.end(), [&](const CallDefinition& call) { return call.behavior == behavior; }))
    return false;
  const CallDefinition* const call = caller.active_call(behavior);
  const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const auto& slot) {
    return slot->called && slot->called->behavior == behavior && slot->called->caller == caller.definition().name;
  });
  if (found == slots_.end()) return true;
  const ScriptSlot& callee = **found;
  sight.is_running = call != nullptr;
  if (call != nullptr && !is_visited(caller, *call, callee)) return true;  // it starts in this frame
  sight.outcome = callee.end.how;
  sight.reason = callee.end.reason;
  if (call == nullptr) return true;
  const Machine& machine = callee.machines.front().machine;
  if (callee.end.how == BehaviorEnd::none) sight.reason = names_[machine.reason()];
  sight.state = machine.state();
  sight.time_in_state = time_ - machine.entered_at();
  return true;
}

}  // namespace reorient
