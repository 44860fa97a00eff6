// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/test_bench.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "engine/script/language/script_arguments.h"
#include "engine/script/language/world_fields.h"
#include "engine/script/sandbox/binding.h"
#include "engine/script/sandbox/safe_library.h"
#include "engine/script/script_error.h"
#include "workbench/files/script_files.h"
#include "workbench/script_tools/testing/simulation_request.h"

namespace reorient {
namespace {

constexpr double kFramesPerSecond = 30.0;
constexpr double kLongestAdvance = 3600.0;  // s, of one advance()
constexpr std::size_t kMostFailures = 100;
constexpr std::size_t kLongestFailure = 10'000;  // bytes
constexpr std::size_t kMostPrinted = 1000;       // lines

/// Throws std::runtime_error if the result is larger than a script may be.
std::string replace_all(const std::string& text, const std::string& from, const std::string& to) {
  std::string result;
  std::size_t copied = 0;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, copied)) {
    result.append(text, copied, at - copied).append(to);
    copied = at + from.size();
    if (result.size() > kLargestScript)
      throw std::runtime_error("reload: the edited script would be longer than 64 KiB");
  }
  return result.append(text, copied);
}

std::string text_field(lua_State* L, int table, const char* name) {
  lua_getfield(L, table, name);
  std::string text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return text;
}

}  // namespace

std::string shortened(std::string text) {
  if (text.size() <= kLongestFailure) return text;
  text.resize(kLongestFailure);
  return text + " ...";
}

TestBench::TestBench(std::filesystem::path scripts_root, ScriptTexts texts, const Simulate& simulate,
                     const PlayRecording& play_recording, const LoadInterface& load_interface, TestBudget& budget,
                     CoverageTrace& trace)
    : root_(std::move(scripts_root)),
      texts_(std::move(texts)),
      simulate_(simulate),
      play_recording_(play_recording),
      load_interface_(load_interface),
      budget_(budget),
      trace_(trace) {
  parameters_.bind("arbiter", arbiter_parameters_);
  parameters_.bind("script", limits_);
}

template <auto Method>
void TestBench::add_function(lua_State* L, const char* name) {
  lua_pushlightuserdata(L, this);
  const lua_CFunction call = [](lua_State* state) {
    static_cast<TestBench*>(lua_touserdata(state, lua_upvalueindex(1)))->require_budget(state);
    if constexpr (std::is_same_v<decltype(Method), int (TestBench::*)(lua_State*)>) {
      return lua::RawBound<Method>::call(state);
    } else {
      return lua::Bound<Method>::call(state);
    }
  };
  lua_pushcclosure(L, call, 1);
  lua_setfield(L, -2, name);
}

void TestBench::add_to(lua_State* L) {
  lua_ = L;
  lua_pushglobaltable(L);
  add_function<&TestBench::load_behavior>(L, "load_behavior");
  add_function<&TestBench::load_scenario>(L, "load_scenario");
  add_function<&TestBench::set_world>(L, "set_world");
  add_function<&TestBench::load_interface>(L, "load_interface");
  add_function<&TestBench::set_input>(L, "set_input");
  add_function<&TestBench::report_action>(L, "report_action");
  add_function<&TestBench::set_param>(L, "set_param");
  add_function<&TestBench::hear>(L, "hear");
  add_function<&TestBench::advance>(L, "advance");
  add_function<&TestBench::reload>(L, "reload");
  add_function<&TestBench::simulate>(L, "simulate");
  add_function<&TestBench::replay>(L, "replay");
  add_function<&TestBench::advance_to>(L, "advance_to");
  add_function<&TestBench::world_value>(L, "world_value");
  add_function<&TestBench::print>(L, "print");
  lua_pushcfunction(L, [](lua_State* state) {
    return luaL_error(
        state, "require: a library runs only with a script that uses it (expected load_behavior or load_scenario)");
  });
  lua_setfield(L, -2, "require");
  lua_newtable(L);
  add_expectations(L);
  lua_setfield(L, -2, "expect");
  lua_pop(L, 1);
}

