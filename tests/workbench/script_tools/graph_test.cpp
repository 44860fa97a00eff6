// State machines as text for Mermaid and Graphviz.
#include <gtest/gtest.h>

#include "tests/engine/script/script_fixture.h"
#include "workbench/script_tools/graph/machine_graph.h"

namespace reorient {
namespace {

class GraphTest : public ScriptTest {
 protected:
  const MachineDefinition& machine() {
    load("drawn", R"(param { wait = { 1, range = { 0, 2 }, doc = "x" } }
behavior "drawn" {
  initial = "at rest",
  common = { { "down", when = function() return robot.posture == "lying" end, lasting = 0.2, because = "the robot \"fell\": down" } },
  state "at rest" { { "moving", when = function() return true end, lasting = "wait", because = "time to go" } },
  state "moving" {
    initial = "slow",
    state "slow" { { "fast", after = 1 } },
    state "fast" { { "at rest", after = "wait", because = "tired" } },
  },
  state "down" { { "at rest", after = 2 } },
})");
    return *host().definitions().front();
  }
};

TEST_F(GraphTest, IsAMermaidStateDiagram) {
  EXPECT_EQ(to_mermaid(machine()), R"(stateDiagram-v2
  [*] --> at_rest
  state "at rest" as at_rest
  state "moving" as moving
  state moving {
    [*] --> moving_slow
    state "slow" as moving_slow
    state "fast" as moving_fast
  }
  state "down" as down
  state "any state" as any_state
  any_state --> down : the robot 'fell'#58; down [for 0.2 s]
  at_rest --> moving : time to go [for wait]
  moving_slow --> moving_fast : after 1 s
  moving_fast --> at_rest : tired [after wait]
  down --> at_rest : after 2 s
)");
}

TEST_F(GraphTest, IsAGraphvizDigraphWithClusters) {
  EXPECT_EQ(to_dot(machine()), R"(digraph "drawn" {
  compound=true;
  node [shape=box, style=rounded];
  start [shape=point];
  any_state [label="any state", style="rounded,dashed"];
  at_rest [label="at rest"];
  subgraph cluster_moving {
    label="moving";
    moving_slow [label="slow"];
    moving_fast [label="fast"];
  }
  down [label="down"];
  start -> at_rest;
  any_state -> down [label="the robot \"fell\": down [for 0.2 s]", style=dashed];
  at_rest -> moving_slow [label="time to go [for wait]", lhead=cluster_moving];
  moving_slow -> moving_fast [label="after 1 s"];
  moving_fast -> at_rest [label="tired [after wait]"];
  down -> at_rest [label="after 2 s"];
}
)");
}

TEST_F(GraphTest, KeepsStatesApartWhoseNamesDifferInASignOnly) {
  load("alike", R"(behavior "alike" { initial = "a b",
  state "a b" { { "a_b", after = 1 } }, state "a_b" { { "a b", after = 1 } } })");
  const std::string text = to_mermaid(*host().definitions().front());
  EXPECT_NE(text.find("state \"a b\" as a_b\n"), std::string::npos) << text;
  EXPECT_NE(text.find("state \"a_b\" as a_b_2\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace reorient
