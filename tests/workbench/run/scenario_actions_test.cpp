// SPDX-License-Identifier: MIT
// What a scenario's script may request of the operator.
#include <string>

#include <gtest/gtest.h>

#include "tests/declared_field.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

/// The error of a scenario that makes this call; empty if the operator carries it out.
std::string fault_of(const std::string& call, const ApplicationRecord& application = {}) {
  ScriptTexts texts;
  const std::string script =
      "scenario \"one\" { initial = \"a\", state \"a\" { enter = function() " + call + " end } }";
  texts.apply({"scenarios/one.lua", ScriptText{script, ""}});
  RecordedBehaviors behaviors;
  ScenarioHost host(texts, "scenarios/one.lua", {}, behaviors);
  const World world;
  const ScenarioRecord& record = host.tick({world, application, std::nullopt});
  EXPECT_EQ(record.faults.empty(), record.actions.size() == 1) << call;
  return record.faults.empty() ? "" : record.faults.front().fault.message;
}

TEST(ScenarioActions, PlaceTheRobotOnlyOnOrBesideAField) {
  for (const std::string function : {"operator.put_down", "operator.set_initial_pose"}) {
    EXPECT_EQ(fault_of(function + "(-3.2, -3.5, 1.57)"), "");
    EXPECT_EQ(fault_of(function + "(-60, 45, -10 * math.pi)"), "");
    for (const std::string pose : {"(1e308, 0, 0)", "(0, -1e308, 0)", "(0, 0, 1e308)", "(101, 0, 0)"})
      EXPECT_NE(fault_of(function + pose).find(function + ": expected a pose within 100 m"), std::string::npos)
          << fault_of(function + pose);
  }
}

TEST(ScenarioActions, PlayTheApplicationOnlyAsItIsDeclared) {
  ApplicationInterface declared;
  declared.values.push_back({"ball.near", "", {declared_field("", FieldType::boolean, {{0.0}, {}})}});
  declared.actions.push_back({"wave", "", {}, 1.0, true});
  ApplicationState state(declared);
  ApplicationRecord record;
  record.take(state);
  EXPECT_EQ(fault_of("application.set { ball = { near = true } }", record), "");
  EXPECT_NE(fault_of("application.set { ball = { far = true } }", record).find("did you mean"), std::string::npos);
  EXPECT_NE(fault_of("application.set { ball = { near = 1 } }", record).find("expected true or false"),
            std::string::npos);
  EXPECT_NE(fault_of("application.report('wave', 'done')", record).find("an action that was requested"),
            std::string::npos);
  EXPECT_NE(fault_of("application.report('wawe', 'done')", record).find("did you mean 'wave'"), std::string::npos);
  const ActionRequest request{0, {}, {}, 0.0};
  state.start({&request, 1}, 0.0);
  record.take(state);
  EXPECT_EQ(fault_of("application.report('wave', 'failed', 'tired')", record), "");
  EXPECT_NE(fault_of("application.report('wave', 'requested')", record).find("expected a report of running"),
            std::string::npos);
  EXPECT_NE(fault_of("application.argument('wave', 'hand')", record).find("has no argument 'hand'"), std::string::npos);
  EXPECT_NE(fault_of("application.set { ball = { near = true } }").find("input has no value"), std::string::npos)
      << "without an interface";
}

}  // namespace
}  // namespace reorient