void TestBench::add_expectations(lua_State* L) {
  add_function<&TestBench::expect_state>(L, "state");
  add_function<&TestBench::expect_reason>(L, "reason");
  add_function<&TestBench::expect_command>(L, "command");
  add_function<&TestBench::expect_no_command>(L, "no_command");
  add_function<&TestBench::expect_lease>(L, "lease");
  add_function<&TestBench::expect_no_lease>(L, "no_lease");
  add_function<&TestBench::expect_head>(L, "head");
  add_function<&TestBench::expect_walk>(L, "walk");
  add_function<&TestBench::expect_get_up>(L, "get_up");
  add_function<&TestBench::expect_log>(L, "log");
  add_function<&TestBench::expect_message>(L, "message");
  add_function<&TestBench::expect_action>(L, "action");
  add_function<&TestBench::expect_verdict>(L, "verdict");
  add_function<&TestBench::expect_started>(L, "started");
  add_function<&TestBench::expect_not_started>(L, "not_started");
  add_function<&TestBench::expect_error>(L, "error");
  add_function<&TestBench::expect_refused>(L, "refused");
  add_function<&TestBench::expect_equal>(L, "equal");
  add_function<&TestBench::expect_near>(L, "near");
  add_function<&TestBench::expect_as_recorded>(L, "as_recorded");
}

Behaviors& TestBench::behaviors() {
  if (!behaviors_) {
    behaviors_ = std::make_unique<Behaviors>(texts_, application_, parameters_, limits_);
    arbiter_ = Arbiter(arbiter_parameters_);
  }
  return *behaviors_;
}

TestFailure TestBench::failure_here(const std::string& text) const {
  lua_Debug record;
  TestFailure failure{"", 0, shortened(text)};
  if (lua_getstack(lua_, 1, &record) != 0 && lua_getinfo(lua_, "Sl", &record) != 0) {
    failure.file = record.source[0] == '@' ? record.source + 1 : record.source;
    failure.line = record.currentline;
  }
  return failure;
}

void TestBench::fail(const std::string& text) { failures_.push_back(failure_here(text)); }

void TestBench::fail(const std::string& expected, const std::string& actual) {
  fail("expected " + as_line(expected) + "\n  actual " + as_line(actual));
}

/// Ends the test if it has exceeded its limits. The `pcall` of a script cannot catch that.
void TestBench::require_budget(lua_State* L) {
  const bool has_failed_enough = failures_.size() >= kMostFailures;
  if (!has_failed_enough && !budget_.exceeded()) return;
  fail(has_failed_enough ? "ended after " + std::to_string(kMostFailures) + " failures" : budget_.reason());
  exceeded_budget_ = true;
  Sandbox& sandbox = Sandbox::of(L);
  sandbox.charge(sandbox.remaining() + 1);
}

std::vector<TestFailure> TestBench::finish() {
  std::vector<std::string> known;
  for (const Parameter& parameter : parameters_.list()) known.push_back(parameter.name);
  if (scenario_) {
    for (const Parameter& parameter : scenario_->parameters().list()) known.push_back(parameter.name);
  }
  for (auto& [name, place] : early_changes_) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    if (failures_.size() > kMostFailures) break;
    place.text =
        "unknown parameter '" + shortened(name) + "' of the scripts that this test loads" + did_you_mean(name, known);
    failures_.push_back(std::move(place));
  }
  for (const ScriptFault& fault : faults_) {
    if (failures_.size() > kMostFailures) break;
    failures_.push_back({fault.file, fault.line, shortened(as_line(fault.message) + "\n" + fault.traceback)});
  }
  if (refused_)
    failures_.push_back({refused_->file, refused_->line, shortened(as_line("refused: " + refused_->message))});
  return failures_;
}

