// SPDX-License-Identifier: MIT
#include "workbench/scenario/scenario_language.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/lua_fields.h"
#include "engine/script/language/world_fields.h"
#include "geometry/settable_pose.h"

namespace reorient {
namespace {

constexpr WorldTable kTruth{"truth",
                            "The true pose of the robot, only available from a simulator or a tracking camera, and the "
                            "true ball, only available from a simulator that has one."};

constexpr std::size_t kBallFields = 4;  // the last ones
constexpr std::array<WorldField, 5 + kBallFields> kTruthFields{{
    {"truth", "x", "m", "position toward the opponents' goal", WorldField::Type::number, {}},
    {"truth", "y", "m", "position to the left", WorldField::Type::number, {}},
    {"truth",
     "rotation",
     "rad",
     "direction: 0 toward the opponents' goal, positive to the left",
     WorldField::Type::number,
     {}},
    {"truth", "fallen", "", "whether the robot truly lies on the ground", WorldField::Type::boolean, {}},
    {"truth", "carried", "", "whether the robot is truly in the air", WorldField::Type::boolean, {}},
    {"truth", "ball_x", "m", "true position of the ball toward the opponents' goal", WorldField::Type::number, {}},
    {"truth", "ball_y", "m", "true position of the ball to the left", WorldField::Type::number, {}},
    {"truth", "score", "", "number of times the ball rolled into the opponents' goal", WorldField::Type::number, {}},
    {"truth",
     "score_of_opponents",
     "",
     "number of times the ball rolled into the own goal",
     WorldField::Type::number,
     {}},
}};

/// Throws std::runtime_error with one line for an unknown name.
template <typename Enum>
Enum named(std::string_view name, const char* what) {
  std::vector<std::string> known;
  for (int i = 0; i < enum_count(Enum{}); ++i) {
    known.emplace_back(to_string(static_cast<Enum>(i)));
    if (known.back() == name) return static_cast<Enum>(i);
  }
  throw std::runtime_error("unknown " + std::string(what) + " '" + std::string(name) + "'" + did_you_mean(name, known));
}

}  // namespace

Message message_of(std::int64_t sender, std::string_view text) {
  if (sender < 0 || sender > kHighestPlayer)
    throw std::runtime_error("sender: expected 0 to " + std::to_string(kHighestPlayer) + ", found " +
                             std::to_string(sender));
  if (text.size() > kLongestMessage)
    throw std::runtime_error("message: expected at most 240 bytes, found " + std::to_string(text.size()));
  return {static_cast<int>(sender), std::string(text)};
}

std::string_view to_string(OperatorAction::Kind kind) {
  switch (kind) {
    case OperatorAction::Kind::pick_up:
      return "pick_up";
    case OperatorAction::Kind::put_down:
      return "put_down";
    case OperatorAction::Kind::push_over:
      return "push_over";
    case OperatorAction::Kind::penalize:
      return "penalize";
    case OperatorAction::Kind::set_exposure_compensation:
      return "set_exposure_compensation";
    case OperatorAction::Kind::change_light:
      return "change_light";
    case OperatorAction::Kind::set_initial_pose:
      return "set_initial_pose";
    case OperatorAction::Kind::half_time:
      return "half_time";
    case OperatorAction::Kind::tell_message:
      return "tell_message";
    case OperatorAction::Kind::set_game_state:
      return "set_game_state";
    case OperatorAction::Kind::stop_game:
      return "stop_game";
    case OperatorAction::Kind::set_kick_off:
      return "set_kick_off";
    case OperatorAction::Kind::set_input:
      return "set_input";
    case OperatorAction::Kind::report_action:
      return "report_action";
    case OperatorAction::Kind::put_ball:
      return "put_ball";
  }
  return "";
}

std::span<const WorldTable> ScenarioLanguage::tables() const {
  static const std::vector<WorldTable> tables = [] {
    std::vector<WorldTable> all(world_tables().begin(), world_tables().end());
    all.push_back(kTruth);
    return all;
  }();
  return tables;
}

std::span<const WorldField> ScenarioLanguage::world() const {
  static const std::vector<WorldField> fields = [] {
    std::vector<WorldField> all(world_fields().begin(), world_fields().end());
    all.insert(all.end(), kTruthFields.begin(), kTruthFields.end());
    return all;
  }();
  return fields;
}

std::span<const ScriptFunction> ScenarioLanguage::functions() const {
  using A = ScenarioActions;
  static const std::vector<ScriptFunction> functions{
      script_function<&A::pick_up>("operator.pick_up", {}, "Lifts the robot."),
      script_function<&A::put_down>("operator.put_down", {"x", "y", "rotation"},
                                    "Places the robot at this pose (m, m, rad), upright and standing."),
      script_function<&A::put_ball>("operator.put_ball", {"x", "y"},
                                    "Places the ball at this position (m), at rest. No effect without a ball."),
      script_function<&A::push_over>("operator.push_over", {}, "Makes the robot fall."),
      script_function<&A::penalize>("operator.penalize", {"penalized"}, "Penalizes the robot, or ends the penalty."),
      script_function<&A::set_game_state>(
          "operator.set_game_state", {"state"},
          "Sets the state of the game: initial, ready, set, playing, finished, standby or unknown."),
      script_function<&A::stop_game>("operator.stop_game", {"stopped"},
                                     "Stops all motion of the robots, or permits it again."),
      script_function<&A::set_kick_off>("operator.set_kick_off", {"side"},
                                        "Sets the team that kicks off next: one of the values of game.kick_off."),
      script_function<&A::set_exposure_compensation>(
          "operator.set_exposure_compensation", {"stops"},
          "Changes the hall's light relative to the camera's exposure, in powers of two."),
      script_function<&A::change_light>("operator.change_light", {},
                                        "Changes the light as set by the parameters `light`."),
      script_function<&A::set_initial_pose>("operator.set_initial_pose", {"x", "y", "rotation"},
                                            "Sets the initial pose (m, m, rad)."),
      script_function<&A::tell_message>("operator.tell_message", {"sender", "text"},
                                        "Sends the robot a message of a teammate, at most 240 bytes."),
      raw_script_function<A, &A::set_input>(
          "application", "set", {{"values", "table"}}, "",
          "Sets values of the application, which the scenario plays, as in { ball = { x = 1.0, seen = true } }."),
      script_function<&A::action_state>("application.state", {"action"},
                                        "State of an action's latest start: idle, requested, running, done or failed."),
      raw_script_function<A, &A::action_argument>("application", "argument",
                                                  {{"action", "string"}, {"argument", "string"}}, "any",
                                                  "An argument of an action's latest start."),
      script_function<&A::report_action>(
          "application.report", {"action", "state", "reason"},
          "Reports that the latest start of an action is running, done or failed, with a reason."),
      script_function<&A::half_time>("operator.half_time", {},
                                     "Signals that the teams change sides. The robot stays in place, and from then on "
                                     "all poses are in the axes of the new half."),
      script_function<&A::draw>("chance.between", {"low", "high"},
                                "A random number, at least low and less than high, from the run's seed."),
      script_function<&A::succeed>("verdict.succeed", {"text"}, "Ends the run as succeeded, with a reason."),
      script_function<&A::fail>("verdict.fail", {"text"}, "Ends the run as failed, with a reason."),
      script_function<&A::inform>("log.info", {"text"}, "Writes a line to the run's log, with time and state."),
      script_function<&A::note>(
          "log.note", {"text"},
          "Writes a line to the run's log and marks it as a note, which can be searched for in a recording."),
      script_function<&A::time_in_state>("time_in_state", {}, "Seconds since the calling state was entered."),
  };
  return functions;
}

std::span<const FormerTable> ScenarioLanguage::former_tables() const {
  static constexpr FormerTable kFormer[] = {{"experimenter", "operator"}};
  return kFormer;
}

void ScenarioActions::begin_frame(ScriptOutput& output, double time) {
  ScriptActions::begin_frame(output, time);
  actions_.clear();
}

void ScenarioActions::act(const OperatorAction& action) {
  require_acting();
  count_action();
  actions_.push_back(action);
}

namespace {

Pose2 settable_pose(const std::string& function, double x, double y, double rotation) {
  if (const std::string mistake = mistake_in_pose(x, y, rotation); !mistake.empty())
    throw std::runtime_error(function + ": " + mistake);
  return Pose2(x, y, rotation);
}

}  // namespace

void ScenarioActions::put_down(double x, double y, double rotation) {
  act({OperatorAction::Kind::put_down, settable_pose("operator.put_down", x, y, rotation), 0.0, false});
}

void ScenarioActions::set_initial_pose(double x, double y, double rotation) {
  act({OperatorAction::Kind::set_initial_pose, settable_pose("operator.set_initial_pose", x, y, rotation), 0.0, false});
}

void ScenarioActions::put_ball(double x, double y) {
  act({OperatorAction::Kind::put_ball, settable_pose("operator.put_ball", x, y, 0.0), 0.0, false});
}

const ActionStatus& ScenarioActions::status_of(std::string_view name) const {
  return application_->actions[action_named(*application_->declared, name)];
}

int ScenarioActions::set_input(lua_State* L) {
  constexpr std::int64_t kPriceOfSetting = 500;
  Sandbox::of(L).charge(kPriceOfSetting);
  require_acting();
  for (SetValue& value : read_inputs(L, 1, *application_->declared)) {
    OperatorAction action{OperatorAction::Kind::set_input, {}, 0.0, false};
    action.value = std::move(value);
    act(action);
  }
  return 0;
}

int ScenarioActions::action_argument(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1), argument = luaL_checkstring(L, 2);
  const std::uint16_t action = action_named(*application_->declared, name);
  const ActionStatus& status = application_->actions[action];
  if (status.id == 0) throw std::runtime_error("application.argument: action '" + name + "' was never requested");
  push_argument(L, application_->declared->actions[action].arguments, status.arguments, argument, "action." + name);
  return 1;
}

