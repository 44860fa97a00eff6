// A running state machine. What is here survives a reload of the script that declared it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_output.h"
#include "engine/world/commands.h"

namespace reorient {

class Machine;

/// A transition whose `when` holds, or that waits for its time alone, and how far it is.
struct OpenCondition {
  NameId machine = kNoName;
  NameId target = kNoName;  ///< path
  NameId reason = kNoName;
  double held = 0.0;    ///< s that `when` has held; 0 where there is none
  double waited = 0.0;  ///< s since its state was entered
};
template <typename Visit>
void fields(Visit&& visit, OpenCondition& condition) {
  visit(condition.machine, condition.target, condition.reason, condition.held, condition.waited);
}

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
  NameId state_id() const;
  double entered_at(int state) const { return entered_[state]; }
  double entered_at() const;                 ///< the innermost active state
  NameId reason() const { return reason_; }  ///< of the transition before

  /// Holds `pause` until `state` is left.
  void lease(Pause pause, int state);
  void end_leases() { leases_.clear(); }
  void append_leases(std::vector<Lease>& all) const;
  /// What the active states publish.
  void append_published(std::vector<NameId>& all) const;
  /// The transitions of the active states that are on their way: `when` holds, or only the time is lacking.
  void append_conditions(double time, std::vector<OpenCondition>& all) const;

  /// Takes over where `old` stood, by the paths of the states: times, dwell, leases, history. States that are gone fall
  /// back to the nearest ancestor that is still there. Returned is a line about that, or nothing.
  std::string adopt(const Machine& old);

  /// For a new table of names: looks up in `before` what the numbers stood for.
  void rename(const NameTable& before, Names& names);

  /// Everything but the definition; throws BadBytes where it does not fit that.
  template <typename Archive>
  void archive(Archive& archive) {
    archive(active_, entered_, holding_since_, last_child_, leases_, reason_, lost_state_, not_entered_);
    if constexpr (Archive::kReads) check();
  }

 private:
  struct Held {
    Pause pause = Pause::training;
    int state = 0;
    NameId reason = kNoName;
  };
  template <typename Visit>
  friend void fields(Visit&& visit, Held& held) {
    visit(held.pause, held.state, held.reason);
  }

  void check() const;

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
  NameId reason_ = kNoName;
  NameId lost_state_ = kNoName;    ///< after a reload: the path that is gone
  std::uint64_t not_entered_ = 0;  ///< after a reload: how many of the innermost active states are still to be entered
};

}  // namespace reorient