namespace {

/// The table of arguments at `index`; none: no table is there. Throws std::runtime_error with one line.
std::vector<CallArgument> arguments_at(lua_State* L, int index) {
  std::vector<CallArgument> arguments;
  if (lua_isnoneornil(L, index)) return arguments;
  luaL_checktype(L, index, LUA_TTABLE);
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING)
      throw std::runtime_error(
          "load_behavior: expected named arguments, as in load_behavior(\"walk_to\", { x = 1.0 })");
    CallArgument argument;
    argument.name = lua_tostring(L, -2);
    const std::optional<ParameterValue> value = parameter_value(L, -1);
    if (!value) {
      throw std::runtime_error("load_behavior: " + argument.name +
                               ": expected a number, a boolean or a string, found a " + luaL_typename(L, -1));
    }
    argument.value = *value;
    arguments.push_back(std::move(argument));
  }
  return arguments;
}

}  // namespace

// ---- functions of a test

int TestBench::load_behavior(lua_State* L) {
  require_fake_world("load_behavior");
  const std::string name = luaL_checkstring(L, 1);
  const std::string script = script_named(root_, name);
  ScriptHost& host = behaviors().host();
  const std::size_t before = host.definitions().size();
  host.load(script, arguments_at(L, 2));
  if (host.definitions().size() == before) throw std::runtime_error("load_behavior: '" + name + "' is already loaded");
  last_script_ = name;
  read_machines();
  return 0;
}

int TestBench::load_scenario(lua_State* L) {
  require_fake_world("load_scenario");
  last_script_ = luaL_checkstring(L, 1);
  scenario_ = std::make_unique<ScenarioHost>(texts_, script_named(root_, last_script_), changes_, recorded_);
  for (const std::string& behavior : scenario_->wanted_behaviors()) behaviors().host().load(behavior);
  read_machines();
  return 0;
}

/// set_world { confidence = { opposite = 0.9 }, robot = { posture = "lying" } }
int TestBench::set_world(lua_State* L) {
  require_fake_world("set_world");
  luaL_checktype(L, 1, LUA_TTABLE);
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING || lua_type(L, -1) != LUA_TTABLE) {
      throw std::runtime_error(
          "set_world: expected tables of world fields, as in set_world { robot = { posture = \"lying\" } }");
    }
    const std::string table = lua_tostring(L, -2);
    const int fields = lua_gettop(L);
    for (lua_pushnil(L); lua_next(L, fields) != 0; lua_pop(L, 1)) {
      if (lua_type(L, -2) != LUA_TSTRING)
        throw std::runtime_error("set_world: expected the name of a field of " + table + ", found another key");
      WorldValue value;
      if (lua_type(L, -1) == LUA_TBOOLEAN) {
        value.type = WorldField::Type::boolean;
        value.number = lua_toboolean(L, -1);
      } else if (lua_type(L, -1) == LUA_TSTRING) {
        value.type = WorldField::Type::name;
        value.name = lua_tostring(L, -1);
      } else if (lua_type(L, -1) == LUA_TNUMBER) {
        value.number = lua_tonumber(L, -1);
      } else {
        throw std::runtime_error("set_world: expected a number, a string, true or false");
      }
      if (table == "truth") {
        write_truth(truth_, ball_, lua_tostring(L, -2), value);
      } else {
        const bool was_known = world().pose_known;
        fake_world_.set(table, lua_tostring(L, -2), value);
        // Later, the pose becomes known because it is set.
        is_pose_set_ |= frame_ > 0 && world().pose_known && !was_known;
      }
    }
  }
  return 0;
}

