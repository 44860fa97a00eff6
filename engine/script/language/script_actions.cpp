#include "engine/script/language/script_actions.h"

#include <map>
#include <stdexcept>

#include "engine/script/language/world_tables.h"
#include "engine/script/sandbox/binding.h"

namespace reorient {
namespace {

constexpr std::size_t kMostPerFrame = 100;  // log lines, commands, actions of all scripts

template <typename T>
struct TypeName {
  static std::string of() { return std::string(lua::Value<T>::name); }
};
template <typename T>
struct TypeName<std::optional<T>> {
  static std::string of() { return TypeName<T>::of() + "?"; }
};

template <typename Result, typename... Arguments>
void describe_types(Result (ScriptActions::*)(Arguments...), ScriptFunction& function) {
  const std::vector<std::string> types{TypeName<Arguments>::of()...};
  for (std::size_t i = 0; i < types.size(); ++i) function.arguments.at(i).type = types[i];
  if constexpr (!std::is_void_v<Result>) function.result = TypeName<Result>::of();
}

/// `name` is "table.name" or a global's name.
template <auto Method>
ScriptFunction make(const std::string& name, const std::vector<const char*>& arguments, const char* description,
                    bool for_scenarios = false) {
  ScriptFunction function;
  const std::size_t dot = name.find('.');
  if (dot != std::string::npos) function.table = name.substr(0, dot);
  function.name = dot == std::string::npos ? name : name.substr(dot + 1);
  function.call = &lua::Bound<Method>::call;
  for (const char* argument : arguments) function.arguments.push_back({argument, ""});
  describe_types(Method, function);
  function.description = description;
  function.for_scenarios = for_scenarios;
  return function;
}

}  // namespace

const std::vector<ScriptFunction>& script_functions() {
  using A = ScriptActions;
  static const std::vector<ScriptFunction> functions{
      make<&A::flip_pose>("command.flip_pose", {},
                          "Asks that the belief be turned into its reflection, in this frame."),
      make<&A::purge_reflection>("command.purge_reflection", {},
                                 "Asks that beliefs in the reflected pose be removed, in this frame."),
      make<&A::reset_orientation>("command.reset_orientation", {},
                                  "Asks that the orientation be forgotten and the position kept, in this frame."),
      make<&A::pause_training>("command.pause_training", {},
                               "Stops the training of the background model until the state that says so is left."),
      make<&A::pause_evaluation>("command.pause_evaluation", {},
                                 "Stops the evaluation of the room until the state that says so is left."),
      make<&A::look>(
          "head.look", {"yaw", "pitch", "speed"},
          "Turns the head to these angles (rad; to the left, downwards) at a speed (rad/s). Holds for one frame."),
      make<&A::walk_with>("walk.velocity", {"forward", "left", "turn"},
                          "Walks with this velocity (m/s, m/s, rad/s to the left). Holds for one frame."),
      make<&A::stand>("walk.stand", {}, "Stands still: a walk request like any other. Holds for one frame."),
      make<&A::get_up>("motion.get_up", {}, "Gets up after a fall. Holds for one frame."),
      make<&A::inform>("log.info", {"text"}, "Writes a line into the run's log, with the time and the state."),
      make<&A::time_in_state>("time_in_state", {}, "Seconds since the state was entered whose function asks."),
      make<&A::pick_up>("experimenter.pick_up", {}, "Takes the robot off the ground.", true),
      make<&A::put_down>("experimenter.put_down", {"x", "y", "rotation"},
                         "Puts the robot down at this pose (m, m, rad), upright and standing.", true),
      make<&A::push_over>("experimenter.push_over", {}, "Makes the robot fall.", true),
      make<&A::penalize>("experimenter.penalize", {"penalized"},
                         "Takes the robot out of the game, or lets it in again.", true),
      make<&A::set_exposure_compensation>("experimenter.set_exposure_compensation", {"stops"},
                                          "Changes the hall's light against the camera's exposure, in powers of two.",
                                          true),
      make<&A::set_initial_pose>("belief.set_initial_pose", {"x", "y", "rotation"},
                                 "Tells the robot where it stands (m, m, rad).", true),
      make<&A::succeed>("verdict.succeed", {"text"}, "Ends the run: the robot did right, and why.", true),
      make<&A::fail>("verdict.fail", {"text"}, "Ends the run: the robot did wrong, and why.", true),
  };
  return functions;
}

void add_script_functions(lua_State* L, ScriptActions& actions, bool for_scenario) {
  std::map<std::string, std::vector<const ScriptFunction*>> tables;
  for (const ScriptFunction& function : script_functions()) {
    if (!function.for_scenarios || for_scenario) tables[function.table].push_back(&function);
  }
  for (const auto& [table, functions] : tables) {
    lua_newtable(L);
    for (const ScriptFunction* function : functions) {
      lua_pushlightuserdata(L, &actions);
      lua_pushcclosure(L, function->call, 1);
      if (table.empty()) {
        lua_setglobal(L, function->name.c_str());
      } else {
        lua_setfield(L, -2, function->name.c_str());
      }
    }
    if (table.empty()) {
      lua_pop(L, 1);
    } else {
      make_read_only(L, table);
      lua_setglobal(L, table.c_str());
    }
  }
}

void ScriptActions::require_acting() const {
  if (phase_ == Phase::loading)
    throw std::runtime_error("a script acts in a state's functions, not while it is loaded");
  if (phase_ == Phase::looking) throw std::runtime_error("a condition only looks; act in enter, update or exit");
}

void ScriptActions::reorient_by(Command command) {
  require_acting();
  std::vector<CommandRequest>& commands = draft_->output->commands;
  if (commands.size() >= kMostPerFrame) throw std::runtime_error("too many commands in one frame");
  commands.push_back(
      {command, machine_->definition().name, state_path(), machine_->reason(), machine_->definition().priority});
}

void ScriptActions::pause(Command command) {
  require_acting();
  machine_->lease(command, state_);
}

void ScriptActions::look(double yaw, double pitch, std::optional<double> speed) {
  require_acting();
  if (speed && *speed <= 0.0) throw std::runtime_error("the head's speed is more than 0 rad/s");
  const double priority = machine_->definition().priority;
  if (!(priority > draft_->head_priority)) return;
  draft_->head_priority = priority;
  HeadRequest request;
  request.angles = {yaw, pitch};
  if (speed) request.speed = *speed;
  draft_->output->request.head = request;
}

void ScriptActions::walk_with(double forward, double left, double turn) {
  require_acting();
  const double priority = machine_->definition().priority;
  if (!(priority > draft_->walk_priority)) return;
  draft_->walk_priority = priority;
  draft_->output->request.walk = {forward, left, turn};
}

void ScriptActions::get_up() {
  require_acting();
  draft_->output->request.get_up = true;
}

void ScriptActions::inform(std::string_view text) {
  require_acting();
  if (draft_->output->logs.size() >= kMostPerFrame) return;
  draft_->output->logs.push_back({draft_->time, machine_->definition().name, state_path(), std::string(text)});
}

double ScriptActions::time_in_state() {
  if (phase_ == Phase::loading) throw std::runtime_error("there is no state yet while a script is loaded");
  return draft_->time - machine_->entered_at(state_);
}

void ScriptActions::act(const ExperimenterAction& action) {
  require_acting();
  if (draft_->output->actions.size() >= kMostPerFrame) throw std::runtime_error("too many actions in one frame");
  draft_->output->actions.push_back(action);
}

void ScriptActions::put_down(double x, double y, double rotation) {
  act({ExperimenterAction::Kind::put_down, Pose2(x, y, rotation), 0.0, false});
}

void ScriptActions::set_initial_pose(double x, double y, double rotation) {
  act({ExperimenterAction::Kind::set_initial_pose, Pose2(x, y, rotation), 0.0, false});
}

void ScriptActions::judge(bool succeeded, std::string_view text) {
  require_acting();
  if (!draft_->output->verdict) draft_->output->verdict = ScenarioVerdict{succeeded, std::string(text), draft_->time};
}

}  // namespace reorient
