// SPDX-License-Identifier: MIT
// What a scenario's script may request of the operator.
#include <string>

#include <gtest/gtest.h>

#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

/// The error of a scenario that makes this call; empty if the operator carries it out.
std::string fault_of(const std::string& call) {
  ScriptTexts texts;
  const std::string script =
      "scenario \"one\" { initial = \"a\", state \"a\" { enter = function() " + call + " end } }";
  texts.apply({"scenarios/one.lua", ScriptText{script, ""}});
  RecordedBehaviors behaviors;
  ScenarioHost host(texts, "scenarios/one.lua", {}, behaviors);
  const World world;
  const ScenarioRecord& record = host.tick({world, std::nullopt});
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

}  // namespace
}  // namespace reorient