void ScenarioActions::report_action(std::string_view name, std::string_view state,
                                    std::optional<std::string_view> reason) {
  OperatorAction action{OperatorAction::Kind::report_action, {}, 0.0, false};
  action.report = report_of(status_of(name).id, state, reason.value_or(""));
  act(action);
}

void ScenarioActions::set_game_state(std::string_view state) {
  OperatorAction action{OperatorAction::Kind::set_game_state, {}, 0.0, false};
  action.referee.state = named<GameState>(state, "a game's state");
  act(action);
}

void ScenarioActions::stop_game(bool stopped) {
  OperatorAction action{OperatorAction::Kind::stop_game, {}, 0.0, false};
  action.referee.stopped = stopped;
  act(action);
}

void ScenarioActions::set_kick_off(std::string_view side) {
  OperatorAction action{OperatorAction::Kind::set_kick_off, {}, 0.0, false};
  action.referee.kick_off = named<KickOff>(side, "who kicks off");
  act(action);
}

void ScenarioActions::tell_message(std::int64_t sender, std::string_view text) {
  OperatorAction action{OperatorAction::Kind::tell_message, {}, 0.0, false};
  action.message = message_of(sender, text);
  act(action);
}

double ScenarioActions::draw(double low, double high) {
  require_acting();
  if (!(low <= high))
    throw std::runtime_error("chance.between: expected the lower number first, found " + std::to_string(low) + " and " +
                             std::to_string(high));
  return random_.uniform(low, high);
}

