// SPDX-License-Identifier: MIT
// State machines as text for Mermaid and Graphviz.
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/engine/script/script_fixture.h"
#include "workbench/script_tools/graph/machine_graph.h"
#include "workbench/script_tools/graph/machine_json.h"
#include "workbench/script_tools/graph/script_sights.h"

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
  EXPECT_EQ(to_mermaid({&machine(), 1}), R"(stateDiagram-v2
  [*] --> drawn_at_rest
  state "at rest" as drawn_at_rest
  state "moving" as drawn_moving
  state drawn_moving {
    [*] --> drawn_moving_slow
    state "slow" as drawn_moving_slow
    state "fast" as drawn_moving_fast
  }
  state "down" as drawn_down
  state "any state" as drawn_any_state
  drawn_any_state --> drawn_down : the robot #34;fell#34;#58; down [for 0.2 s]
  drawn_at_rest --> drawn_moving : time to go [for wait]
  drawn_moving_slow --> drawn_moving_fast : after 1 s
  drawn_moving_fast --> drawn_at_rest : tired [after wait]
  drawn_down --> drawn_at_rest : after 2 s
)");
}

TEST_F(GraphTest, IsAGraphvizDigraphWithClusters) {
  EXPECT_EQ(to_dot({&machine(), 1}), R"(digraph "drawn" {
  compound=true;
  node [shape=box, style=rounded];
  drawn_start [shape=point];
  drawn_any_state [label="any state", style="rounded,dashed"];
  drawn_at_rest [label="at rest"];
  subgraph cluster_drawn_moving {
    label="moving";
    drawn_moving_slow [label="slow"];
    drawn_moving_fast [label="fast"];
  }
  drawn_down [label="down"];
  drawn_start -> drawn_at_rest;
  drawn_any_state -> drawn_down [label="the robot \"fell\": down [for 0.2 s]", style=dashed];
  drawn_at_rest -> drawn_moving_slow [label="time to go [for wait]", lhead=cluster_drawn_moving];
  drawn_moving_slow -> drawn_moving_fast [label="after 1 s"];
  drawn_moving_fast -> drawn_at_rest [label="tired [after wait]"];
  drawn_down -> drawn_at_rest [label="after 2 s"];
}
)");
}

TEST_F(GraphTest, IsJsonWithIndexesOfStates) {
  const nlohmann::json drawn = nlohmann::json::parse(machine_json(machine(), host().texts()));
  EXPECT_EQ(drawn["name"], "drawn");
  EXPECT_EQ(drawn["file"], "behaviors/drawn.lua");
  std::vector<std::string> paths;
  for (const auto& state : drawn["states"]) paths.push_back(state["path"]);
  EXPECT_EQ(paths, (std::vector<std::string>{"", "at rest", "moving", "moving/slow", "moving/fast", "down"}));
  EXPECT_EQ(drawn["states"][3]["outer"], 2);
  EXPECT_EQ(drawn["states"][2]["initial"], 3);
  EXPECT_EQ(drawn["states"][0]["initial"], 1);
  const auto& fall = drawn["transitions"][0];
  EXPECT_EQ(fall["from"], 0);
  EXPECT_EQ(fall["to"], 5);
  EXPECT_EQ(fall["common"], true);
  EXPECT_EQ(fall["lasting"], "0.2 s");
  EXPECT_EQ(fall["line"], 4);
  EXPECT_EQ(fall["reason"], "the robot \"fell\": down");
  EXPECT_EQ(fall["reads"], nlohmann::json({"robot.posture"}));
  EXPECT_EQ(drawn["transitions"][1]["lasting"], "wait");
  EXPECT_EQ(drawn["transitions"][2]["after"], "1 s");
  EXPECT_EQ(drawn["transitions"][2]["when"], false);
  const nlohmann::json all = nlohmann::json::parse(to_json({&machine(), 1}, {}, host().texts()));
  EXPECT_EQ(all["machines"][0], drawn);
  EXPECT_TRUE(all["links"].empty());
}

TEST_F(GraphTest, IsValidJsonAlsoOfInvalidText) {
  load(
      "odd",
      R"(behavior "odd" { initial = "a", state "a" { { "b", after = 1, because = "\27[2J\xFF</script>" } }, state "b" {} })");
  const nlohmann::json drawn =
      nlohmann::json::parse(machine_json(*host().definitions().front(), host().texts()), nullptr, false);
  EXPECT_EQ(drawn["transitions"][0]["reason"], "\x1B[2J\xEF\xBF\xBD</script>");
}

TEST_F(GraphTest, DistinguishesStatesWhoseNamesDifferInOneCharacter) {
  load("similar", R"(behavior "similar" { initial = "a b",
  state "a b" { { "a_b", after = 1 } }, state "a_b" { { "a b", after = 1 } } })");
  const std::string text = to_mermaid({host().definitions().front(), 1});
  EXPECT_NE(text.find("state \"a b\" as similar_a_b\n"), std::string::npos) << text;
  EXPECT_NE(text.find("state \"a_b\" as similar_a_b_2\n"), std::string::npos) << text;
}

