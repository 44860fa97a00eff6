// SPDX-License-Identifier: MIT
// Experiments as files: valid and invalid contents.
#include "workbench/experiments/condition/experiment_file.h"

#include <string>

#include <gtest/gtest.h>

namespace reorient {
namespace {

constexpr const char* kTwoAxes = R"(title = "Which way is it?"
description = "A robot is placed on the mirrored pose."
trials = 7
[condition]
scenario = "mirrored_placement"
measured_from = "mirrored"
limit = 60
with = ["ball_search"]
parameters.orientation.lingering = 0.4
[[axis]]
name = "motion"
[[axis.choice]]
name = "head"
parameters.walk.speed = 0.0
[[axis.choice]]
name = "walk"
[[axis]]
name = "mode"
[[axis.choice]]
name = "default"
[[axis.choice]]
name = "paper"
params = ["paper"]
with = ["paper/paper_orientation"]
without = ["orientation"]
parameters.orientation.lingering = 0.3
[[axis.choice]]
name = "none"
room_awareness = false
width = 160
)";

Experiment parsed(const std::string& text) { return parse_experiment(text, "some/where.toml"); }

std::string refusal(const std::string& text) {
  try {
    parsed(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ExperimentFile, IsAConditionVariedAlongAxes) {
  const Experiment experiment = parsed(kTwoAxes);
  EXPECT_EQ(experiment.name, "where");
  EXPECT_EQ(experiment.title, "Which way is it?");
  EXPECT_EQ(experiment.trials, 7);
  const std::vector<Cell> cells = cells_of(experiment);
  ASSERT_EQ(cells.size(), 6U);
  EXPECT_EQ(cells[4].choices, (std::vector<std::string>{"walk", "paper"}));
  const Condition& paper = cells[4].condition;
  EXPECT_EQ(paper.scenario, "mirrored_placement");
  EXPECT_EQ(paper.measurement.from, "mirrored");
  EXPECT_EQ(paper.measurement.limit, 60.0);
  EXPECT_EQ(paper.measurement.hold, 10.0);
  EXPECT_EQ(paper.width, 320);
  EXPECT_EQ(paper.with, (std::vector<std::string>{"ball_search", "paper/paper_orientation"}));
  EXPECT_EQ(paper.without, std::vector<std::string>{"orientation"});
  EXPECT_EQ(paper.parameter_files, std::vector<std::string>{"paper"});
  EXPECT_TRUE(paper.room_awareness);
  EXPECT_FALSE(cells[5].condition.room_awareness);
  EXPECT_EQ(cells[5].condition.width, 160);
}

TEST(ExperimentFile, ReportsWhereAParameterIsSetAndUsesTheLastValue) {
  const std::vector<Cell> cells = cells_of(parsed(kTwoAxes));
  const std::vector<ParameterChange>& changes = cells[1].condition.parameters;
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].name, "orientation.lingering");
  EXPECT_EQ(changes[0].value, "0.4");
  EXPECT_EQ(changes[0].source, "some/where.toml:9");
  EXPECT_EQ(changes[1].name, "walk.speed");
  EXPECT_EQ(changes[1].value, "0");
  EXPECT_EQ(changes[2].value, "0.3");
}

TEST(ExperimentFile, WithoutAxesIsOneCell) {
  const std::vector<Cell> cells = cells_of(parsed("title = \"x\"\n[condition]\nscenario = \"fallen\""));
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_TRUE(cells[0].choices.empty());
}

/// "paper" is the only condition file.
ConditionPatch named_condition(const std::string& name) {
  if (name != "paper") throw std::runtime_error("unknown condition '" + name + "'");
  return parse_condition("params = [\"paper\"]\nwithout = [\"orientation\"]\nlimit = 200", "paper.toml");
}

TEST(ExperimentFile, MayNameConditionsThatSeveralExperimentsShare) {
  const std::string text =
      "title = \"x\"\n[condition]\nscenario = \"a\"\nlimit = 60\n[[axis]]\nname = \"mode\"\n[[axis.choice]]\n"
      "name = \"paper\"\nconditions = [\"paper\"]\nwithout = [\"goal_search\"]\n[[axis.choice]]\nname = \"short\"\n"
      "conditions = [\"paper\"]\nlimit = 5\n";
  const std::vector<Cell> cells = cells_of(parse_experiment(text, "x.toml", named_condition));
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].condition.without, (std::vector<std::string>{"orientation", "goal_search"}));
  EXPECT_EQ(cells[0].condition.measurement.limit, 200.0) << "the conditions of a choice override the base";
  EXPECT_EQ(cells[1].condition.measurement.limit, 5.0) << "and its own values override them";
}

