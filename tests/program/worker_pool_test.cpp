// SPDX-License-Identifier: MIT
// Tasks in separate processes.
#include "program/experiment/worker_pool.h"

#include <csignal>
#include <cstdlib>
#include <map>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class WorkerPool : public ::testing::Test {
 protected:
  std::map<int, TaskEnd> run(int tasks, int jobs, const std::function<void(int)>& work) {
    std::vector<int> numbers(static_cast<std::size_t>(tasks));
    std::iota(numbers.begin(), numbers.end(), 1);
    std::map<int, TaskEnd> ends;
    run_in_processes(
        numbers, jobs, work,
        [&](const TaskEnd& end) {
          EXPECT_TRUE(ends.emplace(end.number, end).second) << end.number << " ended twice";
          return static_cast<int>(ends.size()) < enough;
        },
        [&] { return false; });
    return ends;
  }
  bool was_done(int task) const { return std::filesystem::exists(folder.path() / std::to_string(task)); }
  void note(int task) const { folder.write(std::to_string(task), std::to_string(getpid())); }

  TemporaryFolder folder;
  int enough = 1'000'000;
};

TEST_F(WorkerPool, RunsEachTaskOnceInOtherProcesses) {
  const auto ends = run(20, 3, [&](int task) { note(task); });
  EXPECT_EQ(ends.size(), 20U);
  for (const auto& [number, end] : ends) {
    EXPECT_TRUE(end.is_done());
    EXPECT_TRUE(was_done(number));
  }
}

TEST_F(WorkerPool, ReportsExceptionsAndContinues) {
  const auto ends = run(5, 2, [&](int task) {
    if (task == 2) throw std::runtime_error("there is no such room");
    note(task);
  });
  EXPECT_EQ(ends.size(), 5U);
  EXPECT_EQ(ends.at(2).mistake, "there is no such room");
  EXPECT_TRUE(ends.at(5).is_done());
}

TEST_F(WorkerPool, LosesOnlyTheTaskThatCrashes) {
  const auto ends = run(8, 2, [&](int task) {
    if (task == 3) raise(SIGKILL);
    if (task == 4) raise(SIGTERM);
    if (task == 5) _exit(7);
    note(task);
  });
  EXPECT_EQ(ends.size(), 8U);
  EXPECT_EQ(ends.at(3).signal, SIGKILL);
  EXPECT_EQ(ends.at(4).signal, SIGTERM);
  EXPECT_EQ(ends.at(5).mistake, "its process ended");
  for (const int number : {1, 2, 6, 7, 8}) EXPECT_TRUE(ends.at(number).is_done() && was_done(number)) << number;
}

TEST_F(WorkerPool, EndsAtOnceWhenTheCallbackReturnsFalse) {
  enough = 1;
  const auto ends = run(3, 3, [&](int task) {
    if (task != 1) pause();
  });
  EXPECT_EQ(ends.size(), 1U) << "two tasks waited without end, and were ended";
}

TEST_F(WorkerPool, EndsOnRequest) {
  int asked = 0;
  run_in_processes(
      {1, 2}, 2, [](int) { pause(); }, [](const TaskEnd&) { return true; }, [&] { return ++asked > 2; });
  EXPECT_EQ(asked, 3);
}

TEST_F(WorkerPool, WithoutTasksIsDone) {
  EXPECT_TRUE(run(0, 4, [](int) { std::abort(); }).empty());
}

}  // namespace
}  // namespace reorient