void TestBench::set_param(std::string_view name, std::string_view value) {
  // Each change is stored for scenarios that are loaded later, so it has a price.
  constexpr std::int64_t kPriceOfAChange = 1000;
  Sandbox::of(lua_).charge(kPriceOfAChange + static_cast<std::int64_t>(name.size() + value.size()));
  const ParameterChange change{std::string(name), std::string(value), ParameterOrigin::live, ""};
  if (replay_) {
    added_.parameter_changes.push_back(change);
    return;
  }
  changes_.push_back(change);
  if (scenario_) {
    if (const std::optional<ParameterOutcome> outcome = scenario_->change(change); outcome && !outcome->refusal.empty())
      throw std::runtime_error(outcome->refusal);
  }
  const bool is_known =
      parameters_.find(name) != nullptr || (scenario_ && scenario_->parameters().find(name) != nullptr);
  if (!is_known) early_changes_.emplace(name, failure_here(""));
  parameters_.set_early(change);
}

void TestBench::hear(std::int64_t sender, std::string_view text) {
  std::vector<Message>& messages = replay_ ? added_.external.messages : messages_;
  if (messages.size() >= kMostMessages)
    throw std::runtime_error("hear: expected at most " + std::to_string(kMostMessages) + " messages in a frame");
  messages.push_back(message_of(sender, text));
}

/// Expectations apply to the frames that follow; expectations of transitions apply to all frames.
void TestBench::begin_advance() {
  started_.clear();
  std::vector<SeenTransition> before = std::move(seen_.transitions);
  seen_ = {};
  seen_.transitions = std::move(before);
}

/// Runs the frames of this time, at least one.
int TestBench::advance(lua_State* L) {
  const double seconds = lua::Value<double>::read(L, 1);
  if (!(seconds >= 0.0 && seconds <= kLongestAdvance))
    throw std::runtime_error("advance: expected seconds from 0 to 3600");
  if (replay_) {
    advance_to(world().time + std::max(seconds, world().time_step));
    return 0;
  }
  begin_advance();
  const long frames = std::max(1L, std::lround(seconds * kFramesPerSecond));
  for (long i = 0; i < frames; ++i) {
    require_budget(L);
    step();
    budget_.spend(1.0 / kFramesPerSecond);
  }
  read_machines();
  faults_.insert(faults_.end(), seen_.faults.begin(), seen_.faults.end());
  return 0;
}

/// Runs one frame of the behaviors as the engine does, but with a fake world, then the scenario.
void TestBench::step() {
  Behaviors& scripts = behaviors();
  const World& world = fake_world_.begin_frame(static_cast<double>(frame_) / kFramesPerSecond, arbiter_.last(),
                                               {.is_pose_set = std::exchange(is_pose_set_, false)});
  ++frame_;
  set_application(world.time);
  scripts.tick(world, messages_, &arbiter_);
  messages_.clear();
  application_.start(scripts.wanted().actions, world.time);
  started_.insert(started_.end(), application_.started().begin(), application_.started().end());
  arbiter_.set_parameters(arbiter_parameters_);
  const Arbitration& arbitration = arbiter_.arbitrate(scripts.wanted().commands, scripts.leases(), world);
  request_ = permitted(scripts.wanted().request, world);
  fake_world_.end_frame(arbitration, request_);
  const NameTable& names = *scripts.host().names().table();
  const ScriptOutput& output = scripts.said();
  seen_.note(names, output.transitions, output.logs, output.faults);
  seen_.note_messages(scripts.wanted().messages);
  seen_.note_commands(arbitration.commands, arbitration.begun);
  trace_.note(scripts.host().definitions(), names, output.transitions);
  leases_.assign(scripts.leases().begin(), scripts.leases().end());
  if (scenario_) {
    scripts.host().read_status(statuses_);
    scripts.host().read_published(published_);
    recorded_.show(names, statuses_, published_, world.time);
    application_record_.take(application_);
    const ScenarioRecord& record = scenario_->tick({world, application_record_, truth_, ball_});
    seen_.note_scenario(record);
    trace_.note(scenario_->machines(), *record.names, record.transitions);
  }
}