TEST(ExperimentFile, NamesTheConditionThatIsMissing) {
  try {
    parse_experiment("title = \"x\"\n[condition]\nscenario = \"a\"\nconditions = [\"papper\"]", "x.toml",
                     named_condition);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "x.toml:4: unknown condition 'papper'");
  }
}

TEST(ConditionFile, NamesNoOtherConditions) {
  EXPECT_THROW(parse_condition("conditions = [\"paper\"]", "x.toml"), std::runtime_error);
  EXPECT_THROW(parse_condition("limti = 3", "x.toml"), std::runtime_error);
}

std::string with_usual(const std::string& usual) {
  return "title = \"x\"\n[condition]\nscenario = \"a\"\n[[axis]]\nname = \"light\"\nusual = [" + usual +
         "]\n[[axis.choice]]\nname = \"same\"\n[[axis.choice]]\nname = \"hard\"\nlimit = 5\n";
}

TEST(ExperimentFile, UsesTheUsualChoicesOfAnAxis) {
  const std::vector<Cell> cells = cells_of(parsed(with_usual("\"hard\"")));
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].choices, std::vector<std::string>{"hard"});
  EXPECT_EQ(with_usual_choices(parsed(with_usual("\"hard\""))).axes.at(0).choices.size(), 1U)
      << "unused choices are not compared";
  EXPECT_NE(refusal(with_usual("\"hrad\"")).find("unknown choice 'hrad' of the axis"), std::string::npos);
}

TEST(Choices, AreTheRequestedOnesInTheirOrderAndOnce) {
  Experiment experiment = parsed(with_usual("\"hard\""));
  const auto refuse = [](const Axis& axis, const std::string& name) -> AxisChoice {
    throw std::runtime_error(axis.name + " has no " + name);
  };
  choose(experiment, "light", {"hard", "same", "hard"}, refuse);
  const std::vector<Cell> cells = cells_of(experiment);
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].condition.measurement.limit, 5.0);
  EXPECT_EQ(cells[1].choices, std::vector<std::string>{"same"});
  EXPECT_THROW(choose(experiment, "light", {"dark"}, refuse), std::runtime_error);
  EXPECT_THROW(choose(experiment, "lihgt", {"same"}, refuse), std::runtime_error);
}

TEST(Choices, MayBeAddedIfTheAxisDoesNotHaveThem) {
  Experiment experiment = parsed(with_usual("\"hard\""));
  choose(experiment, "light", {"mine"}, [](const Axis&, const std::string& name) {
    AxisChoice choice{name, {}};
    choice.patch.limit = 7.0;
    return choice;
  });
  EXPECT_EQ(cells_of(experiment).at(0).condition.measurement.limit, 7.0);
}

struct Mistake {
  const char* name;
  std::string text;
  const char* error;
};
class MistakenExperiment : public ::testing::TestWithParam<Mistake> {};