TEST_F(GraphTest, EscapesUnprintableText) {
  load("odd",
       R"(behavior "odd" { initial = "a", state "a" { { "b", after = 1, because = "\27[2J\xFF" } }, state "b" {} })");
  for (const std::string& text :
       {to_mermaid({host().definitions().front(), 1}), to_dot({host().definitions().front(), 1})}) {
    EXPECT_NE(text.find("x1B[2J"), std::string::npos) << text;
    EXPECT_NE(text.find("xFF"), std::string::npos) << text;
    EXPECT_EQ(text.find('\x1B'), std::string::npos) << text;
  }
}

TEST_F(GraphTest, EscapesWhatMermaidAndGraphvizWouldRead) {
  load("keywords", R"(behavior "keywords" { initial = "default",
  state "default" { { "note", after = 1, because = "a; %%{init: 1}%% `b` | <c> & {d} @e" } },
  state "note" { { "end", when = function() return true end, because = " " } },
  state "end" { { "node", after = 1 } }, state "node" {} })");
  const MachineDefinition& drawn = *host().definitions().front();
  EXPECT_EQ(to_mermaid({&drawn, 1}), R"(stateDiagram-v2
  [*] --> keywords_default
  state "default" as keywords_default
  state "note" as keywords_note
  state "end" as keywords_end
  state "node" as keywords_node
  keywords_default --> keywords_note : a#59; #37;#37;#123;init#58; 1#125;#37;#37; #96;b#96; #124; #60;c#62; #38; #123;d#125; #64;e [after 1 s]
  keywords_note --> keywords_end : #32;
  keywords_end --> keywords_node : after 1 s
)");
  EXPECT_NE(to_dot({&drawn, 1}).find("  keywords_node [label=\"node\"];\n"), std::string::npos)
      << "a node of its own, because node sets defaults";
}

/// Mermaid reads a line with these words as a direction of the diagram, also within a label.
TEST_F(GraphTest, KeepsALabelAboutADirection) {
  load("turning", R"(behavior "turning" { initial = "a", state "a" { { "b", after = 1, because = "Direction LR" } },
  state "b" { { "a", after = 1, because = "the direction  TB" } } })");
  const std::string text = to_mermaid({host().definitions().front(), 1});
  EXPECT_NE(text.find("turning_a --> turning_b : Direction#32;LR [after 1 s]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("turning_b --> turning_a : the direction#32; TB [after 1 s]\n"), std::string::npos) << text;
}

class GraphOfSeveral : public ScriptTest {
 protected:
  /// A machine that publishes a flag, and one that reads it: through a local function, a library, and directly.
  void load_two() {
    load("seeker", R"(behavior "seeker" {
  initial = "resting",
  state "resting" { { "searching", after = 1 } },
  state "searching" {
    publishes = "is_searched",
    state "near" { { "far", after = 1 } },
    state "far" {},
    initial = "near",
  },
})");
    folder.write("lib/manners.lua", R"(local manners = {}
local function is_far() return behaviors.seeker.state == "searching/far" end
function manners.is_polite() return not is_far() end
function manners.is_rude() return published.nothing end
return manners)");
    load("walker", R"(local manners = require "lib.manners"
local function must_wait() return published["is_searched"] end
behavior "walker" {
  initial = "walking",
  common = { { "down", when = function() return robot.posture == "lying" end, because = "fell" } },
  state "walking" { { "waiting", when = must_wait, because = "<search> \"now\"" } },
  state "waiting" {
    { "walking", when = function() return manners.is_polite() and behaviors.seeker.time_in_state > 2 end },
  },
  state "down" { { "walking", when = function() return "resting" ~= behaviors.seeker.state end } },
})");
  }
  std::vector<MachineDefinition> machines() {
    std::vector<MachineDefinition> all;
    for (const MachineDefinition* machine : host().definitions()) all.push_back(*machine);
    return all;
  }
  std::vector<MachineLink> links() { return machine_links(machines(), host().texts()); }
};

