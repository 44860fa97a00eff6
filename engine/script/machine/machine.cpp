// SPDX-License-Identifier: MIT
#include "engine/script/machine/machine.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reorient {
namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

// Frame times are sums of rounded steps: thirty of 1/30 s count as one second.
constexpr double kTimeTolerance = 1e-6;

}  // namespace

Machine::Machine(const MachineDefinition& definition)
    : definition_(&definition),
      entered_(definition.states.size(), 0.0),
      holding_since_(definition.transitions.size(), kNever),
      looks_(definition.transitions.size()),
      last_child_(definition.states.size(), -1) {
  // Reserve for the maximum depth and for each type of pause in every active state, so that no transition allocates.
  active_.reserve(definition.states.size());
  leases_.reserve(2 * definition.states.size());
}

const std::string& Machine::state() const { return definition_->states[active_.empty() ? 0 : active_.back()].path; }

NameId Machine::state_id() const { return definition_->states[active_.empty() ? 0 : active_.back()].path_id; }

double Machine::entered_at() const { return entered_[active_.empty() ? 0 : active_.back()]; }

bool Machine::is_active(int state) const { return std::find(active_.begin(), active_.end(), state) != active_.end(); }

void Machine::tick(MachineCallbacks& script, double time, std::vector<TransitionRecord>& transitions) {
  if (active_.empty() || not_entered_ > 0) {
    start(script, time, transitions);
  } else if (const int transition = ready_transition(script, time); transition >= 0) {
    take(script, transition, time, transitions);
  }
  for (const int state : active_) script.run(*this, state, definition_->states[state].update);
}

BehaviorEnd Machine::outcome() const { return definition_->states[active_.empty() ? 0 : active_.back()].ends; }

const CallDefinition* Machine::active_call(std::string_view behavior) const {
  if (outcome() != BehaviorEnd::none) return nullptr;
  for (const CallDefinition& call : definition_->calls) {
    if (call.behavior == behavior && is_active(call.state)) return &call;
  }
  return nullptr;
}

void Machine::stop(MachineCallbacks& script, std::vector<TransitionRecord>& transitions) {
  if (active_.empty()) return;
  const NameId from = state_id();
  for (std::size_t i = active_.size(); i-- > 0;) {
    script.run_exit(*this, active_[i], definition_->states[active_[i]].exit);
  }
  clear();
  reason_ = definition_->left_id;
  transitions.push_back({definition_->name_id, from, kNoName, reason_, -1});
}

void Machine::clear() {
  active_.clear();
  leases_.clear();
  not_entered_ = 0;
  lost_state_ = kNoName;
  std::fill(last_child_.begin(), last_child_.end(), -1);
}

void Machine::append_published(std::vector<NameId>& all) const {
  for (const int state : active_) {
    const NameId flag = definition_->states[static_cast<std::size_t>(state)].publishes_id;
    if (flag != kNoName && std::find(all.begin(), all.end(), flag) == all.end()) all.push_back(flag);
  }
}

void Machine::start(MachineCallbacks& script, double time, std::vector<TransitionRecord>& transitions) {
  std::size_t kept = 0;
  if (active_.empty()) {
    descend(0);
    reason_ = kStartName;
  } else {
    kept = active_.size() - not_entered_;
    reason_ = kReloadedName;
  }
  not_entered_ = 0;
  for (std::size_t i = kept; i < active_.size(); ++i) entered_[active_[i]] = time;
  transitions.push_back({definition_->name_id, lost_state_, state_id(), reason_, -1});
  lost_state_ = kNoName;
  for (std::size_t i = kept; i < active_.size(); ++i)
    script.run(*this, active_[i], definition_->states[active_[i]].enter);
}

/// Activates `state`, whose parent is the innermost active state, and its initial (or remembered) children.
void Machine::descend(int state) {
  while (state >= 0) {
    active_.push_back(state);
    forget_dwell(state);
    const StateDefinition& definition = definition_->states[state];
    state = definition.history && last_child_[state] >= 0 ? last_child_[state] : definition.initial;
  }
}

