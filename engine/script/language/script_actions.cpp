#include "engine/script/language/script_actions.h"

namespace reorient {

void ScriptActions::require_acting() const {
  if (phase_ == Phase::loading)
    throw std::runtime_error("a script acts in a state's functions, not while it is loaded");
  if (phase_ == Phase::looking) throw std::runtime_error("a condition only looks; act in enter, update or exit");
}

Issuer ScriptActions::issuer() const {
  const MachineDefinition& definition = machine_->definition();
  return {definition.name_id, definition.states[state_].path_id, machine_->reason()};
}

void ScriptActions::inform(std::string_view text) {
  require_acting();
  if (output_->logs.size() >= kMostPerFrame) return;
  const Issuer who = issuer();
  output_->logs.push_back({who.machine, who.state, std::string(text)});
}

double ScriptActions::time_in_state() {
  if (phase_ == Phase::loading) throw std::runtime_error("there is no state yet while a script is loaded");
  return time_ - machine_->entered_at(state_);
}

}  // namespace reorient
