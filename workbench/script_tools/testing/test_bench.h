// SPDX-License-Identifier: MIT
// A fake world with a fake clock in which scripted tests run behaviors.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/behaviors.h"
#include "engine/world/arbiter.h"
#include "workbench/scenario/scenario_host.h"
#include "workbench/script_tools/testing/coverage.h"
#include "workbench/script_tools/testing/fake_world.h"
#include "workbench/script_tools/testing/played_recording.h"
#include "workbench/script_tools/testing/simulation.h"
#include "workbench/script_tools/testing/test_budget.h"

namespace reorient {

/// A failed expectation and its position.
struct TestFailure {
  std::string file;
  int line = 0;
  std::string text;  ///< may have several lines
};

/// The text, shortened for messages.
std::string shortened(std::string text);

/// The environment of one test, on which `load_behavior`, `set_world`, `advance`, `reload` and `expect` act.
class TestBench {
 public:
  /// `texts`: all scripts below the root. If `simulate` is empty, simulate() ends the test and needs_simulator() is
  /// true. If `play_recording` or `load_interface` is empty, replay() or load_interface() is an error.
  TestBench(std::filesystem::path scripts_root, ScriptTexts texts, const Simulate& simulate,
            const PlayRecording& play_recording, const LoadInterface& load_interface, TestBudget& budget,
            CoverageTrace& trace);

  /// Adds the functions to the globals of `L`.
  void add_to(lua_State* L);

  /// All failures so far, including unexpected errors of scripts.
  std::vector<TestFailure> finish();
  /// One line for each former name that the test uses.
  const std::set<std::string>& warnings() const { return warnings_; }
  /// Lines that the test printed.
  const std::vector<std::string>& printed() const { return printed_; }
  bool needs_simulator() const { return needs_simulator_; }
  /// The test was ended because of its budget; finish() lists that as a failure.
  bool exceeded_budget() const { return exceeded_budget_; }

 private:
  // Functions of a test.
  int load_behavior(lua_State* L);
  int load_scenario(lua_State* L);
  int set_world(lua_State* L);
  int set_input(lua_State* L);
  int advance(lua_State* L);
  int reload(lua_State* L);
  int simulate(lua_State* L);
  int print(lua_State* L);
  void set_param(std::string_view name, std::string_view value);
  void hear(std::int64_t sender, std::string_view text);
  void load_interface(std::string_view name);
  void report_action(std::string_view name, std::string_view state, std::optional<std::string_view> reason);
  // test_replay.cpp
  void replay(std::string_view file);
  void advance_to(double time);
  int world_value(lua_State* L);

  // Expectations of the frames of the last advance(), or of a simulation: test_expectations.cpp.
  void expect_state(std::string_view machine, std::string_view path);
  void expect_reason(std::string_view machine, std::string_view text);
  void expect_command(std::string_view name, std::optional<std::string_view> verdict);
  void expect_no_command(std::optional<std::string_view> name);
  void expect_lease(std::string_view name);
  void expect_no_lease(std::string_view name);
  void expect_head(double yaw, double pitch);
  void expect_walk(double forward, double left, double turn);
  void expect_get_up(bool requested);
  void expect_log(std::string_view text);
  void expect_message(std::string_view text);
  void expect_action(std::string_view name);
  void expect_verdict(bool succeeded, std::string_view text);
  int expect_started(lua_State* L);
  void expect_not_started(std::string_view name);
  void expect_error(std::string_view text);
  void expect_refused(std::string_view text);
  int expect_equal(lua_State* L);
  void expect_near(double actual, double expected, double tolerance);
  void expect_as_recorded();

  template <auto Method>
  void add_function(lua_State* L, const char* name);
  void add_expectations(lua_State* L);
  Behaviors& behaviors();
  const World& world() const { return replay_ ? replayed_world_ : fake_world_.world(); }
  void step();
  void set_application(double time);
  void begin_advance();
  bool step_replay();
  void require_fake_world(const char* what) const;
  void require_budget(lua_State* L);
  void within_budget(const std::function<void()>& play);
  std::string known_state(std::string_view machine, std::string_view path);
  void read_machines();
  void fail(const std::string& expected, const std::string& actual);
  void fail(const std::string& text);
  TestFailure failure_here(const std::string& text) const;
  std::string file_of(const std::string& script) const;
  void expect_text(std::string_view text, const std::vector<std::string>& seen, const std::string& what);
  bool has_lease(std::string_view name) const;
  std::string commands_seen() const;
  std::string started_text(const StartedAction& started) const;

  std::filesystem::path root_;
  ScriptTexts texts_;
  const Simulate& simulate_;
  const PlayRecording& play_recording_;
  const LoadInterface& load_interface_;
  TestBudget& budget_;
  CoverageTrace& trace_;
  bool needs_simulator_ = false;
  bool exceeded_budget_ = false;
  lua_State* lua_ = nullptr;

  ParameterRegistry parameters_;
  std::vector<ParameterChange> changes_;  ///< for a scenario that is loaded later
  /// Parameters that were set before a script declared them, with the position in the test.
  std::map<std::string, TestFailure> early_changes_;
  ArbiterParameters arbiter_parameters_;
  ScriptLimits limits_;
  FakeWorld fake_world_{parameters_};
  bool is_pose_set_ = false;  ///< since the last frame
  long frame_ = 0;
  World replayed_world_;           ///< of the last frame of a replay
  std::vector<Message> messages_;  ///< sent with the next frame
  std::vector<SetValue> inputs_;   ///< set with the next frame
  std::vector<ActionReport> reports_;
  ApplicationState application_;
  ApplicationRecord application_record_;  ///< as the scenario sees it
  std::vector<StartedAction> started_;    ///< since the last advance() began
  std::optional<GroundTruth> truth_;
  std::optional<BallTruth> ball_;
  std::unique_ptr<Behaviors> behaviors_;
  RecordedBehaviors recorded_;  ///< the behaviors as the scenario sees them
  std::unique_ptr<ScenarioHost> scenario_;
  Arbiter arbiter_;
  std::string last_script_;

  std::unique_ptr<PlayedRecording> replay_;  ///< used by the test instead of a fake world
  FrameInputs added_;                        ///< to the next frame of the replay
  std::vector<SeenMachine> replayed_machines_;

  std::vector<TestFailure> failures_;
  std::set<std::string> warnings_;
  std::vector<std::string> printed_;
  std::vector<ScriptFault> faults_;      ///< not yet expected
  std::optional<ScriptFault> refused_;   ///< not yet expected
  SeenFrames seen_;                      ///< in the last advance(); transitions: in the whole test
  std::vector<Lease> leases_;            ///< active after it
  std::vector<MachineStatus> statuses_;  ///< of the behaviors, after it
  std::vector<NameId> published_;
  Request request_;
};

}  // namespace reorient
