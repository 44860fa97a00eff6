// SPDX-License-Identifier: MIT
// What an experiment counts and averages in each trial, and over trials.
#include "workbench/experiments/trial/measure.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/world/names.h"
#include "workbench/experiments/condition/experiment_file.h"
#include "workbench/experiments/condition/resolved_text.h"
#include "workbench/experiments/tables/measure_row.h"

namespace reorient {
namespace {

constexpr const char* kMeasured = R"(title = "What does the head do?"
[condition]
scenario = "mirrored_placement"
[measure]
mean = ["robot.head_yaw", "robot.may_walk"]
entered = ["orientation/correcting", "orientation/correcting"]
transitions = ["orientation/watching > correcting"]
granted = ["flip_pose"]
refused = ["flip_pose", "action.kick"]
logged = ["gave up"]
at_end = ["confidence.current"]
)";

Experiment measured(const std::string& text) { return parse_experiment(text, "some/where.toml"); }

std::string refusal_of(const std::string& measure) {
  try {
    measured("title = \"t\"\n[condition]\nscenario = \"s\"\n[measure]\n" + measure + "\n");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Measures, AreReadByTypeAndEachOnce) {
  const Experiment experiment = measured(kMeasured);
  std::vector<std::string> labels;
  for (const Measure& measure : experiment.measures) labels.push_back(measure.label());
  EXPECT_EQ(labels,
            (std::vector<std::string>{"entered orientation/correcting", "transitions orientation/watching > correcting",
                                      "granted flip_pose", "refused flip_pose", "refused action.kick", "logged gave up",
                                      "mean robot.head_yaw", "mean robot.may_walk", "at_end confidence.current"}));
  EXPECT_EQ(cells_of(experiment).at(0).condition.measures.size(), 9u);
  EXPECT_EQ(unit_of(experiment.measures[6]), "rad");
}

TEST(Measures, WithUnknownNamesAreRefusedWithTheNearestName) {
  EXPECT_EQ(refusal_of("mean = [\"robot.head_yam\"]"),
            "some/where.toml:5: measure.mean: unknown number or boolean of the world 'robot.head_yam' (did you mean "
            "'robot.head_yaw'?) (docs/script-reference.md lists them)");
  EXPECT_NE(refusal_of("mean = [\"robot.posture\"]").find("unknown number or boolean of the world 'robot.posture'"),
            std::string::npos);
  EXPECT_NE(refusal_of("granted = [\"flip_pos\"]").find("unknown command 'flip_pos' (did you mean 'flip_pose'?)"),
            std::string::npos);
  EXPECT_NE(refusal_of("entered = [\"orientation\"]").find("expected MACHINE/STATE"), std::string::npos);
  EXPECT_NE(refusal_of("entered = [\"/flipping\"]").find("expected MACHINE/STATE"), std::string::npos);
  EXPECT_NE(refusal_of("transitions = [\"orientation/watching\"]").find("expected MACHINE/STATE > STATE"),
            std::string::npos);
  EXPECT_NE(refusal_of("transitions = [\"orientation/watching > \"]").find("expected MACHINE/STATE > STATE"),
            std::string::npos);
  EXPECT_NE(refusal_of("means = [\"robot.head_yaw\"]").find("means"), std::string::npos);
  EXPECT_NE(refusal_of("mean = \"robot.head_yaw\"").find("mean"), std::string::npos);
  std::string many;
  for (int i = 0; i < 70; ++i) many += "\"text " + std::to_string(i) + "\", ";
  EXPECT_NE(refusal_of("logged = [" + many + "]").find("expected at most 64 names, found 70"), std::string::npos);
}

TEST(Measures, OfUnknownStatesNameTheNearestOne) {
  const std::set<std::string> known{"orientation/watching", "orientation/watching/unconfirmed",
                                    "orientation/correcting"};
  const auto mistake = [&](MeasureType type, const std::string& name) {
    return mistake_in_states({type, name, ""}, known);
  };
  EXPECT_EQ(mistake(MeasureType::entered, "orientation/watching"), "");
  EXPECT_EQ(mistake(MeasureType::entered, "orientation/correctin"),
            "unknown state 'orientation/correctin' (did you mean 'orientation/correcting'?)");
  EXPECT_EQ(mistake(MeasureType::transition, "orientation/watching > correcting"), "");
  EXPECT_NE(mistake(MeasureType::transition, "orientation/watching > correctin"), "");
  EXPECT_EQ(mistake(MeasureType::mean, "robot.head_yaw"), "");
}

/// A trial whose clock starts with the first frame.
class MeasuredTrial : public testing::Test {
 protected:
  void show(const std::string& from = "", const std::string& to = "") {
    Names names;
    frame_.world.time = time_ += 0.1;
    frame_.transitions.clear();
    if (!to.empty()) {
      TransitionRecord& one = frame_.transitions.emplace_back();
      one.machine = names.intern("m");
      one.from = names.intern(from);
      one.to = names.intern(to);
    }
    frame_.names = names.table();
    trial_.observe(frame_, scene_);
    measures_->observe(frame_, scene_);
    frame_.commands.clear();
    frame_.logs.clear();
  }
  void measure(const std::vector<std::pair<MeasureType, std::string>>& names) {
    std::vector<Measure> measures;
    measures.reserve(names.size());
    for (const auto& [type, name] : names) measures.push_back({type, name, ""});
    measures_.emplace(measures, trial_);
  }
  double value(std::size_t i) const { return measures_->values().at(i).value(); }

  FrameRecord frame_;
  SceneTruth scene_;
  TrialObserver trial_{Measurement{}};
  std::optional<MeasureObserver> measures_;
  double time_ = 10.0;
};

TEST_F(MeasuredTrial, CountsEntriesFromOutsideAndTransitions) {
  measure({{MeasureType::entered, "m/a"},
           {MeasureType::entered, "m/b"},
           {MeasureType::transition, "m/a > b"},
           {MeasureType::entered, "other/a"}});
  show("", "a/x");     // from the start
  show("a/x", "a/y");  // within a
  show("a/y", "b");    // a > b
  show("b", "b");      // again from itself
  show("b", "abc");    // another state
  show("abc", "a");    // again
  EXPECT_EQ(value(0), 2.0);
  EXPECT_EQ(value(1), 2.0);
  EXPECT_EQ(value(2), 1.0);
  EXPECT_EQ(value(3), 0.0);
}

TEST_F(MeasuredTrial, CountsCommandsByTheirVerdictAndLines) {
  measure({{MeasureType::granted, "flip_pose"}, {MeasureType::refused, "flip_pose"}, {MeasureType::logged, "gave up"}});
  for (const Verdict verdict : {Verdict::granted, Verdict::too_soon, Verdict::not_allowed}) {
    CommandRecord command;
    command.verdict = verdict;
    frame_.commands = {command};
    frame_.logs = {{0, 0, "it gave up here", 0, false}, {0, 0, "other", 0, false}};
    show();
  }
  EXPECT_EQ(value(0), 1.0);
  EXPECT_EQ(value(1), 2.0);
  EXPECT_EQ(value(2), 3.0);
}

TEST_F(MeasuredTrial, HasMeanLeastMostAndLastOfAValue) {
  measure({{MeasureType::mean, "robot.head_yaw"},
           {MeasureType::minimum, "robot.head_yaw"},
           {MeasureType::maximum, "robot.head_yaw"},
           {MeasureType::at_end, "robot.head_yaw"},
           {MeasureType::mean, "robot.may_walk"}});
  EXPECT_FALSE(measures_->values().at(0)) << "no frame yet";
  for (const double yaw : {0.5, -1.0, 2.0, 0.5}) {
    frame_.world.head.yaw = yaw;
    frame_.world.may_walk = yaw > 0.0;
    show();
  }
  EXPECT_DOUBLE_EQ(value(0), 0.5);
  EXPECT_EQ(value(1), -1.0);
  EXPECT_EQ(value(2), 2.0);
  EXPECT_EQ(value(3), 0.5);
  EXPECT_EQ(value(4), 0.75);
  frame_.world.head.yaw = std::numeric_limits<double>::infinity();
  show();
  EXPECT_FALSE(measures_->values().at(3)) << "a number that is not finite";
}

TEST(MeasureRow, SummarizesTheTrialsThatHaveAValue) {
  std::vector<TrialResult> results(4);
  results[0].measures = {1.0, std::nullopt};
  results[1].measures = {3.0, std::nullopt};
  results[2].measures = {std::nullopt, 7.0};
  const std::vector<MeasureRow> rows = measure_rows_of(results);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].trials, 2);
  EXPECT_EQ(rows[0].mean, 2.0);
  EXPECT_EQ(rows[0].least, 1.0);
  EXPECT_EQ(rows[0].most, 3.0);
  ASSERT_TRUE(rows[0].interval);
  EXPECT_LE(rows[0].interval->low, 2.0);
  EXPECT_EQ(rows[1].mean, 7.0);
  EXPECT_FALSE(rows[1].interval);
}

