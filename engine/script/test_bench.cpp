#include "engine/script/test_bench.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "engine/script/language/world_fields.h"
#include "engine/script/sandbox/binding.h"
#include "engine/script/sandbox/safe_library.h"
#include "engine/script/script_error.h"

namespace reorient {
namespace {

constexpr double kFramesPerSecond = 30.0;
constexpr double kLongest = 3600.0;  // s, of one advance()
constexpr double kTolerance = 1e-6;

std::string_view to_string(ExperimenterAction::Kind kind) {
  switch (kind) {
    case ExperimenterAction::Kind::pick_up:
      return "pick_up";
    case ExperimenterAction::Kind::put_down:
      return "put_down";
    case ExperimenterAction::Kind::push_over:
      return "push_over";
    case ExperimenterAction::Kind::penalize:
      return "penalize";
    case ExperimenterAction::Kind::set_exposure:
      return "set_exposure";
    case ExperimenterAction::Kind::start_at:
      return "start_at";
  }
  return "";
}

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

std::string numbers(std::initializer_list<double> values) {
  std::ostringstream out;
  for (const double value : values) out << (out.tellp() > 0 ? ", " : "") << value;
  return out.str();
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string text_field(lua_State* L, int table, const char* name) {
  lua_getfield(L, table, name);
  const std::string text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  return text;
}

}  // namespace

TestBench::TestBench(std::filesystem::path scripts_root) : root_(std::move(scripts_root)) {
  parameters_.bind("arbiter", arbiter_parameters_);
  parameters_.bind("script", limits_);
}

template <auto Method>
void TestBench::add_function(lua_State* L, const char* name) {
  lua_pushlightuserdata(L, this);
  if constexpr (std::is_same_v<decltype(Method), int (TestBench::*)(lua_State*)>) {
    lua_pushcclosure(L, &lua::RawBound<Method>::call, 1);
  } else {
    lua_pushcclosure(L, &lua::Bound<Method>::call, 1);
  }
  lua_setfield(L, -2, name);
}

void TestBench::add_to(lua_State* L) {
  lua_ = L;
  lua_pushglobaltable(L);
  add_function<&TestBench::load>(L, "load");
  add_function<&TestBench::load_scenario>(L, "load_scenario");
  add_function<&TestBench::set>(L, "set");
  add_function<&TestBench::set_param>(L, "set_param");
  add_function<&TestBench::advance>(L, "advance");
  add_function<&TestBench::reload>(L, "reload");
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
  add_function<&TestBench::expect_action>(L, "action");
  add_function<&TestBench::expect_verdict>(L, "verdict");
  add_function<&TestBench::expect_error>(L, "error");
  add_function<&TestBench::expect_refused>(L, "refused");
  add_function<&TestBench::expect_equal>(L, "equal");
  add_function<&TestBench::expect_near>(L, "near");
}

ScriptHost& TestBench::host() {
  if (!host_) {
    host_ = std::make_unique<ScriptHost>(root_, parameters_, limits_);
    arbiter_ = Arbiter(arbiter_parameters_);
  }
  return *host_;
}

void TestBench::fail(const std::string& text) {
  lua_Debug record;
  TestFailure failure{"", 0, text};
  if (lua_getstack(lua_, 1, &record) != 0 && lua_getinfo(lua_, "Sl", &record) != 0) {
    failure.file = record.source[0] == '@' ? record.source + 1 : record.source;
    failure.line = record.currentline;
  }
  failures_.push_back(std::move(failure));
}

void TestBench::fail(const std::string& expected, const std::string& actual) {
  fail("expected " + expected + "\n  actual " + actual);
}

std::vector<TestFailure> TestBench::finish() {
  for (const FaultRecord& record : faults_) {
    failures_.push_back({record.fault.file, record.fault.line, record.fault.message + "\n" + record.fault.traceback});
  }
  if (refused_)
    failures_.push_back({refused_->fault.file, refused_->fault.line, "refused: " + refused_->fault.message});
  return failures_;
}

// ---- what a test does

int TestBench::load(lua_State* L) {
  last_script_ = luaL_checkstring(L, 1);
  host().load_behavior(last_script_);
  return 0;
}

int TestBench::load_scenario(lua_State* L) {
  last_script_ = luaL_checkstring(L, 1);
  host().load_scenario(last_script_);
  return 0;
}

/// set { confidence = { opposite = 0.9 }, robot = { fallen = true } }
int TestBench::set(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING || lua_type(L, -1) != LUA_TTABLE) {
      throw std::runtime_error("set takes tables of world fields: set { robot = { fallen = true } }");
    }
    const std::string table = lua_tostring(L, -2);
    const int fields = lua_gettop(L);
    for (lua_pushnil(L); lua_next(L, fields) != 0; lua_pop(L, 1)) {
      if (lua_type(L, -2) != LUA_TSTRING) throw std::runtime_error("set: a field of " + table + " has a name");
      const bool is_boolean = lua_type(L, -1) == LUA_TBOOLEAN;
      if (!is_boolean && lua_type(L, -1) != LUA_TNUMBER) throw std::runtime_error("set takes numbers, true and false");
      const double value = is_boolean ? lua_toboolean(L, -1) : lua_tonumber(L, -1);
      write_world(world_, table, lua_tostring(L, -2), value, is_boolean);
    }
  }
  return 0;
}

