// SPDX-License-Identifier: MIT
// Limits of a scripted test: work in C++ costs its script no instructions, but time.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace reorient {

class TestBudget {
 public:
  /// A file's: `timeout` is a test's, s in wall-clock time. `stop` may be empty: then no interrupt.
  TestBudget(double timeout, std::function<bool()> stop);
  /// One test's, within its file's.
  explicit TestBudget(TestBudget& file);

  void spend(double robot_seconds);
  double robot_seconds_left() const;  ///< of the test or of the file, whichever is less; not negative

  bool exceeded() const { return is_interrupted() || is_late() || robot_seconds_left() <= 0.0; }
  bool is_interrupted() const { return stop_ && stop_(); }
  /// The exceeded limit as text.
  std::string reason() const;

  static constexpr double kRobotSeconds = 36000.0;  ///< of one test
  static constexpr double kTestsOfAFile = 10.0;     ///< a file has this many times what a test has

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
