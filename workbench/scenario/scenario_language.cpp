// SPDX-License-Identifier: MIT
#include "workbench/scenario/scenario_language.h"

#include <array>
#include <limits>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/world_fields.h"

namespace reorient {
namespace {

constexpr WorldTable kTruth{"truth", "Where the robot really is; only where a simulator or a tracking camera knows."};

constexpr std::array<WorldField, 5> kTruthFields{{
    {"truth", "x", "m", "position toward the opponents' goal", WorldField::Type::number, {}},
    {"truth", "y", "m", "to the left", WorldField::Type::number, {}},
    {"truth",
     "rotation",
     "rad",
     "direction: 0 toward the opponents' goal, positive to the left",
     WorldField::Type::number,
     {}},
    {"truth", "fallen", "", "the robot really lies", WorldField::Type::boolean, {}},
    {"truth", "carried", "", "the robot really hangs in the air", WorldField::Type::boolean, {}},
}};

/// Throws std::runtime_error with one line where there is no such name.
template <typename Enum>
Enum named(std::string_view name, const char* what) {
  std::vector<std::string> known;
  for (int i = 0; i < enum_count(Enum{}); ++i) {
    known.emplace_back(to_string(static_cast<Enum>(i)));
    if (known.back() == name) return static_cast<Enum>(i);
  }
  throw std::runtime_error(std::string(what) + " cannot be '" + std::string(name) + "'" + did_you_mean(name, known));
}

}  // namespace

Message message_of(std::int64_t sender, std::string_view text) {
  if (sender < 0 || sender > kHighestPlayer) throw std::runtime_error("a sender is the number of a player");
  if (text.size() > kLongestMessage)
    throw std::runtime_error("message has " + std::to_string(text.size()) + " bytes (expected at most 240)");
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
      script_function<&A::pick_up>("operator.pick_up", {}, "Takes the robot off the ground."),
      script_function<&A::put_down>("operator.put_down", {"x", "y", "rotation"},
                                    "Puts the robot down at this pose (m, m, rad), upright and standing."),
      script_function<&A::push_over>("operator.push_over", {}, "Makes the robot fall."),
      script_function<&A::penalize>("operator.penalize", {"penalized"},
                                    "Takes the robot out of the game, or lets it in again."),
      script_function<&A::set_game_state>(
          "operator.set_game_state", {"state"},
          "The referee says: initial, ready, set, playing, finished, standby or unknown."),
      script_function<&A::stop_game>("operator.stop_game", {"stopped"},
                                     "Nobody may move any more, or everybody again."),
      script_function<&A::set_kick_off>("operator.set_kick_off", {"side"},
                                        "Who kicks off next: ours, theirs or nobody."),
      script_function<&A::set_exposure_compensation>(
          "operator.set_exposure_compensation", {"stops"},
          "Changes the hall's light against the camera's exposure, in powers of two."),
      script_function<&A::change_light>("operator.change_light", {},
                                        "Another light begins, as the parameters `light` say."),
      script_function<&A::set_initial_pose>("operator.set_initial_pose", {"x", "y", "rotation"},
                                            "Tells the robot where it stands (m, m, rad)."),
      script_function<&A::tell_message>("operator.tell_message", {"sender", "text"},
                                        "Tells the robot what a team mate says, at most 240 bytes."),
      script_function<&A::half_time>(
          "operator.half_time", {},
          "Tells the robot that the teams change sides; it stays where it is, and from here on "
          "all poses are in the axes of the new half."),
      script_function<&A::draw>("chance.between", {"low", "high"},
                                "A random number from low on and below high; the run's seed says which."),
      script_function<&A::succeed>("verdict.succeed", {"text"}, "Ends the run: the robot did right, and why."),
      script_function<&A::fail>("verdict.fail", {"text"}, "Ends the run: the robot did wrong, and why."),
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

void ScenarioActions::put_down(double x, double y, double rotation) {
  act({OperatorAction::Kind::put_down, Pose2(x, y, rotation), 0.0, false});
}

void ScenarioActions::set_initial_pose(double x, double y, double rotation) {
  act({OperatorAction::Kind::set_initial_pose, Pose2(x, y, rotation), 0.0, false});
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
  if (!(low <= high)) throw std::runtime_error("chance.between wants the lower number first");
  return random_.uniform(low, high);
}

void ScenarioActions::judge(bool succeeded, std::string_view text) {
  require_acting();
  if (!verdict_) verdict_ = ScenarioVerdict{succeeded, std::string(text), time()};
}

void append_scenario_world(const World& world, const std::optional<GroundTruth>& truth, std::vector<double>& values) {
  append_world(world, values);
  if (truth) {
    values.insert(values.end(), {truth->pose.position.x(), truth->pose.position.y(), truth->pose.rotation,
                                 truth->fallen ? 1.0 : 0.0, truth->carried ? 1.0 : 0.0});
  } else {
    values.insert(values.end(), kTruthFields.size(), std::numeric_limits<double>::quiet_NaN());
  }
}

void write_truth(GroundTruth& truth, std::string_view name, const WorldValue& value) {
  std::vector<std::string> known;
  for (const WorldField& field : kTruthFields) {
    known.push_back(field.full_name());
    if (field.name != name) continue;
    const double number = checked_value(field, value);
    if (name == "x") truth.pose.position.x() = number;
    if (name == "y") truth.pose.position.y() = number;
    if (name == "rotation") truth.pose.rotation = number;
    if (name == "fallen") truth.fallen = number != 0.0;
    if (name == "carried") truth.carried = number != 0.0;
    return;
  }
  const std::string wanted = "truth." + std::string(name);
  throw std::runtime_error("unknown world field '" + wanted + "'" + did_you_mean(wanted, known));
}

}  // namespace reorient