TEST_P(MistakenExperiment, IsRefusedInOneLineWithItsPosition) {
  const std::string error = refusal(GetParam().text);
  EXPECT_NE(error.find(GetParam().error), std::string::npos) << error;
  EXPECT_TRUE(error.starts_with("some/where.toml:")) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

const std::string kBegin = "title = \"x\"\n[condition]\nscenario = \"a\"\n";

INSTANTIATE_TEST_SUITE_P(
    All, MistakenExperiment,
    ::testing::Values(
        Mistake{"Key", kBegin + "widht = 160", ":4: unknown key 'widht' (did you mean 'width'?)"},
        Mistake{"TopKey", "titel = \"x\"", ":1: unknown key 'titel' (did you mean 'title'?)"},
        Mistake{"NoTitle", "trials = 3\n[condition]\nscenario = \"a\"", "title: expected one sentence"},
        Mistake{"NoScenario", "title = \"x\"", "scenario: expected one, as in"},
        Mistake{"Trials", "title = \"x\"\ntrials = 0", ":2: trials: expected a whole number from 1 to 100000, found 0"},
        Mistake{"Text", "title = 3", ":1: title: expected a text in quotes, found 3"},
        Mistake{"Width", kBegin + "width = 200", ":4: width: expected 160, 320, 544 or 640 pixels, found 200"},
        Mistake{"Cameras", kBegin + "cameras = \"lower\"",
                ":4: cameras: expected \"upper\" or \"both\", found \"lower\""},
        Mistake{"Interface", kBegin + "interface = true", ":4: interface: expected a text in quotes, found true"},
        Mistake{"Seconds", kBegin + "seconds = nan", ":4: seconds: expected a number from 1 to 86400, found nan"},
        Mistake{"SecondsText", kBegin + "seconds = \"10\"",
                ":4: seconds: expected a number from 1 to 86400, found '10'"},
        Mistake{"Seed", kBegin + "hall_seed = -1", ":4: hall_seed: expected a whole number from 0"},
        Mistake{"List", kBegin + "with = \"a\"",
                ":4: with: expected a list of texts, as [\"one\", \"two\"], found 'a'"},
        Mistake{"ListOfNumbers", kBegin + "with = [1]", ":4: with: expected a text in quotes, found 1"},
        Mistake{"Flag", kBegin + "room_awareness = 1", ":4: room_awareness: expected true or false, found 1"},
        Mistake{"Parameter", kBegin + "parameters.lead = 1", ":4: expected a parameter in the table of its module"},
        Mistake{"ParameterValue", kBegin + "parameters.a.b = [1]",
                ":4: a.b: expected a number, true, false or a name in quotes, found [1]"},
        Mistake{"Times", "title = \"x\"\ntimes = \"soon\"",
                ":2: times: expected \"command\" or \"belief\", found \"soon\""},
        Mistake{"Conditions", kBegin + "conditions = [\"paper\"]", ":4: unknown key 'conditions'"},
        Mistake{"NameInTheBase", kBegin + "name = \"a\"", ":4: unknown key 'name'"},
        Mistake{"AxisIsNoTable", "title = \"x\"\naxis = 3", ":2: axis: expected one or more tables [[axis]], found 3"},
        Mistake{"AxisWithoutName", kBegin + "[[axis]]\n[[axis.choice]]\nname = \"a\"",
                "axis: expected a name, found none"},
        Mistake{"AxisWithoutChoices", kBegin + "[[axis]]\nname = \"a\"",
                "axis a: expected one or more [[axis.choice]], found none"},
        Mistake{"TwoAxes",
                kBegin +
                    "[[axis]]\nname = \"a\"\n[[axis.choice]]\nname = \"b\"\n[[axis]]\nname = \"a\"\n[[axis.choice]]\n"
                    "name = \"b\"",
                "axis: expected different names, found 'a' twice"},
        Mistake{"ChoiceWithoutName", kBegin + "[[axis]]\nname = \"a\"\n[[axis.choice]]\nwidth = 160",
                "axis.choice: expected a name, found none"},
        Mistake{"TwoChoices",
                kBegin + "[[axis]]\nname = \"a\"\n[[axis.choice]]\nname = \"b\"\n[[axis.choice]]\nname = \"b\"",
                "axis.choice: expected different names, found 'b' twice"},
        Mistake{"NoToml", "title = ", ":1: "},
        Mistake{"EscapeSequence", "title = \"x\"\n\"\\u001b[2J\" = 1", ":2: unknown key '"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

constexpr const char* kReference = R"([[reference]]
label = "paper, real robot"
choices.mode = "paper"
choices.motion = "walk"
trials = 10
failed = 0.1
mean_s = 45.4
)";

TEST(ExperimentFile, MayContainPublishedResults) {
  const Experiment experiment = parsed(kTwoAxes + std::string(kReference));
  ASSERT_EQ(experiment.references.size(), 1U);
  const Reference& reference = experiment.references[0];
  EXPECT_EQ(reference.label, "paper, real robot");
  ASSERT_EQ(reference.choices.size(), 2U);
  EXPECT_EQ(reference.choices[0].first, "motion") << "in the order of the axes";
  EXPECT_EQ(reference.trials, 10);
  EXPECT_EQ(reference.failed, 0.1);
  EXPECT_EQ(reference.mean_s, 45.4);
  EXPECT_FALSE(reference.flip);
}

TEST(ExperimentFile, RefusesReferencesToUnknownChoices) {
  const std::string reference = kReference;
  const auto with = [&reference](const std::string& more) { return refusal(kTwoAxes + reference + more); };
  EXPECT_NE(with("choices.mod = \"paper\"\n").find("unknown axis or choice 'mod' = 'paper'"), std::string::npos);
  EXPECT_NE(with("flip = 70\n").find("where.toml:38: flip: expected a number from 0 to 1, found 70"),
            std::string::npos);
  EXPECT_NE(with("flp = 0.7\n").find("did you mean 'flip'?"), std::string::npos);
  EXPECT_NE(with("[[reference]]\ntrials = 3\n").find("reference: expected a label (who measured it), found none"),
            std::string::npos);
}

TEST(ExperimentFile, ThatIsMissingIsNamed) {
  try {
    read_experiment("/no/such/file.toml", {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/file.toml: expected a file (experiment), found none"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace reorient
