// SPDX-License-Identifier: MIT
// Limits of a scripted test in time, because work in C++ is not counted as instructions of the script.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace reorient {

class TestBudget {
 public:
  /// The budget of a file. `timeout`: wall-clock time of one test, s. `stop` may be empty: no interrupt.
  TestBudget(double timeout, std::function<bool()> stop);
  /// The budget of one test, within that of its file.
  explicit TestBudget(TestBudget& file);

  void spend(double robot_seconds);
  double robot_seconds_left() const;  ///< the smaller one of test and file; not negative

  bool exceeded() const { return is_interrupted() || is_late() || robot_seconds_left() <= 0.0; }
  bool is_interrupted() const { return stop_ && stop_(); }
  /// The exceeded limit as text.
  std::string reason() const;

  static constexpr double kRobotSeconds = 36000.0;  ///< for one test
  static constexpr double kTestsOfAFile = 10.0;     ///< ratio of the limits of a file and of a test

 private:
  using Clock = std::chrono::steady_clock;

  bool is_late() const { return Clock::now() >= deadline_ || (file_ != nullptr && file_->is_late()); }

  double timeout_;
  double robot_seconds_;
  double left_ = robot_seconds_;
  Clock::time_point deadline_;
  std::function<bool()> stop_;
  TestBudget* file_ = nullptr;
};

}  // namespace reorient
