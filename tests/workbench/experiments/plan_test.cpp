// SPDX-License-Identifier: MIT
// An experiment as a list of trials.
#include "workbench/experiments/plan/plan.h"

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

/// Two rooms, three modes.
Experiment two_by_three() {
  Experiment experiment;
  experiment.name = "tried";
  experiment.trials = 4;
  for (const char* axis : {"room", "mode"}) {
    experiment.axes.push_back({axis, {}});
    for (const char* choice : {"a", "b", "c"}) experiment.axes.back().choices.push_back({choice, {}});
  }
  experiment.axes[0].choices.pop_back();
  return experiment;
}

std::string refused(const std::string& list) {
  try {
    numbers_in(list, 70);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Plan, NumbersTheTrialsCellByCell) {
  const std::vector<Task> tasks = tasks_of(two_by_three(), 10);
  ASSERT_EQ(tasks.size(), 24U);
  EXPECT_EQ(tasks.front().number, 1);
  EXPECT_EQ(tasks.back().number, 24);
  EXPECT_EQ(tasks[3].cell, 0U);
  EXPECT_EQ(tasks[4].cell, 1U);
  EXPECT_EQ(tasks[4].trial, 0);
}

TEST(Plan, ComparesCellsOnTheSameSeeds) {
  for (const Task& task : tasks_of(two_by_three(), 10)) EXPECT_EQ(task.seed, 10U + static_cast<unsigned>(task.trial));
}

TEST(Plan, RefusesTooManyTrials) {
  Experiment experiment = two_by_three();
  experiment.trials = 1'000'000;
  EXPECT_THROW(tasks_of(experiment, 1), std::runtime_error);
}

TEST(Plan, TrialsTakeTurnsWithTheAlternates) {
  Experiment experiment = two_by_three();
  experiment.base.scenario = "a";
  experiment.alternates.resize(2);
  experiment.alternates[1].scenario = "b";
  const std::vector<Cell> cells = cells_of(experiment);
  std::string scenarios;
  for (const Task& task : tasks_of(experiment, 1)) {
    if (task.cell == 1) scenarios += condition_of(experiment, cells[1], task).scenario;
  }
  EXPECT_EQ(scenarios, "abab");
}

TEST(TaskNumbers, AreASortedListWithoutRepetitions) {
  EXPECT_EQ(numbers_in("17", 70), std::vector<int>{17});
  EXPECT_EQ(numbers_in("68-70,1,3-4,4", 70), (std::vector<int>{1, 3, 4, 68, 69, 70}));
}

TEST(TaskNumbers, OutOfRangeOrInvalidAreRefusedInOneLine) {
  EXPECT_EQ(refused("71"), "unknown task 71 (expected 1 to 70)");
  EXPECT_EQ(refused("0"), "unknown task 0 (expected 1 to 70)");
  EXPECT_EQ(refused("-3"), "unknown task -3 (expected 1 to 70)");
  EXPECT_EQ(refused("99999999999999999999"), "unknown task 99999999999999999999 (expected 1 to 70)");
  EXPECT_EQ(refused("4-2"), "expected a range whose start is before its end, found '4-2'; write 2-4");
  for (const char* list : {"", ",", "1,", "1-", "a", "1 2", "1-2-3", "1.5", "+1"})
    EXPECT_NE(refused(list).find("expected a list of tasks, as in 17, 1-64 or 1-64,70, found '"), std::string::npos)
        << list;
}

RC_GTEST_PROP(TaskNumbersProperty, NeverLeaveTheirRange, (const std::string& list)) {
  try {
    for (const int number : numbers_in(list, 9)) RC_ASSERT(number >= 1 && number <= 9);
  } catch (const std::runtime_error&) {
  }
}

}  // namespace
}  // namespace reorient