void TestBench::set_param(std::string_view name, std::string_view value) {
  parameters_.set_early(std::string(name), value, ParameterOrigin::live);
}

/// Runs as many frames as fit into the time, one at least.
int TestBench::advance(lua_State* L) {
  const double seconds = lua::Value<double>::read(L, 1);
  if (seconds < 0.0 || seconds > kLongest) throw std::runtime_error("advance takes seconds, from 0 to 3600");
  commands_.clear();
  logs_.clear();
  actions_.clear();
  const long frames = std::max(1L, std::lround(seconds * kFramesPerSecond));
  for (long i = 0; i < frames; ++i) {
    world_.time_step = 1.0 / kFramesPerSecond;
    const ScriptOutput& output = host().tick(world_);
    const Arbitration& arbitration = arbiter_.arbitrate(output.commands, output.leases, world_);
    commands_.insert(commands_.end(), arbitration.records.begin(), arbitration.records.end());
    transitions_.insert(transitions_.end(), output.transitions.begin(), output.transitions.end());
    logs_.insert(logs_.end(), output.logs.begin(), output.logs.end());
    actions_.insert(actions_.end(), output.actions.begin(), output.actions.end());
    faults_.insert(faults_.end(), output.faults.begin(), output.faults.end());
    leases_ = output.leases;
    request_ = output.request;
    verdict_ = output.verdict;
    ++frame_;
    world_.frame = static_cast<std::uint64_t>(frame_);
    world_.time = static_cast<double>(frame_) / kFramesPerSecond;
  }
  return 0;
}

std::string TestBench::file_of(const std::string& script) const {
  for (const char* folder : {"behaviors/", "scenarios/", ""}) {
    const std::string file = folder + script + (script.ends_with(".lua") ? "" : ".lua");
    if (host_ && host_->read_file(file)) return file;
  }
  throw std::runtime_error("there is no script '" + script + "'");
}

/// reload { from = "text", to = "text", file = "lib/walk.lua" }; without a file the script that was loaded last.
int TestBench::reload(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const std::string from = text_field(L, 1, "from");
  const std::string to = text_field(L, 1, "to");
  const std::string named = text_field(L, 1, "file");
  const std::string file = file_of(named.empty() ? last_script_ : named);
  const std::string text = host().read_file(file).value_or("");
  if (from.empty() || text.find(from) == std::string::npos)
    throw std::runtime_error(file + " does not contain " + in_quotes(from));
  host().replace_file(file, replace_all(text, from, to));
  refused_.reset();
  for (ReloadReport& report : host().reload_changed(world_.time)) {
    if (!report.accepted) refused_ = std::move(report);
  }
  return 0;
}

// ---- what it expects

void TestBench::expect_state(std::string_view machine, std::string_view path) {
  for (const MachineStatus& status : host().machines()) {
    if (status.name != machine) continue;
    if (status.state != path)
      fail(std::string(machine) + " in state " + in_quotes(path), "in state " + in_quotes(status.state));
    return;
  }
  fail("no behavior " + in_quotes(machine) + " is loaded");
}

void TestBench::expect_reason(std::string_view machine, std::string_view text) {
  std::string last;
  for (const TransitionRecord& record : transitions_) {
    if (record.machine == machine) last = record.reason;
  }
  if (last != text) fail("the last reason of " + std::string(machine) + " " + in_quotes(text), in_quotes(last));
}

std::string TestBench::commands_seen() const {
  std::string list;
  for (const CommandRecord& record : commands_) {
    list += (list.empty() ? "" : ", ") + std::string(reorient::to_string(record.request.command)) + " (" +
            std::string(reorient::to_string(record.verdict)) + ")";
  }
  return list.empty() ? "no command" : list;
}

void TestBench::expect_command(std::string_view name, std::optional<std::string_view> verdict) {
  for (const CommandRecord& record : commands_) {
    const bool fits = !verdict || reorient::to_string(record.verdict) == *verdict;
    if (fits && reorient::to_string(record.request.command) == name) return;
  }
  fail("command " + std::string(name) + (verdict ? " (" + std::string(*verdict) + ")" : ""), commands_seen());
}

