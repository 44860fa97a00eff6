// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/test_budget.h"

#include <algorithm>
#include <utility>

#include "engine/parameters/parameter.h"

namespace reorient {
namespace {

std::chrono::steady_clock::duration ticks(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

TestBudget::TestBudget(double timeout, std::function<bool()> stop)
    : timeout_(timeout),
      robot_seconds_(kTestsOfAFile * kRobotSeconds),
      deadline_(Clock::now() + ticks(kTestsOfAFile * timeout)),
      stop_(std::move(stop)) {}

TestBudget::TestBudget(TestBudget& file)
    : timeout_(file.timeout_),
      robot_seconds_(kRobotSeconds),
      deadline_(Clock::now() + ticks(file.timeout_)),
      stop_(file.stop_),
      file_(&file) {}

void TestBudget::spend(double robot_seconds) {
  left_ -= robot_seconds;
  if (file_ != nullptr) file_->spend(robot_seconds);
}

double TestBudget::robot_seconds_left() const {
  const double left = std::max(0.0, left_);
  return file_ == nullptr ? left : std::min(left, file_->robot_seconds_left());
}

std::string TestBudget::reason() const {
  if (is_interrupted()) return "interrupted";
  if (file_ != nullptr && (file_->is_late() || file_->left_ <= 0.0)) return file_->reason();
  const std::string what = file_ == nullptr ? "the file's tests" : "the test";
  if (is_late()) {
    const double seconds = file_ == nullptr ? kTestsOfAFile * timeout_ : timeout_;
    return what + " took more than " + to_text(seconds) + " s; --timeout SECONDS gives each test more";
  }
  return what + " took more than " + to_text(robot_seconds_) + " s of the robot's time";
}

}  // namespace reorient
