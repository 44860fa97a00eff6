// SPDX-License-Identifier: MIT
// Functions of all scripts: write to the log, read the time in a state. Behaviors and
// scenarios add their own (behavior_language.h; the workbench's scenario_language.h).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/script/machine/machine.h"
#include "engine/script/script_output.h"

namespace reorient {

/// The object on which the functions of a type of script act. All scripts of a host share it, because they run one
/// after the other.
class ScriptActions {
 public:
  enum class Phase { loading, evaluating, acting };  ///< evaluating: in a `when`, which must not act

  virtual ~ScriptActions() = default;

  /// Before the machines tick.
  virtual void begin_frame(ScriptOutput& output, double time) {
    output_ = &output;
    time_ = time;
    counted_ = nullptr;
  }

  /// Sets the machine and state that run from now on.
  void set_running(Machine* machine, int state, Phase phase);
  void clear_running() { set_running(nullptr, 0, Phase::loading); }

  /// Limit of log lines, and of commands or actions, of each machine, so that a runaway machine does not block the
  /// others.
  static constexpr std::size_t kMostPerFrame = 100;

  void inform(std::string_view text) { log(text, false); }
  void note(std::string_view text) { log(text, true); }
  double time_in_state();

  /// The machine that runs now; nullptr while a script is loaded.
  const Machine* running() const { return machine_; }
  bool is_loading() const { return phase_ == Phase::loading; }
  double time() const { return time_; }

 protected:
  void require_acting() const;
  /// Throws if a machine exceeds kMostPerFrame.
  void count_action();
  Machine& machine() const { return *machine_; }
  int state() const { return state_; }
  Issuer issuer() const;

 private:
  void log(std::string_view text, bool is_note);

  ScriptOutput* output_ = nullptr;
  double time_ = 0.0;
  Machine* machine_ = nullptr;
  int state_ = 0;
  Phase phase_ = Phase::loading;

  /// The machine whose log lines and actions are counted; machines tick in sequence.
  const Machine* counted_ = nullptr;
  std::size_t logged_ = 0;
  std::size_t acted_ = 0;
};

}  // namespace reorient