void TestBench::expect_no_command(std::optional<std::string_view> name) {
  const bool seen = std::any_of(commands_.begin(), commands_.end(), [&](const CommandRecord& record) {
    const Command command = record.request.command;
    const bool is_pause = command == Command::pause_training || command == Command::pause_evaluation;
    return name ? reorient::to_string(command) == *name : !is_pause;
  });
  if (seen) fail(name ? "no command " + std::string(*name) : "no reorientation", commands_seen());
}

bool TestBench::has_lease(std::string_view name) const {
  return std::any_of(leases_.begin(), leases_.end(),
                     [&](const Lease& lease) { return reorient::to_string(lease.command) == name; });
}

void TestBench::expect_lease(std::string_view name) {
  if (!has_lease(name)) fail(std::string(name) + " held", "not held");
}

void TestBench::expect_no_lease(std::string_view name) {
  if (has_lease(name)) fail(std::string(name) + " not held", "held");
}

void TestBench::expect_head(double yaw, double pitch) {
  const std::string expected = "head at " + numbers({yaw, pitch});
  if (!request_.head) return fail(expected, "no request for the head");
  const HeadAngles& angles = request_.head->angles;
  const bool same = std::abs(angles.yaw - yaw) < kTolerance && std::abs(angles.pitch - pitch) < kTolerance;
  if (!same) fail(expected, numbers({angles.yaw, angles.pitch}));
}

void TestBench::expect_walk(double forward, double left, double turn) {
  const WalkVelocity& walk = request_.walk;
  const bool same = std::abs(walk.forward - forward) < kTolerance && std::abs(walk.left - left) < kTolerance &&
                    std::abs(walk.turn - turn) < kTolerance;
  if (!same) fail("walk with " + numbers({forward, left, turn}), numbers({walk.forward, walk.left, walk.turn}));
}

void TestBench::expect_get_up(bool wanted) {
  if (request_.get_up != wanted) fail(wanted ? "getting up" : "not getting up", "the contrary");
}

void TestBench::expect_log(std::string_view text) {
  std::string all;
  for (const LogRecord& record : logs_) {
    if (record.text.find(text) != std::string::npos) return;
    all += (all.empty() ? "" : ", ") + in_quotes(record.text);
  }
  fail("a log line with " + in_quotes(text), all.empty() ? "no log line" : all);
}

void TestBench::expect_action(std::string_view name) {
  std::string all;
  for (const ExperimenterAction& action : actions_) {
    if (to_string(action.kind) == name) return;
    all += (all.empty() ? "" : ", ") + std::string(to_string(action.kind));
  }
  fail("action " + std::string(name), all.empty() ? "no action" : all);
}

void TestBench::expect_verdict(bool succeeded, std::string_view text) {
  const std::string expected = std::string(succeeded ? "success" : "failure") + " with " + in_quotes(text);
  if (!verdict_) return fail(expected, "no verdict yet");
  if (verdict_->succeeded == succeeded && verdict_->text.find(text) != std::string::npos) return;
  fail(expected, std::string(verdict_->succeeded ? "success" : "failure") + " with " + in_quotes(verdict_->text));
}

void TestBench::expect_error(std::string_view text) {
  const auto found = std::find_if(faults_.begin(), faults_.end(), [&](const FaultRecord& record) {
    return record.fault.text().find(text) != std::string::npos;
  });
  if (found == faults_.end()) {
    fail("an error with " + in_quotes(text), faults_.empty() ? "no error" : in_quotes(faults_.front().fault.text()));
  }
  faults_.clear();
}

void TestBench::expect_refused(std::string_view text) {
  if (!refused_) return fail("the reload refused with " + in_quotes(text), "it was accepted");
  const std::string seen = refused_->fault.text();
  if (seen.find(text) == std::string::npos) fail("the reload refused with " + in_quotes(text), in_quotes(seen));
  refused_.reset();
}

int TestBench::expect_equal(lua_State* L) {
  luaL_checkany(L, 2);
  if (lua_compare(L, 1, 2, LUA_OPEQ) != 0) return 0;
  push_text(L, 1);
  push_text(L, 2);
  fail(lua_tostring(L, -1), lua_tostring(L, -2));
  return 0;
}

void TestBench::expect_near(double actual, double expected, double tolerance) {
  if (std::abs(actual - expected) > tolerance)
    fail(numbers({expected}) + " within " + numbers({tolerance}), numbers({actual}));
}

}  // namespace reorient