void TestBench::read_machines() {
  seen_.machines.clear();
  if (replay_) {
    seen_.machines = replayed_machines_;
    return;
  }
  behaviors().host().read_status(statuses_);
  seen_.note_machines(*behaviors().host().names().table(), statuses_);
  if (!scenario_) return;
  std::vector<MachineStatus> statuses;
  scenario_->host().read_status(statuses);
  seen_.note_machines(*scenario_->host().names().table(), statuses);
}

std::string TestBench::file_of(const std::string& script) const {
  for (const char* folder : {"behaviors/", "scenarios/", ""}) {
    std::string file = folder + script + (script.ends_with(".lua") ? "" : ".lua");
    if (texts_.find(file) != nullptr) return file;
  }
  throw std::runtime_error("reload: unknown script '" + script + "'");
}

/// reload { from = "text", to = "text", file = "lib/walk.lua" }. Without `file` it edits the script that was loaded
/// last.
int TestBench::reload(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const std::vector<std::string> known{"from", "to", "file"};
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw std::runtime_error("reload: unknown key '" + name + "'" + did_you_mean(name, known));
    if (lua_type(L, -1) != LUA_TSTRING) throw std::runtime_error("reload: " + name + ": expected a string");
  }
  const std::string from = text_field(L, 1, "from");
  const std::string to = text_field(L, 1, "to");
  const std::string named = text_field(L, 1, "file");
  const std::string file = file_of(named.empty() ? last_script_ : named);
  const std::string& text = texts_.find(file)->text;
  if (from.empty() || text.find(from) == std::string::npos)
    throw std::runtime_error("reload: " + file + " does not contain \"" + from + "\"");
  const ScriptEdit edit{file, ScriptText{replace_all(text, from, to), ""}};
  texts_.apply(edit);
  refused_.reset();
  if (replay_) {
    added_.script_edits.push_back(edit);
    return 0;
  }
  std::vector<ReloadRecord> reloads = behaviors().apply({&edit, 1}, arbiter_, application_);
  if (scenario_) scenario_->apply({&edit, 1});
  for (ReloadRecord& reload : reloads) {
    if (!reload.accepted) refused_ = std::move(reload.fault);
  }
  read_machines();
  return 0;
}

/// simulate { scenario = "mirrored_placement", seed = 1, params = { ["decision.false_flips"] = 1 } } runs the whole
/// scenario.
int TestBench::simulate(lua_State* L) {
  SimulationRequest request = read_simulation_request(L, 1);
  if (!simulate_) {
    needs_simulator_ = true;
    throw std::runtime_error("simulate: missing simulator (run reorient test --simulator)");
  }
  request.seconds = std::min(request.seconds, budget_.robot_seconds_left());
  SimulationOutcome outcome = simulate_(request, trace_, [this] { return budget_.exceeded(); });
  budget_.spend(outcome.seconds);
  require_budget(L);
  seen_ = std::move(outcome.seen);
  faults_.insert(faults_.end(), seen_.faults.begin(), seen_.faults.end());
  lua_pushboolean(L, outcome.is_correct ? 1 : 0);
  return 1;
}

/// As in behaviors: the values, separated by spaces.
int TestBench::print(lua_State* L) {
  if (printed_.size() >= kMostPrinted)
    throw std::runtime_error("print: expected at most " + std::to_string(kMostPrinted) + " lines in a test");
  std::string line;
  const int count = lua_gettop(L);
  for (int i = 1; i <= count; ++i) {
    push_text(L, i);
    line.append(i > 1 ? " " : "").append(lua_tostring(L, -1), lua_rawlen(L, -1));
    lua_pop(L, 1);
  }
  constexpr std::int64_t kPriceOfALine = 100;
  Sandbox::of(L).charge(kPriceOfALine + static_cast<std::int64_t>(line.size()));
  printed_.push_back(shortened(std::move(line)));
  return 0;
}

}  // namespace reorient