void Machine::forget_dwell(int state) {
  for (const int transition : definition_->states[state].transitions) {
    holding_since_[transition] = kNever;
    looks_[transition] = {};
  }
}

int Machine::ready_transition(MachineCallbacks& script, double time) {
  for (const int state : active_) {
    for (const int transition : definition_->states[state].transitions) {
      if (is_ready(script, transition, time)) return transition;
    }
  }
  return -1;
}

/// A transition to an active state is not possible, except from a state to itself.
bool Machine::is_barred(const TransitionDefinition& transition) const {
  const bool to_itself = !transition.common && transition.to == transition.from;
  return is_active(transition.to) && !to_itself;
}

bool Machine::is_ready(MachineCallbacks& script, int index, double time) {
  const TransitionDefinition& transition = definition_->transitions[index];
  if (is_barred(transition)) return false;
  double& since = holding_since_[index];
  Look& look = looks_[index];
  look.when = WhenValue::failed;  // unless the functions below return
  bool lasts = true;
  if (transition.when != LUA_NOREF) {
    if (!script.holds(*this, transition.from, transition.when)) {
      since = kNever;
      look.when = WhenValue::no;
      return false;
    }
    if (std::isnan(since)) since = time;
    if (transition.lasting.kind != Dwell::Kind::none) {
      look.lasting = script.seconds(*this, transition.from, transition.lasting);
      lasts = time - since + kTimeTolerance >= look.lasting;
    }
  }
  if (lasts && transition.after.kind != Dwell::Kind::none) {
    look.after = script.seconds(*this, transition.from, transition.after);
    lasts = time - entered_[transition.from] + kTimeTolerance >= look.after;
  }
  look.when = transition.when == LUA_NOREF ? WhenValue::none : WhenValue::yes;
  return lasts;
}

void Machine::take(MachineCallbacks& script, int index, double time, std::vector<TransitionRecord>& transitions) {
  const TransitionDefinition& transition = definition_->transitions[index];
  const NameId from = state_id();
  // The states that remain active: common ancestors of the target, not the target itself.
  std::size_t kept = 0;
  while (kept < active_.size() && active_[kept] != transition.to &&
         definition_->is_within(transition.to, active_[kept]))
    ++kept;
  for (std::size_t i = active_.size(); i-- > kept;) {
    const int state = active_[i];
    script.run_exit(*this, state, definition_->states[state].exit);
    last_child_[definition_->states[state].parent] = state;
    std::erase_if(leases_, [&](const Held& held) { return held.state == state; });
  }
  active_.resize(kept);
  // From below the remaining states down to the target's parent.
  const int innermost = active_.back();
  for (int state = definition_->states[transition.to].parent; state != innermost;
       state = definition_->states[state].parent) {
    active_.push_back(state);
    forget_dwell(state);
  }
  std::reverse(active_.begin() + static_cast<std::ptrdiff_t>(kept), active_.end());
  descend(transition.to);
  for (std::size_t i = kept; i < active_.size(); ++i) entered_[active_[i]] = time;
  reason_ = transition.because_id;
  transitions.push_back({definition_->name_id, from, state_id(), reason_, index});
  for (std::size_t i = kept; i < active_.size(); ++i)
    script.run(*this, active_[i], definition_->states[active_[i]].enter);
}

void Machine::lease(Pause pause, int state) {
  const auto same = [&](const Held& held) { return held.pause == pause && held.state == state; };
  if (std::none_of(leases_.begin(), leases_.end(), same)) leases_.push_back({pause, state, reason_});
}

void Machine::append_leases(std::vector<Lease>& all) const {
  for (const Held& held : leases_) {
    all.push_back({held.pause, {definition_->name_id, definition_->states[held.state].path_id, held.reason}});
  }
}

