// SPDX-License-Identifier: MIT
// Expectations of tests about the frames of the last advance() or of a simulation.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "workbench/script_tools/testing/test_bench.h"
#include "workbench/script_tools/testing/value_differences.h"

namespace reorient {
namespace {

constexpr double kTolerance = 1e-6;

/// States of `orientation` that have a new name.
constexpr std::pair<std::string_view, std::string_view> kFormerStates[] = {
    {"watching/in doubt", "watching/unconfirmed"}, {"watching/in peace", "watching/confirmed"}};

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

std::string numbers(std::initializer_list<double> values) {
  std::ostringstream out;
  for (const double value : values) out << (out.tellp() > 0 ? ", " : "") << value;
  return out.str();
}

/// The enumeration's value of this name; throws if `name` is unknown.
template <typename... Enums>
void require_name(std::string_view what, std::string_view name) {
  std::vector<std::string> known;
  const auto list = [&](auto first) {
    for (int i = 0; i < enum_count(first); ++i) known.emplace_back(to_string(static_cast<decltype(first)>(i)));
  };
  (list(Enums{}), ...);
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  throw std::runtime_error("unknown " + std::string(what) + " '" + std::string(name) + "'" + did_you_mean(name, known));
}

}  // namespace

/// The path of a state as it is called now; warns of a former name. Throws if the machine is loaded and does not have
/// this state.
std::string TestBench::known_state(std::string_view machine, std::string_view path) {
  std::vector<const MachineDefinition*> all = replay_ ? replay_->machines() : behaviors().host().definitions();
  if (scenario_) {
    for (const MachineDefinition* definition : scenario_->machines()) all.push_back(definition);
  }
  for (const MachineDefinition* definition : all) {
    if (definition->name != machine || definition->find(std::string(path)) >= 0) continue;
    for (const auto& [former, present] : kFormerStates) {
      if (path != former || definition->find(std::string(present)) < 0) continue;
      warnings_.insert(in_quotes(former) + " is a former name: use " + in_quotes(present));
      return std::string(present);
    }
    std::vector<std::string> paths;
    for (const StateDefinition& state : definition->states) paths.push_back(state.path);
    throw std::runtime_error(std::string(machine) + ": unknown state " + in_quotes(path) + did_you_mean(path, paths));
  }
  return std::string(path);
}

void TestBench::expect_state(std::string_view machine, std::string_view path) {
  const std::string known = known_state(machine, path);
  for (const SeenMachine& seen : seen_.machines) {
    if (seen.name != machine) continue;
    if (seen.state != known)
      fail(std::string(machine) + " in state " + in_quotes(known), "in state " + in_quotes(seen.state));
    return;
  }
  fail("behavior " + in_quotes(machine) + " is not loaded");
}

void TestBench::expect_reason(std::string_view machine, std::string_view text) {
  std::string last;
  for (const SeenTransition& transition : seen_.transitions) {
    if (transition.machine == machine) last = transition.reason;
  }
  if (last != text)
    fail("reason " + in_quotes(text) + " of the last transition of " + std::string(machine), in_quotes(last));
}

std::string TestBench::commands_seen() const {
  std::string list;
  for (const SeenCommand& command : seen_.commands)
    list += (list.empty() ? "" : ", ") + command.name + " (" + command.verdict + ")";
  return list.empty() ? "no command" : list;
}

void TestBench::expect_command(std::string_view name, std::optional<std::string_view> verdict) {
  require_name<Reorientation, Pause>("command", name);
  if (verdict) require_name<Verdict>("verdict", *verdict);
  for (const SeenCommand& command : seen_.commands) {
    if (command.name == name && (!verdict || command.verdict == *verdict)) return;
  }
  fail("command " + std::string(name) + (verdict ? " (" + std::string(*verdict) + ")" : ""), commands_seen());
}

void TestBench::expect_no_command(std::optional<std::string_view> name) {
  if (name) require_name<Reorientation, Pause>("command", *name);
  const bool seen = std::any_of(seen_.commands.begin(), seen_.commands.end(), [&](const SeenCommand& command) {
    return name ? command.name == *name : command.is_reorientation;
  });
  if (seen) fail(name ? "no command " + std::string(*name) : "no reorientation", commands_seen());
}

bool TestBench::has_lease(std::string_view name) const {
  return std::any_of(leases_.begin(), leases_.end(),
                     [&](const Lease& lease) { return to_string(lease.pause) == name; });
}

void TestBench::expect_lease(std::string_view name) {
  require_name<Pause>("pause", name);
  if (!has_lease(name)) fail(std::string(name) + " active", "not active");
}

void TestBench::expect_no_lease(std::string_view name) {
  require_name<Pause>("pause", name);
  if (has_lease(name)) fail(std::string(name) + " not active", "active");
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

void TestBench::expect_get_up(bool requested) {
  if (request_.get_up != requested)
    fail(requested ? "a request to get up" : "no request to get up", requested ? "no request" : "a request");
}

void TestBench::expect_text(std::string_view text, const std::vector<std::string>& seen, const std::string& what) {
  std::string all;
  for (const std::string& one : seen) {
    if (one.find(text) != std::string::npos) return;
    all += (all.empty() ? "" : ", ") + in_quotes(one);
  }
  fail("a " + what + " with " + in_quotes(text), all.empty() ? "no " + what : all);
}

void TestBench::expect_log(std::string_view text) { expect_text(text, seen_.logs, "log line"); }

void TestBench::expect_message(std::string_view text) { expect_text(text, seen_.messages, "message"); }

void TestBench::expect_action(std::string_view name) {
  require_name<OperatorAction::Kind>("action", name);
  std::string all;
  for (const std::string& action : seen_.actions) {
    if (action == name) return;
    all += (all.empty() ? "" : ", ") + action;
  }
  fail("action " + std::string(name), all.empty() ? "no action" : all);
}

void TestBench::expect_verdict(bool succeeded, std::string_view text) {
  const std::string expected = std::string(succeeded ? "success" : "failure") + " with " + in_quotes(text);
  const std::optional<ScenarioVerdict>& verdict = seen_.verdict;
  if (!verdict) return fail(expected, "no verdict yet");
  if (verdict->succeeded == succeeded && verdict->text.find(text) != std::string::npos) return;
  fail(expected, std::string(verdict->succeeded ? "success" : "failure") + " with " + in_quotes(verdict->text));
}

void TestBench::expect_error(std::string_view text) {
  const auto found = std::find_if(faults_.begin(), faults_.end(), [&](const ScriptFault& fault) {
    return fault.text().find(text) != std::string::npos;
  });
  if (found == faults_.end()) {
    fail("an error with " + in_quotes(text), faults_.empty() ? "no error" : in_quotes(faults_.front().text()));
  }
  faults_.clear();
}

void TestBench::expect_refused(std::string_view text) {
  if (!refused_) return fail("a rejected reload with " + in_quotes(text), "an accepted reload");
  const std::string seen = refused_->text();
  if (seen.find(text) == std::string::npos) fail("a rejected reload with " + in_quotes(text), in_quotes(seen));
  refused_.reset();
}

/// Tables are equal if all their fields are equal.
int TestBench::expect_equal(lua_State* L) {
  luaL_checkany(L, 2);
  const std::string differences = value_differences(L, 1, 2);
  if (!differences.empty()) fail(differences);
  return 0;
}

void TestBench::expect_near(double actual, double expected, double tolerance) {
  if (std::abs(actual - expected) > tolerance)
    fail(numbers({expected}) + " within " + numbers({tolerance}), numbers({actual}));
}

}  // namespace reorient