void ScenarioActions::judge(bool succeeded, std::string_view text) {
  require_acting();
  if (!verdict_) verdict_ = ScenarioVerdict{succeeded, std::string(text), time()};
}

void append_scenario_world(const World& world, const std::optional<GroundTruth>& truth,
                           const std::optional<BallTruth>& ball, std::vector<double>& values) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  append_world(world, values);
  if (truth) {
    values.insert(values.end(), {truth->pose.position.x(), truth->pose.position.y(), truth->pose.rotation,
                                 truth->fallen ? 1.0 : 0.0, truth->carried ? 1.0 : 0.0});
  } else {
    values.insert(values.end(), kTruthFields.size() - kBallFields, kUnknown);
  }
  if (ball) {
    values.insert(values.end(), {ball->position.x(), ball->position.y(), static_cast<double>(ball->goals),
                                 static_cast<double>(ball->opponents_goals)});
  } else {
    values.insert(values.end(), kBallFields, kUnknown);
  }
}

namespace {

/// Returns false for a field that is not of the robot.
bool write_robot(GroundTruth& truth, std::string_view name, double number) {
  if (name == "x") {
    truth.pose.position.x() = number;
  } else if (name == "y") {
    truth.pose.position.y() = number;
  } else if (name == "rotation") {
    truth.pose.rotation = number;
  } else if (name == "fallen") {
    truth.fallen = number != 0.0;
  } else if (name == "carried") {
    truth.carried = number != 0.0;
  } else {
    return false;
  }
  return true;
}

void write_ball(BallTruth& ball, std::string_view name, double number) {
  constexpr double kMostGoals = 1000.0;
  if (name == "ball_x") ball.position.x() = number;
  if (name == "ball_y") ball.position.y() = number;
  if (name == "score") ball.goals = static_cast<int>(std::clamp(number, 0.0, kMostGoals));
  if (name == "score_of_opponents") ball.opponents_goals = static_cast<int>(std::clamp(number, 0.0, kMostGoals));
}

}  // namespace

void write_truth(std::optional<GroundTruth>& truth, std::optional<BallTruth>& ball, std::string_view name,
                 const WorldValue& value) {
  std::vector<std::string> known;
  for (const WorldField& field : kTruthFields) {
    known.push_back(field.full_name());
    if (field.name != name) continue;
    const double number = checked_value(field, value);
    GroundTruth changed = truth.value_or(GroundTruth());
    if (write_robot(changed, name, number)) {
      truth = changed;
    } else {
      write_ball(ball ? *ball : ball.emplace(), name, number);
    }
    return;
  }
  const std::string wanted = "truth." + std::string(name);
  throw std::runtime_error("unknown world field '" + wanted + "'" + did_you_mean(wanted, known));
}

}  // namespace reorient
