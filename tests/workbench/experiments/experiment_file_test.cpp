// Experiments as files: what is read, what is refused and how.
#include "workbench/experiments/condition/experiment_file.h"

#include <string>

#include <gtest/gtest.h>

namespace reorient {
namespace {

constexpr const char* kTwoAxes = R"(title = "Which way is it?"
description = "A robot is put down the wrong way round."
trials = 7
[condition]
scenario = "turned_round"
measured_from = "turned round"
limit = 60
with = ["ball_search"]
parameters.orientation.lead = 0.4
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
parameters.orientation.lead = 0.3
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
  EXPECT_EQ(paper.scenario, "turned_round");
  EXPECT_EQ(paper.measurement.from, "turned round");
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

TEST(ExperimentFile, SaysWhereAParameterIsSetAndTheLastOneCounts) {
  const std::vector<Cell> cells = cells_of(parsed(kTwoAxes));
  const std::vector<ParameterChange>& changes = cells[1].condition.parameters;
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].name, "orientation.lead");
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

struct Mistake {
  const char* name;
  std::string text;
  const char* told;
};
class MistakenExperiment : public ::testing::TestWithParam<Mistake> {};

TEST_P(MistakenExperiment, IsRefusedInOneLineThatSaysWhere) {
  const std::string told = refusal(GetParam().text);
  EXPECT_NE(told.find(GetParam().told), std::string::npos) << told;
  EXPECT_TRUE(told.starts_with("some/where.toml:")) << told;
  EXPECT_EQ(told.find('\n'), std::string::npos) << told;
}

const std::string kBegin = "title = \"x\"\n[condition]\nscenario = \"a\"\n";

INSTANTIATE_TEST_SUITE_P(
    All, MistakenExperiment,
    ::testing::Values(
        Mistake{"Key", kBegin + "widht = 160", ":4: there is no key 'widht' here (did you mean 'width'?)"},
        Mistake{"TopKey", "titel = \"x\"", ":1: there is no key 'titel' here (did you mean 'title'?)"},
        Mistake{"NoTitle", "trials = 3\n[condition]\nscenario = \"a\"", "title is missing"},
        Mistake{"NoScenario", "title = \"x\"", "no scenario is named"},
        Mistake{"Trials", "title = \"x\"\ntrials = 0", ":2: trials is a whole number from 1 to 100000"},
        Mistake{"Text", "title = 3", ":1: title is a text in quotes"},
        Mistake{"Width", kBegin + "width = 200", ":4: width is 160, 320 or 640 pixels"},
        Mistake{"Cameras", kBegin + "cameras = \"lower\"", ":4: cameras is"},
        Mistake{"Seconds", kBegin + "seconds = nan", ":4: seconds is a number from 1 to 86400"},
        Mistake{"SecondsText", kBegin + "seconds = \"10\"", ":4: seconds is a number"},
        Mistake{"Seed", kBegin + "hall_seed = -1", ":4: hall_seed is a whole number from 0"},
        Mistake{"List", kBegin + "with = \"a\"", ":4: with is a list of texts"},
        Mistake{"ListOfNumbers", kBegin + "with = [1]", ":4: with is a text in quotes"},
        Mistake{"Flag", kBegin + "room_awareness = 1", ":4: room_awareness is true or false"},
        Mistake{"Parameter", kBegin + "parameters.lead = 1", ":4: a parameter stands in the table of its module"},
        Mistake{"ParameterValue", kBegin + "parameters.a.b = [1]", ":4: a.b is a number, true, false or a name"},
        Mistake{"NameInTheBase", kBegin + "name = \"a\"", ":4: there is no key 'name' here"},
        Mistake{"AxisIsNoTable", "title = \"x\"\naxis = 3", ":2: axis is one table or several"},
        Mistake{"AxisWithoutName", kBegin + "[[axis]]\n[[axis.choice]]\nname = \"a\"", "an axis needs a name"},
        Mistake{"AxisWithoutChoices", kBegin + "[[axis]]\nname = \"a\"", "the axis a has no choices"},
        Mistake{"TwoAxes",
                kBegin +
                    "[[axis]]\nname = \"a\"\n[[axis.choice]]\nname = \"b\"\n[[axis]]\nname = \"a\"\n[[axis.choice]]\n"
                    "name = \"b\"",
                "there are two axes 'a'"},
        Mistake{"ChoiceWithoutName", kBegin + "[[axis]]\nname = \"a\"\n[[axis.choice]]\nwidth = 160",
                "a choice needs a name"},
        Mistake{"TwoChoices",
                kBegin + "[[axis]]\nname = \"a\"\n[[axis.choice]]\nname = \"b\"\n[[axis.choice]]\nname = \"b\"",
                "there are two choices 'b'"},
        Mistake{"NoToml", "title = ", ":1: "},
        Mistake{"EscapeSequence", "title = \"x\"\n\"\\u001b[2J\" = 1", ":2: there is no key '"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(ExperimentFile, ThatIsNotThereIsNamed) {
  try {
    read_experiment("/no/such/file.toml");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/file.toml: there is no such experiment"), std::string::npos);
  }
}

}  // namespace
}  // namespace reorient
