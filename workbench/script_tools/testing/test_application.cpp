// SPDX-License-Identifier: MIT
// The application of a test: the values that it sets, and the actions that behaviors request of it.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/script/language/lua_fields.h"
#include "workbench/script_tools/testing/test_bench.h"

namespace reorient {

void TestBench::load_interface(std::string_view name) {
  require_fake_world("load_interface");
  if (behaviors_) throw std::runtime_error("load_interface: expected a call before load_behavior and load_scenario");
  if (!load_interface_) throw std::runtime_error("load_interface: interfaces are not supported here");
  application_ = ApplicationState(load_interface_(std::string(name)));
}

/// set_input { ball = { x = 1.0, seen = true } }
int TestBench::set_input(lua_State* L) {
  require_fake_world("set_input");
  for (SetValue& value : read_inputs(L, 1, application_.declared())) inputs_.push_back(std::move(value));
  if (inputs_.size() > kMostSetValues)
    throw std::runtime_error("set_input: expected at most " + std::to_string(kMostSetValues) + " values in a frame");
  return 0;
}

/// As the engine does at the beginning of a frame. A value that does not fit its declaration was refused before.
void TestBench::set_application(double time) {
  application_.begin_frame(time);
  std::vector<std::string> mistakes;
  application_.take(inputs_, time, mistakes);
  application_.take(reports_, time);
  inputs_.clear();
  reports_.clear();
}

/// report_action("kick", "failed", "no ball")
void TestBench::report_action(std::string_view name, std::string_view state, std::optional<std::string_view> reason) {
  require_fake_world("report_action");
  reports_.push_back(
      report_of(application_.actions()[action_named(application_.declared(), name)].id, state, reason.value_or("")));
  if (reports_.size() > kMostReports)
    throw std::runtime_error("report_action: expected at most " + std::to_string(kMostReports) + " reports in a frame");
}

namespace {

/// Numbers that were computed agree to 1e-6.
bool agree(const FieldData& started, const FieldData& expected) {
  return started.texts == expected.texts &&
         std::equal(started.numbers.begin(), started.numbers.end(), expected.numbers.begin(), expected.numbers.end(),
                    [](double found, double wanted) { return std::abs(found - wanted) <= 1e-6; });
}

}  // namespace

std::string TestBench::started_text(const StartedAction& started) const {
  return to_text(application_.declared().actions[started.action], started.arguments);
}

/// expect.started("kick"), expect.started("kick", { foot = "left" })
int TestBench::expect_started(lua_State* L) {
  const std::uint16_t action = action_named(application_.declared(), luaL_checkstring(L, 1));
  const DeclaredAction& declared = application_.declared().actions[action];
  std::optional<FieldData> arguments;
  if (!lua_isnoneornil(L, 2)) arguments = read_record(L, 2, declared.arguments, declared.name);
  std::string all;
  for (const StartedAction& started : started_) {
    if (started.action == action && (!arguments || agree(started.arguments, *arguments))) return 0;
    all.append(all.empty() ? "" : ", ").append(started_text(started));
  }
  fail("start of " + (arguments ? started_text({0, action, *arguments}) : declared.name),
       all.empty() ? "no start" : all);
  return 0;
}

void TestBench::expect_not_started(std::string_view name) {
  const std::uint16_t action = action_named(application_.declared(), name);
  for (const StartedAction& started : started_) {
    if (started.action == action) return fail("no start of " + std::string(name), started_text(started));
  }
}

}  // namespace reorient
