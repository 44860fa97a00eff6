// SPDX-License-Identifier: MIT
#include "engine/script/language/script_actions.h"

namespace reorient {

void ScriptActions::require_acting() const {
  if (phase_ == Phase::loading)
    throw std::runtime_error("actions are not allowed while a script is loaded; use them in enter, update or exit");
  if (phase_ == Phase::evaluating)
    throw std::runtime_error("actions are not allowed in a condition; use them in enter, update or exit");
}

void ScriptActions::set_running(Machine* machine, int state, Phase phase) {
  if (machine != nullptr && machine != counted_) {
    counted_ = machine;
    logged_ = acted_ = 0;
  }
  machine_ = machine;
  state_ = state;
  phase_ = phase;
}

void ScriptActions::count_action() {
  if (acted_++ >= kMostPerFrame)
    throw std::runtime_error("too many actions in one frame (expected at most " + std::to_string(kMostPerFrame) + ")");
}

Issuer ScriptActions::issuer() const {
  const MachineDefinition& definition = machine_->definition();
  return {definition.name_id, definition.states[state_].path_id, machine_->reason()};
}

void ScriptActions::log(std::string_view text, bool is_note) {
  require_acting();
  const Issuer who = issuer();
  std::vector<LogRecord>& logs = output_->logs;
  if (logged_++ < kMostPerFrame) {
    logs.push_back({who.machine, who.state, std::string(text), 0, is_note});
  } else {
    ++logs.back().dropped;  // of the same machine: machines tick one after the other
  }
}

double ScriptActions::time_in_state() {
  if (phase_ == Phase::loading) throw std::runtime_error("time_in_state: no state is active while a script is loaded");
  return time_ - machine_->entered_at(state_);
}

}  // namespace reorient
