// SPDX-License-Identifier: MIT
#include "program/game/worker_team.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

TEST(WorkerTeam, DoesEachItemOnce) {
  for (const int threads : {1, 2, 5}) {
    WorkerTeam team(threads);
    std::vector<std::atomic<int>> done(23);
    for (int round = 1; round <= 50; ++round) {
      team.run(done.size(), [&](std::size_t item) { ++done[item]; });
      for (const std::atomic<int>& count : done) ASSERT_EQ(count, round) << threads;
    }
  }
}

TEST(WorkerTeam, MayHaveNothingToDo) {
  WorkerTeam team(3);
  team.run(0, [](std::size_t) { FAIL(); });
}

TEST(WorkerTeam, ThrowsTheExceptionOfAnItemAndContinues) {
  WorkerTeam team(2);
  std::atomic<int> done = 0;
  const auto fail_at_three = [&](std::size_t item) {
    if (item == 3) throw std::runtime_error("item 3");
    ++done;
  };
  EXPECT_THROW(team.run(8, fail_at_three), std::runtime_error);
  EXPECT_EQ(done, 7) << "the other items were done";
  team.run(3, fail_at_three);
  EXPECT_EQ(done, 10);
}

}  // namespace
}  // namespace reorient
