// SPDX-License-Identifier: MIT
// A running state machine. Its data survives a reload of the script that declared it.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_output.h"
#include "engine/world/commands.h"
#include "geometry/const_or.h"

namespace reorient {

class Machine;

/// The result of the last evaluation of a transition's `when`.
enum class WhenValue {
  none,     ///< without `when`: waits for its time alone
  unasked,  ///< not evaluated since the state was entered
  no,
  yes,
  failed  ///< the script failed in it or in a function for a dwell time
};
constexpr int enum_count(WhenValue) { return 5; }

/// A possible transition from the active states, and its progress.
struct OpenCondition {
  NameId machine = kNoName;
  NameId from = kNoName;    ///< path of the state whose transition it is; empty: the machine's own
  NameId target = kNoName;  ///< path
  NameId reason = kNoName;
  int line = 0;  ///< of the script's file
  WhenValue when = WhenValue::none;
  double held = 0.0;     ///< s for which `when` has held; 0 if it does not hold
  double lasting = 0.0;  ///< s for which it must hold; NaN: from a function that was not called yet
  double waited = 0.0;   ///< s since `from` was entered
  double after = 0.0;    ///< s that must have passed since then; NaN: as above
};
template <typename Visit, ConstOr<OpenCondition> T>
void fields(Visit&& visit, T& condition) {
  visit(condition.machine, condition.from, condition.target, condition.reason, condition.line, condition.when,
        condition.held, condition.lasting, condition.waited, condition.after);
}

/// Calls the functions of a machine's script. They throw ScriptError if the script fails.
class MachineCallbacks {
 public:
  virtual ~MachineCallbacks() = default;
  virtual bool holds(Machine& machine, int state, int function) = 0;
  virtual double seconds(Machine& machine, int state, const Dwell& dwell) = 0;
  virtual void run(Machine& machine, int state, int function) = 0;
  /// As run(), but only records an error, because leaving a state cannot be refused.
  virtual void run_exit(Machine& machine, int state, int function) = 0;
};

class Machine {
 public:
  /// `definition` must be resolved without errors and outlive the machine.
  explicit Machine(const MachineDefinition& definition);

  const MachineDefinition& definition() const { return *definition_; }

  /// One frame: at most one transition (or the start), then `update` of all active states from the outside in.
  /// A started transition always completes its change of state, even if a function fails.
  void tick(MachineCallbacks& script, double time, std::vector<TransitionRecord>& transitions);

  /// Leaves all states, from the inside out. The next tick starts the machine again, without memory of its states.
  void stop(MachineCallbacks& script, std::vector<TransitionRecord>& transitions);

  /// The same without a call of the script.
  void clear();

  /// Path of the innermost active state; empty before the start.
  const std::string& state() const;
  NameId state_id() const;
  double entered_at(int state) const { return entered_[static_cast<std::size_t>(state)]; }
  double entered_at() const;                 ///< the innermost active state
  NameId reason() const { return reason_; }  ///< of the previous transition
  /// Whether the active state ends the behavior.
  BehaviorEnd outcome() const;
  /// The call of this behavior in an active state; nullptr: none. A behavior that has ended calls no other one.
  const CallDefinition* active_call(std::string_view behavior) const;

  /// Holds `pause` until `state` is left.
  void lease(Pause pause, int state);
  void append_leases(std::vector<Lease>& all) const;
  /// The flags that the active states publish.
  void append_published(std::vector<NameId>& all) const;
  /// The transitions of the active states, from the outside in, with the results of their last evaluation: no
  /// function of the script is called.
  void append_conditions(MachineCallbacks& script, double time, std::vector<OpenCondition>& all);

  /// Takes over the status of `old` by paths of states: times, dwell, leases, history. If a state was removed, the
  /// nearest remaining ancestor becomes active. Returns a line about that, or an empty string.
  std::string adopt(const Machine& old);

  /// For a new table of names: maps numbers of `before` by name.
  void rename(const NameTable& before, Names& names);

  /// All data except the definition; throws BadBytes if the data do not fit the definition.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.active_, self.entered_, self.holding_since_, self.looks_, self.last_child_, self.leases_, self.reason_,
            self.lost_state_, self.not_entered_);
    if constexpr (Archive::kReads) self.check();
  }

 private:
  struct Held {
    Pause pause = Pause::training;
    int state = 0;
    NameId reason = kNoName;
  };
  template <typename Visit, ConstOr<Held> T>
  friend void fields(Visit&& visit, T& held) {
    visit(held.pause, held.state, held.reason);
  }
  /// The last evaluation of a transition, for explanations.
  struct Look {
    WhenValue when = WhenValue::unasked;
    double lasting = std::numeric_limits<double>::quiet_NaN();  ///< s, result of a function
    double after = std::numeric_limits<double>::quiet_NaN();
  };
  template <typename Visit, ConstOr<Look> T>
  friend void fields(Visit&& visit, T& look) {
    visit(look.when, look.lasting, look.after);
  }

  void check() const;

  void start(MachineCallbacks& script, double time, std::vector<TransitionRecord>& transitions);
  int ready_transition(MachineCallbacks& script, double time);
  bool is_ready(MachineCallbacks& script, int index, double time);
  bool is_barred(const TransitionDefinition& transition) const;
  void take(MachineCallbacks& script, int index, double time, std::vector<TransitionRecord>& transitions);
  void descend(int state);
  void forget_dwell(int state);
  bool is_active(int state) const;

  const MachineDefinition* definition_;
  std::vector<int> active_;            ///< from the machine itself to the innermost state; empty before the start
  std::vector<double> entered_;        ///< s, per state
  std::vector<double> holding_since_;  ///< s, per transition; NaN: its condition does not hold
  std::vector<Look> looks_;            ///< per transition
  std::vector<int> last_child_;        ///< per state, for history; -1: none yet
  std::vector<Held> leases_;
  NameId reason_ = kNoName;
  NameId lost_state_ = kNoName;    ///< after a reload: the removed path
  std::uint64_t not_entered_ = 0;  ///< after a reload: number of innermost active states to enter
};

}  // namespace reorient