void Machine::append_conditions(MachineCallbacks& script, double time, std::vector<OpenCondition>& all) {
  const auto seconds = [&](int state, const Dwell& dwell, double last) {
    if (dwell.kind == Dwell::Kind::none) return 0.0;
    return dwell.kind == Dwell::Kind::function ? last : script.seconds(*this, state, dwell);
  };
  for (const int state : active_) {
    for (const int index : definition_->states[state].transitions) {
      const TransitionDefinition& transition = definition_->transitions[index];
      if (is_barred(transition)) continue;
      const Look& look = looks_[index];
      const bool is_timed = transition.when == LUA_NOREF && look.when != WhenValue::failed;
      all.push_back({.machine = definition_->name_id,
                     .from = definition_->states[state].path_id,
                     .target = definition_->states[transition.to].path_id,
                     .reason = transition.because_id,
                     .line = transition.position.line,
                     .when = is_timed ? WhenValue::none : look.when,
                     .held = std::isnan(holding_since_[index]) ? 0.0 : time - holding_since_[index],
                     .lasting = seconds(state, transition.lasting, look.lasting),
                     .waited = time - entered_[state],
                     .after = seconds(state, transition.after, look.after)});
    }
  }
}

std::string Machine::adopt(const Machine& old) {
  if (old.active_.empty()) return {};
  const MachineDefinition& before = *old.definition_;
  for (std::size_t i = 0; i < before.states.size(); ++i) {
    const int state = definition_->find(before.states[i].path);
    if (state < 0) continue;
    entered_[state] = old.entered_[i];
    if (old.last_child_[i] >= 0) last_child_[state] = definition_->find(before.states[old.last_child_[i]].path);
  }
  reason_ = old.reason_;
  lost_state_ = old.lost_state_;
  for (const int state : old.active_) {
    const int same = definition_->find(before.states[state].path);
    if (same < 0) break;
    active_.push_back(same);
  }
  const std::size_t survived = active_.size();
  if (const int inner = definition_->states[active_.back()].initial; inner >= 0) descend(inner);
  not_entered_ = active_.size() - std::min(survived, old.active_.size() - old.not_entered_);
  for (std::size_t i = 0; i < before.transitions.size(); ++i) {
    if (!old.is_active(before.transitions[i].from)) continue;  // its result is of an earlier visit
    for (std::size_t j = 0; j < definition_->transitions.size(); ++j) {
      if (definition_->transitions[j].key == before.transitions[i].key) holding_since_[j] = old.holding_since_[i];
    }
  }
  for (const Held& held : old.leases_) {
    const int state = definition_->find(before.states[held.state].path);
    if (state >= 0 && is_active(state)) leases_.push_back({held.pause, state, held.reason});
  }
  if (survived == old.active_.size()) {
    if (not_entered_ > 0 && lost_state_ == kNoName) lost_state_ = old.state_id();
    return {};
  }
  lost_state_ = not_entered_ == 0 ? kNoName : old.state_id();
  return definition_->name + ": state '" + old.state() + "' was removed; it continues in '" + state() + "'";
}

void Machine::rename(const NameTable& before, Names& names) {
  reason_ = names.intern(before[reason_]);
  lost_state_ = names.intern(before[lost_state_]);
  for (Held& held : leases_) held.reason = names.intern(before[held.reason]);
}

void Machine::check() const {
  const auto states = static_cast<int>(definition_->states.size());
  const auto is_state = [&](int state) { return state >= 0 && state < states; };
  bool fits = entered_.size() == definition_->states.size() && last_child_.size() == definition_->states.size() &&
              holding_since_.size() == definition_->transitions.size() &&
              looks_.size() == definition_->transitions.size() && not_entered_ <= active_.size();
  for (std::size_t i = 0; i < active_.size(); ++i)
    fits = fits && is_state(active_[i]) && definition_->states[active_[i]].parent == (i == 0 ? -1 : active_[i - 1]);
  for (const int child : last_child_) fits = fits && (child == -1 || is_state(child));
  for (const Held& held : leases_) fits = fits && is_state(held.state);
  if (!fits) throw BadBytes("the state of the machine '" + definition_->name + "' does not fit its script");
}

}  // namespace reorient
