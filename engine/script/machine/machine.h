// A running state machine. What is here survives a reload of the script that declared it.
#pragma once

#include <string>
#include <vector>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_output.h"

namespace reorient {

class Machine;

/// How a machine reaches its script's functions. They throw ScriptError when the script fails.
class MachineCallbacks {
 public:
  virtual ~MachineCallbacks() = default;
  virtual bool holds(Machine& machine, int state, int function) = 0;
  virtual double seconds(Machine& machine, int state, const Dwell& dwell) = 0;
  virtual void run(Machine& machine, int state, int function) = 0;
  /// As run(), but an error is only noted: leaving a state cannot be refused.
  virtual void run_exit(Machine& machine, int state, int function) = 0;
};

class Machine {
 public:
  /// `definition` must be resolved without errors and outlive the machine.
  explicit Machine(const MachineDefinition& definition);

  const MachineDefinition& definition() const { return *definition_; }

  /// One frame: at most one transition (or the start), then `update` of all active states from the outside in.
  /// A transition that was begun is always completed as far as the state goes, even when a function fails.
  void tick(MachineCallbacks& script, double time, std::vector<TransitionRecord>& transitions);

  /// Path of the innermost active state; empty before the start.
  const std::string& state() const;
  double entered_at(int state) const { return entered_[state]; }
  double entered_at() const;                             ///< the innermost active state
  const std::string& reason() const { return reason_; }  ///< of the transition before

  /// Holds `command` until `state` is left.
  void lease(Command command, int state);
  void end_leases() { leases_.clear(); }
  void append_leases(std::vector<Lease>& all) const;

  /// Takes over where `old` stood, by the paths of the states: times, dwell, leases, history. States that are gone fall
  /// back to the nearest ancestor that is still there. Returned is a line about that, or nothing.
  std::string adopt(const Machine& old);

 private:
  struct Held {
    Command command;
    int state;
    std::string reason;
  };

  void start(MachineCallbacks& script, double time, std::vector<TransitionRecord>& transitions);
  int ready_transition(MachineCallbacks& script, double time);
  bool is_ready(MachineCallbacks& script, int index, double time);
  void take(MachineCallbacks& script, int index, double time, std::vector<TransitionRecord>& transitions);
  void descend(int state);
  void forget_dwell(int state);
  bool is_active(int state) const;

  const MachineDefinition* definition_;
  std::vector<int> active_;            ///< from the machine itself to the innermost state; empty before the start
  std::vector<double> entered_;        ///< s, per state
  std::vector<double> holding_since_;  ///< s, per transition; NaN: its condition does not hold
  std::vector<int> last_child_;        ///< per state, for history; -1: none yet
  std::vector<Held> leases_;
  std::string reason_;
  std::string lost_state_;       ///< after a reload: the path that is gone
  std::size_t not_entered_ = 0;  ///< after a reload: how many of the innermost active states are still to be entered
};

}  // namespace reorient
