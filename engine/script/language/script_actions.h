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
  }

  /// Who speaks from now on.
  void speak(Machine* machine, int state, Phase phase) {
    machine_ = machine;
    state_ = state;
    phase_ = phase;
  }
  void fall_silent() { speak(nullptr, 0, Phase::loading); }

  void inform(std::string_view text);
  double time_in_state();

 protected:
  static constexpr std::size_t kMostPerFrame = 100;  ///< log lines, commands, actions of all scripts

  void require_acting() const;
  Machine& machine() const { return *machine_; }
  int state() const { return state_; }
  double time() const { return time_; }
  Issuer issuer() const;

 private:
  ScriptOutput* output_ = nullptr;
  double time_ = 0.0;
  Machine* machine_ = nullptr;
  int state_ = 0;
  Phase phase_ = Phase::loading;
};

}  // namespace reorient
