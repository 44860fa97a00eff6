// How long frames take in wall-clock time. Nothing of it enters a decision, a record or the digest.
#pragma once

#include <chrono>
#include <vector>

#include "robots/robot.h"

namespace reorient {

/// Of some number of frames, in s; all zero where there were none.
struct TimeQuantiles {
  double median = 0.0;
  double percentile_99 = 0.0;  ///< 99 of 100 frames were no longer
  double longest = 0.0;
};
TimeQuantiles quantiles(std::vector<double> seconds);

/// A robot that measures how long it takes to observe: for a simulated one, to render.
class TimedRobot : public Robot {
 public:
  /// `robot` must outlive it.
  explicit TimedRobot(Robot& robot) : robot_(robot) {}

  const RobotDimensions& dimensions() const override { return robot_.dimensions(); }
  bool observe(Observation& observation) override {
    const auto start = std::chrono::steady_clock::now();
    const bool more = robot_.observe(observation);
    observing_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return more;
  }
  void request(const Request& request) override { robot_.request(request); }
  std::optional<GroundTruth> ground_truth() const override { return robot_.ground_truth(); }

  /// s that the last observe() took
  double observing() const { return observing_; }

 private:
  Robot& robot_;
  double observing_ = 0.0;
};

/// What a run's frames took.
class FrameTimes {
 public:
  /// s of one whole frame, from before the robot observes until after its scripts were reloaded, and the part of it in
  /// which the robot observed.
  void add(double whole, double observing) {
    whole_.push_back(whole);
    own_.push_back(whole - observing);
  }

  TimeQuantiles whole() const { return quantiles(whole_); }
  TimeQuantiles without_observing() const { return quantiles(own_); }

 private:
  std::vector<double> whole_;
  std::vector<double> own_;
};

}  // namespace reorient
