#include "workbench/script_tools/testing/test_bench.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "engine/script/language/world_fields.h"
#include "engine/script/sandbox/binding.h"
#include "engine/script/sandbox/safe_library.h"
#include "engine/script/script_error.h"
#include "workbench/script_tools/testing/simulation_request.h"

namespace reorient {
namespace {

constexpr double kFramesPerSecond = 30.0;
constexpr double kLongest = 3600.0;  // s, of one advance()

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

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

TestBench::TestBench(std::filesystem::path scripts_root, const Simulate& simulate, CoverageTrace& trace)
    : root_(std::move(scripts_root)), simulate_(simulate), trace_(trace) {
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
  add_function<&TestBench::load_behavior>(L, "load_behavior");
  add_function<&TestBench::load_scenario>(L, "load_scenario");
  add_function<&TestBench::set_world>(L, "set_world");
  add_function<&TestBench::set_param>(L, "set_param");
  add_function<&TestBench::advance>(L, "advance");
  add_function<&TestBench::reload>(L, "reload");
  add_function<&TestBench::simulate>(L, "simulate");
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

std::vector<MachineStatus> TestBench::machines() { return simulated_ ? *simulated_ : host().machines(); }

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

int TestBench::load_behavior(lua_State* L) {
  last_script_ = luaL_checkstring(L, 1);
  host().load_behavior(last_script_);
  return 0;
}

int TestBench::load_scenario(lua_State* L) {
  last_script_ = luaL_checkstring(L, 1);
  host().load_scenario(last_script_);
  return 0;
}

/// set_world { confidence = { opposite = 0.9 }, robot = { fallen = true } }
int TestBench::set_world(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING || lua_type(L, -1) != LUA_TTABLE) {
      throw std::runtime_error("set_world takes tables of world fields: set_world { robot = { fallen = true } }");
    }
    const std::string table = lua_tostring(L, -2);
    const int fields = lua_gettop(L);
    for (lua_pushnil(L); lua_next(L, fields) != 0; lua_pop(L, 1)) {
      if (lua_type(L, -2) != LUA_TSTRING) throw std::runtime_error("set_world: a field of " + table + " has a name");
      const bool is_boolean = lua_type(L, -1) == LUA_TBOOLEAN;
      if (!is_boolean && lua_type(L, -1) != LUA_TNUMBER)
        throw std::runtime_error("set_world takes numbers, true and false");
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
    trace_.note(host(), output);
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

/// simulate { scenario = "turned_round", seed = 1, params = { ["orientation.lead"] = 0.4 } }: from beginning to end.
int TestBench::simulate(lua_State* L) {
  const SimulationRequest request = read_simulation_request(L, 1);
  if (!simulate_) {
    needs_simulator_ = true;
    throw std::runtime_error("there is no simulator here");
  }
  SimulationOutcome outcome = simulate_(request, trace_);
  simulated_ = std::move(outcome.machines);
  commands_ = std::move(outcome.commands);
  transitions_ = std::move(outcome.transitions);
  logs_ = std::move(outcome.logs);
  verdict_ = std::move(outcome.verdict);
  faults_.insert(faults_.end(), outcome.faults.begin(), outcome.faults.end());
  lua_pushboolean(L, outcome.is_correct ? 1 : 0);
  return 1;
}

}  // namespace reorient