TEST_F(GraphOfSeveral, FindsWhereAMachineReadsTheStateOfAnotherMachine) {
  load_two();
  const std::map<int, std::set<Sight>> seen = sights_of(machines()[1], host().texts());
  const std::set<Sight> walking{{"", "is_searched", ""}};
  const std::set<Sight> waiting{{"seeker", "state", "searching/far"}, {"seeker", "time_in_state", ""}};
  const std::set<Sight> down{{"seeker", "state", "resting"}};
  EXPECT_EQ(seen, (std::map<int, std::set<Sight>>{{1, walking}, {2, waiting}, {3, down}}));
}

TEST_F(GraphOfSeveral, IgnoresFieldsStringsAndCommentsWithTheSameNames) {
  load("unrelated", R"(local t = { published = { is_searched = true }, behaviors = 1 }
-- published.is_searched
behavior "unrelated" {
  initial = "a",
  state "a" { { "b", when = function() return t.published.is_searched and "published.x" == "" end } },
  state "b" { { "a", when = function() return published[t.behaviors] end } },
})");
  EXPECT_TRUE(sights_of(machines().front(), host().texts()).empty());
}

TEST_F(GraphOfSeveral, ReportsALinkOnceForAStateInALocalVariable) {
  load("held", R"(local held = state "held" { { "other", when = function() return published.flag end } }
behavior "held" { initial = "held", held, state "other" { { "held", after = 1 } } })");
  const std::map<int, std::set<Sight>> seen = sights_of(machines().front(), host().texts());
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen.begin()->first, 1);
}

TEST_F(GraphOfSeveral, FindsFunctionsThatCallEachOther) {
  load("round", R"(local even
local function odd(n) return n > 0 and even(n - 1) or published.flag end
even = function(n) return n == 0 or odd(n - 1) end
behavior "round" { state "a" { { "a", when = function() return even(3) end } } })");
  EXPECT_EQ(sights_of(machines().front(), host().texts()), (std::map<int, std::set<Sight>>{{1, {{"", "flag", ""}}}}));
}

TEST_F(GraphOfSeveral, IsAMermaidFlowchartWithDashedLinks) {
  load_two();
  EXPECT_EQ(to_mermaid(machines(), links()), R"(flowchart TB
  subgraph seeker_machine["seeker"]
    seeker_start((" ")) --> seeker_resting
    seeker_resting("resting")
    subgraph seeker_searching["searching"]
      seeker_searching_start((" ")) --> seeker_searching_near
      seeker_searching_near("near")
      seeker_searching_far("far")
    end
    seeker_resting -->|"after 1 s"| seeker_searching
    seeker_searching_near -->|"after 1 s"| seeker_searching_far
  end
  subgraph walker_machine["walker"]
    walker_any_state(["any state"])
    walker_start((" ")) --> walker_walking
    walker_walking("walking")
    walker_waiting("waiting")
    walker_down("down")
    walker_any_state -->|"fell"| walker_down
    walker_walking -->|"#60;search#62; #34;now#34;"| walker_waiting
    walker_waiting -->|"its condition held"| walker_walking
    walker_down -->|"its condition held"| walker_walking
  end
  seeker_searching -.->|"is_searched"| walker_walking
  seeker_searching_far -.->|"state"| walker_waiting
  seeker_machine -.->|"time_in_state"| walker_waiting
  seeker_resting -.->|"state"| walker_down
)");
}

TEST_F(GraphOfSeveral, IsAGraphvizDigraphWithDashedLinks) {
  load_two();
  const std::string text = to_dot(machines(), links());
  EXPECT_TRUE(text.starts_with("digraph machines {\n  compound=true;\n")) << text;
  EXPECT_NE(text.find("  subgraph cluster_seeker_machine {\n    label=\"seeker\";\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  seeker_searching_near -> walker_walking [label=\"is_searched\", style=dashed, "
                      "constraint=false, ltail=cluster_seeker_searching];\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("  seeker_resting -> walker_waiting [label=\"time_in_state\", style=dashed, constraint=false, "
                      "ltail=cluster_seeker_machine];\n"),
            std::string::npos)
      << text;
}

TEST_F(GraphOfSeveral, DistinguishesMachinesAndStatesWhoseJoinedNamesAreEqual) {
  load(
      "a",
      R"(behavior "a" { initial = "b c", state "b c" { { "b_c", after = 1 } }, state "b_c" { { "b c", after = 1 } } })");
  load("a_b", R"(behavior "a_b" { state "c" {} })");
  load("bare", R"(behavior "bare" {})");
  const std::string text = to_mermaid(machines(), links());
  for (const char* line : {"    a_b_c(\"b c\")\n", "    a_b_c_2(\"b_c\")\n", "    a_b_c_3(\"c\")\n",
                           "  subgraph bare_machine[\"bare\"]\n  end\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

}  // namespace
}  // namespace reorient