/// A TOML table does not store the order of its parameters.
std::vector<std::string> sorted_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::sort(lines.begin(), lines.end());
  return lines;
}

TEST(ResolvedText, IsReadAsTheSameCells) {
  const std::string text = std::string(kMeasured) + R"([[alternate]]
seconds = 30.5
[[axis]]
name = "mode"
description = "how the \"robot\" decides"
[[axis.choice]]
name = "slow"
conditions = ["shared"]
parameters.orientation.hold_time = 3.0
[[axis.choice]]
name = "none"
description = "it decides nothing"
room_awareness = false
with = ["a", "b"]
params = ["paper"]
)";
  const auto conditions = [](const std::string& name) {
    return parse_condition("width = 160\nwith = [\"c\"]\nparameters.trial.event = \"kidnap\"\n", name);
  };
  const Experiment experiment = parse_experiment(text, "some/where.toml", conditions);
  const std::string resolved = resolved_text(experiment);
  EXPECT_EQ(resolved.find("shared"), std::string::npos) << resolved;
  const Experiment again = parse_experiment(resolved, "some/where.toml");
  const std::vector<Cell> before = cells_of(experiment), after = cells_of(again);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].choices, after[i].choices);
    EXPECT_EQ(sorted_lines(as_text(before[i].condition)), sorted_lines(as_text(after[i].condition)));
  }
  EXPECT_EQ(again.axes[0].description, "how the \"robot\" decides");
  EXPECT_EQ(again.axes[0].choices[1].description, "it decides nothing");
  EXPECT_EQ(again.alternates.size(), 1u);
  EXPECT_EQ(resolved_text(again), resolved);
}

TEST(ResolvedText, ShowsWhatTheCommandLineSets) {
  Experiment experiment = measured(kMeasured);
  experiment.overrides.width = 160;
  experiment.overrides.parameters = {{"orientation.hold_time", "3.0", {}, ""}};
  const std::string text = resolved_text(experiment);
  EXPECT_NE(text.find("# width = 160\n# parameters.orientation.hold_time = 3.0\n"), std::string::npos) << text;
  EXPECT_EQ(cells_of(experiment).at(0).condition.width, 160);
}

}  // namespace
}  // namespace reorient
