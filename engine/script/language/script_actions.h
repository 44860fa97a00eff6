// SPDX-License-Identifier: MIT
// What every script can do, whatever its kind: write into the log, ask how long its state has lasted. Behaviours and
// scenarios add their own (behavior_language.h; the workbench's scenario_language.h).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/script/machine/machine.h"
#include "engine/script/script_output.h"

namespace reorient {

/// The object that a kind of script's functions act on; one for all scripts of a host, since they speak one after
/// the other.
class ScriptActions {
 public:
  enum class Phase { loading, looking, acting };  ///< looking: a `when` is evaluated, which must not act

  virtual ~ScriptActions() = default;

  /// Before the machines tick.
  virtual void begin_frame(ScriptOutput& output, double time) {
    output_ = &output;
    time_ = time;
    counted_ = nullptr;
  }

  /// Who speaks from now on.
  void speak(Machine* machine, int state, Phase phase);
  void fall_silent() { speak(nullptr, 0, Phase::loading); }

  /// Log lines, and commands or actions, of each machine: one that is out of its mind silences no other.
  static constexpr std::size_t kMostPerFrame = 100;

  void inform(std::string_view text) { log(text, false); }
  void note(std::string_view text) { log(text, true); }
  double time_in_state();

 protected:
  void require_acting() const;
  /// Throws where a machine has done too much in this frame.
  void count_action();
  Machine& machine() const { return *machine_; }
  int state() const { return state_; }
  double time() const { return time_; }
  Issuer issuer() const;

 private:
  void log(std::string_view text, bool is_note);

  ScriptOutput* output_ = nullptr;
  double time_ = 0.0;
  Machine* machine_ = nullptr;
  int state_ = 0;
  Phase phase_ = Phase::loading;

  const Machine* counted_ = nullptr;  ///< whose log lines and actions these are; machines tick one after the other
  std::size_t logged_ = 0;
  std::size_t acted_ = 0;
};

}  // namespace reorient
