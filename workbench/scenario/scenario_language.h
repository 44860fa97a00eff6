// SPDX-License-Identifier: MIT
// Functions and fields of scenarios: everything that behaviors read, the truth, and the actions of the operator.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/record/frame_record.h"
#include "engine/script/language/script_language.h"
#include "engine/script/language/world_fields.h"
#include "engine/world/world.h"
#include "geometry/const_or.h"
#include "geometry/random.h"
#include "robots/operator.h"
#include "robots/robot.h"

namespace reorient {

/// A requested action of the operator on the robot or its inputs.
struct OperatorAction {
  enum class Kind {
    pick_up,
    put_down,
    push_over,
    penalize,
    set_exposure_compensation,
    set_initial_pose,
    half_time,
    change_light,
    tell_message,
    set_game_state,
    stop_game,
    set_kick_off,
    set_input,
    report_action,
    put_ball
  };
  friend constexpr int enum_count(Kind) { return 15; }

  Kind kind = Kind::pick_up;
  Pose2 pose;              ///< of put_down, set_initial_pose; of put_ball the position
  double stops = 0.0;      ///< of set_exposure_compensation
  bool penalized = false;  ///< of penalize
  Message message{};       ///< of tell_message
  RefereeState referee{};  ///< the field that the kind of action sets
  SetValue value{};        ///< of set_input
  ActionReport report{};   ///< of report_action
};
template <typename Visit, ConstOr<OperatorAction> T>
void fields(Visit&& visit, T& action) {
  visit(action.kind, action.pose, action.stops, action.penalized, action.message, action.referee, action.value,
        action.report);
}

/// A message of a teammate from a script. Throws std::runtime_error with one line if it is invalid.
Message message_of(std::int64_t sender, std::string_view text);

/// The name in scripts.
std::string_view to_string(OperatorAction::Kind kind);

struct ScenarioVerdict {
  bool succeeded = false;
  std::string text;
  double time = 0.0;
};
template <typename Visit, ConstOr<ScenarioVerdict> T>
void fields(Visit&& visit, T& verdict) {
  visit(verdict.succeeded, verdict.text, verdict.time);
}

class ScenarioActions : public ScriptActions {
 public:
  explicit ScenarioActions(std::uint64_t seed) : random_(seed, kStream) {}

  void begin_frame(ScriptOutput& output, double time) override;
  /// Sets the application of the next frame, which must outlive it.
  void set_application(const ApplicationRecord& application) { application_ = &application; }

  const std::vector<OperatorAction>& actions() const { return actions_; }     ///< of this frame
  const std::optional<ScenarioVerdict>& verdict() const { return verdict_; }  ///< does not change after it was given

  void pick_up() { act({OperatorAction::Kind::pick_up, {}, 0.0, false}); }
  void put_down(double x, double y, double rotation);
  void put_ball(double x, double y);
  void push_over() { act({OperatorAction::Kind::push_over, {}, 0.0, false}); }
  void penalize(bool penalized) { act({OperatorAction::Kind::penalize, {}, 0.0, penalized}); }
  void set_game_state(std::string_view state);
  void stop_game(bool stopped);
  void set_kick_off(std::string_view side);
  void set_exposure_compensation(double stops) {
    act({OperatorAction::Kind::set_exposure_compensation, {}, stops, false});
  }
  void change_light() { act({OperatorAction::Kind::change_light, {}, 0.0, false}); }
  void set_initial_pose(double x, double y, double rotation);
  void tell_message(std::int64_t sender, std::string_view text);
  /// Arguments: a table of values (lua_fields.h).
  int set_input(lua_State* L);
  std::string_view action_state(std::string_view name) { return to_string(status_of(name).state); }
  /// Arguments: the names of an action and of one of its arguments. Returns the content.
  int action_argument(lua_State* L);
  void report_action(std::string_view name, std::string_view state, std::optional<std::string_view> reason);
  void half_time() { act({OperatorAction::Kind::half_time, {}, 0.0, false}); }
  /// A number in [low, high): deterministic for the seed and the sequence of calls.
  double draw(double low, double high);
  void succeed(std::string_view text) { judge(true, text); }
  void fail(std::string_view text) { judge(false, text); }

 private:
  void act(const OperatorAction& action);
  void judge(bool succeeded, std::string_view text);
  const ActionStatus& status_of(std::string_view name) const;

  static constexpr std::uint64_t kStream = 0xc4a9ce;

  Random random_;
  std::vector<OperatorAction> actions_;
  std::optional<ScenarioVerdict> verdict_;
  ApplicationRecord nothing_;
  const ApplicationRecord* application_ = &nothing_;
};

class ScenarioLanguage : public ScriptLanguage {
 public:
  /// `seed`: of the random numbers of a scenario.
  explicit ScenarioLanguage(std::uint64_t seed = 1) : actions_(seed) {}

  ScriptKind kind() const override { return ScriptKind::scenario; }
  std::string_view folder() const override { return "scenarios"; }
  std::span<const WorldTable> tables() const override;
  std::span<const WorldField> world() const override;
  std::span<const ScriptFunction> functions() const override;
  std::span<const FormerTable> former_tables() const override;
  ScenarioActions& actions() override { return actions_; }
  const ScenarioActions& actions() const { return actions_; }

 private:
  ScenarioActions actions_;
};

/// Appends the values of the language's fields; NaN for what is unknown.
void append_scenario_world(const World& world, const std::optional<GroundTruth>& truth,
                           const std::optional<BallTruth>& ball, std::vector<double>& values);

/// For tests: as write_world(), for the table `truth`.
void write_truth(std::optional<GroundTruth>& truth, std::optional<BallTruth>& ball, std::string_view name,
                 const WorldValue& value);

}  // namespace reorient
