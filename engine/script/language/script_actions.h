// What scripts can do: the functions behind command, head, walk, motion, log, and for scenarios experimenter, belief
// and verdict. One list of them makes the bindings, the reference page and the editor annotations.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "engine/script/machine/machine.h"
#include "engine/script/script_output.h"

namespace reorient {

/// One frame's output while the scripts write it. The greatest priority has each channel; the first one at a tie.
struct FrameDraft {
  ScriptOutput* output = nullptr;
  double time = 0.0;
  double head_priority = -std::numeric_limits<double>::infinity();
  double walk_priority = -std::numeric_limits<double>::infinity();
};

class ScriptActions {
 public:
  enum class Phase { loading, looking, acting };  ///< looking: a `when` is evaluated, which must not act

  /// Who speaks from now on.
  void speak(FrameDraft* draft, Machine* machine, int state, Phase phase) {
    draft_ = draft;
    machine_ = machine;
    state_ = state;
    phase_ = phase;
  }
  void fall_silent() { speak(nullptr, nullptr, 0, Phase::loading); }

  // command
  void flip_pose() { reorient_by(Command::flip_pose); }
  void purge_reflection() { reorient_by(Command::purge_reflection); }
  void reset_orientation() { reorient_by(Command::reset_orientation); }
  void pause_training() { pause(Command::pause_training); }
  void pause_evaluation() { pause(Command::pause_evaluation); }

  // head, walk, motion
  void look(double yaw, double pitch, std::optional<double> speed);
  void walk_with(double forward, double left, double turn);
  void stand() { walk_with(0.0, 0.0, 0.0); }
  void get_up();

  // log, time
  void inform(std::string_view text);
  double time_in_state();

  // experimenter, belief, verdict
  void pick_up() { act({ExperimenterAction::Kind::pick_up, {}, 0.0, false}); }
  void put_down(double x, double y, double rotation);
  void push_over() { act({ExperimenterAction::Kind::push_over, {}, 0.0, false}); }
  void penalize(bool penalized) { act({ExperimenterAction::Kind::penalize, {}, 0.0, penalized}); }
  void set_exposure_compensation(double stops) {
    act({ExperimenterAction::Kind::set_exposure_compensation, {}, stops, false});
  }
  void set_initial_pose(double x, double y, double rotation);
  void succeed(std::string_view text) { judge(true, text); }
  void fail(std::string_view text) { judge(false, text); }

 private:
  void require_acting() const;
  void reorient_by(Command command);
  void pause(Command command);
  void act(const ExperimenterAction& action);
  void judge(bool succeeded, std::string_view text);
  const std::string& state_path() const { return machine_->definition().states[state_].path; }

  FrameDraft* draft_ = nullptr;
  Machine* machine_ = nullptr;
  int state_ = 0;
  Phase phase_ = Phase::loading;
};

struct ArgumentDoc {
  std::string name;
  std::string type;  ///< "number", "boolean", "string"; with a "?" where it may be left out
};

struct ScriptFunction {
  std::string table;  ///< "command"; empty: a global function
  std::string name;
  lua_CFunction call = nullptr;
  std::vector<ArgumentDoc> arguments;
  std::string result;       ///< type, or empty
  std::string description;  ///< with the units of its arguments
  bool for_scenarios = false;
};

const std::vector<ScriptFunction>& script_functions();

/// Makes the functions as globals of `L`; scenarios get all, behaviours those that are not for_scenarios.
void add_script_functions(lua_State* L, ScriptActions& actions, bool for_scenario);

}  // namespace reorient
