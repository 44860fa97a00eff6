// SPDX-License-Identifier: MIT
// The shipped experiments in a few seconds each: every cell can be run, and reaches the state from which it is
// measured.
#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "program/experiment/trial_runner.h"
#include "tests/paths.h"
#include "workbench/experiments/condition/experiment_file.h"
#include "workbench/experiments/plan/plan.h"

namespace reorient {
namespace {

const std::filesystem::path kSource = kSourceFolder;

Experiment shipped(const std::string& name) {
  return read_experiment(kSource / "assets/experiments" / (name + ".toml"), [](const std::string& condition) {
    return read_condition(kSource / "assets/conditions" / (condition + ".toml"));
  });
}

/// Shortens all durations.
Condition shortened(Condition condition) {
  condition.width = 160;
  condition.seconds = 20.0;
  condition.measurement.limit = 1.0;
  condition.measurement.hold = 0.5;
  for (const char* name : {"trial.learn", "mirrored_placement.learn", "kidnapped.learn", "fallen.learn",
                           "elsewhere.learn", "learned_mirrored.learn", "side_trial.learn"})
    condition.parameters.push_back({name, "2", ParameterOrigin::file, "this test"});
  for (const char* name : {"trial.wait_least", "trial.wait_most"})
    condition.parameters.push_back({name, "0", ParameterOrigin::file, "this test"});
  condition.parameters.push_back({"trial.penalty", "1", ParameterOrigin::file, "this test"});
  condition.learned_before = std::min(condition.learned_before, 3.0);
  for (std::string& file : condition.parameter_files) {
    std::filesystem::path named = kSource / "assets/parameters" / file;
    file = (named += ".toml").string();
  }
  return condition;
}

/// The event of a condition: the parameter trial.event for the scenario `trial`, what side_trial.mirrored means for
/// `side_trial`, otherwise the scenario's name.
std::string event_of(const Condition& condition) {
  std::string event = condition.scenario;
  for (const ParameterChange& change : condition.parameters) {
    if (change.name == "trial.event") event = change.value;
    if (change.name == "side_trial.mirrored") event = change.value == "true" ? "mirrored_placement" : "put_back";
  }
  return event;
}

class ShippedExperiment : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedExperiment, ReachesTheStateFromWhichItIsMeasured) {
  Experiment experiment = shipped(GetParam());
  experiment.trials = 2;
  RoomCache rooms;
  const std::vector<Cell> cells = cells_of(experiment);
  for (const Task& task : tasks_of(experiment, 1)) {
    const Cell& cell = cells[task.cell];
    std::string name = GetParam();
    for (const std::string& choice : cell.choices) name.append(", ").append(choice);
    SCOPED_TRACE(name + ", seed " + std::to_string(task.seed));
    const Condition condition = shortened(condition_of(experiment, cell, task));
    const TrialResult result = run_trial(condition, task.seed, kSource / "scripts", rooms);
    EXPECT_TRUE(result.started);
    EXPECT_GT(result.seconds, 0.5);
    const std::string event = event_of(condition);
    // A penalized robot returns beside the field, which is rarely the place where it was removed.
    const bool is_carried =
        event == "mirrored_placement" || event == "kidnapped" || event == "penalized" || event == "elsewhere";
    EXPECT_EQ(result.displaced, is_carried) << event;
    if (event == "none" || event == "mirrored_placement" || event == "misled") {
      EXPECT_EQ(result.correct_at_start, event == "none");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedExperiment,
                         ::testing::Values("table1", "orientation", "false_flips", "symmetric", "symmetry_ladder",
                                           "symmetry_mark", "another_day", "bodies", "disturbances", "elsewhere",
                                           "companions", "stress", "ablation", "filters", "gaze", "learned_mirrored",
                                           "localization", "paper_thresholds", "peers", "peers_failures",
                                           "mirrored_placement", "side", "walls"),
                         [](const auto& one) { return std::string(one.param); });

TEST(ARoomLearnedOnAnotherDay, ShowsAWrongBeliefAtOnce) {
  const Experiment experiment = shipped("another_day");
  const Cell cell = cells_of(experiment).at(0);
  RoomCache rooms;
  for (const double learned : {0.0, 20.0}) {
    Condition condition = shortened(condition_of(experiment, cell, Task{}));
    condition.learned_before = learned;
    condition.parameters.push_back({"trial.learn", "0", ParameterOrigin::file, "this test"});
    condition.measurement.limit = 6.0;
    condition.measurement.hold = 3.0;
    const TrialResult result = run_trial(condition, 1, kSource / "scripts", rooms);
    EXPECT_FALSE(result.correct_at_start);
    EXPECT_EQ(result.failed(), learned == 0.0);
    EXPECT_EQ(run_trial(condition, 1, kSource / "scripts", rooms).right_after, result.right_after);
  }
}

std::vector<std::string> choices_of(const Experiment& experiment, const std::string& axis) {
  std::vector<std::string> names;
  for (const Axis& one : experiment.axes) {
    if (one.name != axis) continue;
    for (const AxisChoice& choice : one.choices) names.push_back(choice.name);
  }
  return names;
}

/// The last value that a condition sets; empty: it sets none.
std::string value_of(const Condition& condition, const std::string& parameter) {
  std::string value;
  for (const ParameterChange& change : condition.parameters) {
    if (change.name == parameter) value = change.value;
  }
  return value;
}

/// Each choice of `axis` sets `parameter` to `scale` times its number, and only the choice called `symmetric` is
/// exactly symmetric.
void expect_rungs(const Experiment& experiment, std::size_t axis, const std::string& parameter, double scale,
                  const std::string& symmetric) {
  for (const Cell& cell : cells_of(experiment)) {
    const std::string& choice = cell.choices[axis];
    EXPECT_EQ(value_of(cell.condition, "room_shape.symmetry"), "two_fold");
    EXPECT_DOUBLE_EQ(std::stod(value_of(cell.condition, parameter)), scale * std::stod(choice)) << choice;
    EXPECT_EQ(cell.condition.measurement.symmetric_room, choice == symmetric) << choice;
    EXPECT_EQ(value_of(cell.condition, "evidence.use_separability"), "") << "the guard as shipped";
    int mirrored = 0, others = 0;
    for (int trial = 0; trial < experiment.trials; ++trial) {
      const std::string event = event_of(condition_of(experiment, cell, {0, 0, trial, 1}));
      ++(event == "mirrored_placement" ? mirrored : others);
    }
    EXPECT_EQ(mirrored, others);
  }
}

TEST(SymmetryLadder, StepsFromAsymmetricToExactlySymmetric) {
  const Experiment experiment = shipped("symmetry_ladder");
  EXPECT_EQ(choices_of(experiment, "color"), (std::vector<std::string>{"1", "0.3", "0.1", "0"}));
  EXPECT_EQ(choices_of(experiment, "strength"), (std::vector<std::string>{"0 %", "10 %", "20 %", "30 %", "40 %", "50 %",
                                                                          "60 %", "70 %", "80 %", "90 %", "100 %"}));
  EXPECT_EQ(cells_of(experiment).size(), 44u);
  expect_rungs(experiment, 2, "room_shape.symmetry_strength", 0.01, "100 %");
}

TEST(SymmetryMark, StepsDownToNoBanner) {
  const Experiment experiment = shipped("symmetry_mark");
  EXPECT_EQ(choices_of(experiment, "mark"),
            (std::vector<std::string>{"6 m", "3 m", "1.5 m", "0.75 m", "0.4 m", "0 m"}));
  EXPECT_EQ(cells_of(experiment).size(), 24u);
  expect_rungs(experiment, 2, "room_shape.mark", 1.0, "0 m");
}

TEST(GuardAgainstSymmetricRooms, IsCompletelyOffInTheChoiceOff) {
  for (const char* name : {"symmetry_ladder", "symmetry_mark"}) {
    Experiment experiment = shipped(name);
    choose(experiment, "guard", {"off"}, {});
    for (const Cell& cell : cells_of(experiment)) {
      EXPECT_EQ(value_of(cell.condition, "evidence.use_separability"), "false");
      EXPECT_EQ(value_of(cell.condition, "room_status.separability"), "0");
      EXPECT_EQ(value_of(cell.condition, "background_training.separability"), "0");
    }
  }
}

TEST(ShippedExperiments, AreAllCoveredByTheTestAbove) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "assets/experiments"))
    names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"ablation",      "another_day",      "bodies",       "companions",
                                             "disturbances",  "elsewhere",        "false_flips",  "filters",
                                             "gaze",          "learned_mirrored", "localization", "mirrored_placement",
                                             "orientation",   "paper_thresholds", "peers",        "peers_failures",
                                             "side",          "stress",           "symmetric",    "symmetry_ladder",
                                             "symmetry_mark", "table1",           "walls"}));
}

}  // namespace
}  // namespace reorient
