// What tests expect of the frames of the last advance() or of a simulation.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "workbench/script_tools/testing/test_bench.h"
#include "workbench/script_tools/testing/value_differences.h"

namespace reorient {
namespace {

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
    case ExperimenterAction::Kind::set_exposure_compensation:
      return "set_exposure_compensation";
    case ExperimenterAction::Kind::set_initial_pose:
      return "set_initial_pose";
  }
  return "";
}

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

std::string numbers(std::initializer_list<double> values) {
  std::ostringstream out;
  for (const double value : values) out << (out.tellp() > 0 ? ", " : "") << value;
  return out.str();
}

}  // namespace

void TestBench::expect_state(std::string_view machine, std::string_view path) {
  for (const MachineStatus& status : machines()) {
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

/// Tables are the same when all their fields are.
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
